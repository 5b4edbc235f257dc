#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/worker_pool.h"
#include "models/registry.h"
#include "run/run_checkpoint.h"
#include "scene/initial_bed.h"
#include "scene/read.h"

namespace fumon::fuzz {

/// A small model of the n-th kind, on which a checkpoint's state can be put.
inline std::unique_ptr<Model> small_model(std::size_t kind) {
    const ModelEntry& entry = models()[kind % models().size()];
    const bool on_profile = entry.home.on_profile;
    const std::string low_bed = on_profile ? "nz = 10\nbed_amplitude = 0.02\n" : "";
    const std::string rows = on_profile ? "1" : "6";
    const Scene scene =
        parse_scene("[model]\nname = \"" + std::string(entry.name) + "\"\n" + low_bed +
                        "[grid]\nnx = 8\nny = " + rows + "\n[run]\nsteps = 8\n",
                    "scene.toml", "");
    static WorkerPool pool(1, "fuzz");
    const InitialBed initial = make_initial_bed(scene);
    return entry.make(scene.model.parameters,
                      {initial.bed, initial.nodata, initial.scale, 1, pool, false});
}

}  // namespace fumon::fuzz
