#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "base/worker_pool.h"
#include "models/registry.h"
#include "run/run_checkpoint.h"
#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon::fuzz {

/// A scheme of a model: a small scene of it.
struct CheckpointKind {
    std::string_view name;
    std::string_view scene;
};

/// Every scheme whose state differs, by the number that is an input's first byte.
inline constexpr std::array<CheckpointKind, 15> checkpoint_kinds{{
    {"sand", "[model]\nname = \"sand\"\n[grid]\nnx = 8\nny = 6\n"},
    {"sand-profile", "[model]\nname = \"sand\"\ncreep = \"profile\"\n[grid]\nnx = 9\nny = 4\n"},
    {"sandpile", "[model]\nname = \"sandpile\"\n[grid]\nnx = 8\nny = 6\n"},
    {"sandpile-fifo",
     "[model]\nname = \"sandpile\"\norder = \"first-in-first-out\"\ndrop_x = [2, 5]\n"
     "drop_y = [3, 3]\ndrop_choice = \"random\"\n[grid]\nnx = 8\nny = 6\n"},
    {"gully-cip", "[model]\nname = \"gully\"\nscheme = \"cip\"\n[grid]\nnx = 8\nny = 6\n"},
    {"gully-cip-as-published",
     "[model]\nname = \"gully\"\nscheme = \"cip-as-published\"\nsubsteps = \"fixed\"\n"
     "time_step = 0.01\n[grid]\nnx = 8\nny = 6\n"},
    {"gully-finite-volume",
     "[model]\nname = \"gully\"\nscheme = \"finite-volume\"\n[grid]\nnx = 8\nny = 6\n"},
    {"gully-rain",
     "[model]\nname = \"gully\"\nscheme = \"finite-volume\"\nrain = 60\nedges_x = \"open\"\n"
     "edges_y = \"open\"\n[grid]\nnx = 8\nny = 6\n"},
    {"airflow", "[model]\nname = \"airflow\"\nnz = 10\nbed_amplitude = 0.02\n[grid]\nnx = 8\n"},
    {"airflow-second-order",
     "[model]\nname = \"airflow\"\nnz = 10\nbed_amplitude = 0.02\nadvection = \"second-order\"\n"
     "until_steady = true\n[grid]\nnx = 8\n"},
    {"airflow-boundary-fitted",
     "[model]\nname = \"airflow\"\nnz = 10\nbed_amplitude = 0.02\nscheme = \"boundary-fitted\"\n"
     "[grid]\nnx = 8\n"},
    {"static", "[model]\nname = \"static\"\n[grid]\nnx = 8\nny = 6\n"},
    {"dunes", "[model]\nname = \"dunes\"\n[grid]\nnx = 8\nny = 6\n"},
    {"dunes-slabs",
     "[model]\nname = \"dunes\"\ntransport = \"slabs\"\nspeed_up = \"height\"\nedges_x = "
     "\"open\"\n[grid]\nnx = 8\nny = "
     "6\n"},
    {"dunes-plants",
     "[model]\nname = \"dunes\"\nplants = \"grow\"\ngrass_cover = 0.4\nrock_wear = 0.01\n"
     "growth_period = 0.001\n[grid]\nnx = 8\nny = 6\n"},
}};

/// A model of the n-th kind, on which a checkpoint's state can be put.
inline std::unique_ptr<Model> small_model(std::size_t kind) {
    struct Start {
        Scene scene;
        InitialBed bed;
    };
    static std::map<std::string_view, Start> starts;
    const CheckpointKind& chosen = checkpoint_kinds.at(kind % checkpoint_kinds.size());
    auto start = starts.find(chosen.name);
    if (start == starts.end()) {
        const Scene scene =
            parse_scene(std::string(chosen.scene) + "[run]\nsteps = 8\n", "scene.toml", "");
        start = starts.emplace(chosen.name, Start{scene, make_initial_bed(scene)}).first;
    }
    static WorkerPool pool(1, "fuzz");
    const auto& [scene, initial] = start->second;
    return find_model(scene.model.name)
        ->make(scene.model.parameters,
               {initial.bed, initial.nodata, initial.scale, 1, pool, false});
}

}  // namespace fumon::fuzz
