#include "scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/limits.h"
#include "files/terrain/terrain_format.h"
#include "scene/check_figure.h"
#include "scene/initial_bed.h"

namespace fumon {

namespace {

[[noreturn]] void refuse(const Scene& scene, const std::string& key, const std::string& what) {
    throw InputError(scene.at(key) + what);
}

bool written(const Scene& scene, const std::string& key) {
    return scene.locations.contains(key);
}

/// What chooses a part of a terrain file and its cells.
void check_raster_keys(const Scene& scene, bool from_file) {
    const BedSettings& bed = scene.bed;
    const auto belongs_to_file = [&](const char* key, bool given) {
        if (from_file || !given) return;
        refuse(scene, key,
               fmt::format("{} belongs to a terrain file; write bed.kind = \"file\" and bed.file",
                           key));
    };
    belongs_to_file("bed.band", bed.band != 0);
    belongs_to_file("bed.window", !bed.window.empty());
    belongs_to_file("bed.resample", bed.resample != 0.0);
    if (!bed.window.empty() && bed.window.size() != 4) {
        refuse(scene, "bed.window",
               fmt::format("bed.window has {} number{}; it takes [west, south, east, north]",
                           bed.window.size(), bed.window.size() == 1 ? "" : "s"));
    }
    if (bed.window.size() == 4 && !(bed.window[0] < bed.window[2] && bed.window[1] < bed.window[3]))
        refuse(scene, "bed.window",
               "bed.window must rise both ways; write [west, south, east, north]");
}

void check_bed_formats(const Scene& scene) {
    const std::vector<std::string>& names = scene.output.bed_format;
    if (names.empty())
        refuse(scene, "output.bed_format",
               fmt::format("output.bed_format is empty; take {}", written_terrain_formats()));
    for (std::size_t k = 0; k < names.size(); ++k) {
        const TerrainFormat* format = find_written_format(names[k]);
        if (format == nullptr) {
            refuse(scene, "output.bed_format",
                   fmt::format("output.bed_format has \"{}\"; it takes {}", names[k],
                               written_terrain_formats()));
        }
        if (!format->lacks.empty()) {
            refuse(scene, "output.bed_format",
                   fmt::format("this fumon was built without \"{}\"; {}", names[k], format->lacks));
        }
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(k), names[k]) !=
            names.begin() + static_cast<std::ptrdiff_t>(k))
            refuse(scene, "output.bed_format",
                   fmt::format("output.bed_format has \"{}\" twice", names[k]));
    }
}

void check_bed(const Scene& scene) {
    const BedSettings& bed = scene.bed;
    const bool from_file = bed_kind(scene) == BedKind::file;
    if (from_file && bed.file.empty())
        refuse(scene, "bed.kind", "bed.file is missing; name the terrain file");
    if (!from_file && !bed.file.empty()) {
        refuse(scene, "bed.file",
               "bed.file is given but not used; write bed.kind = \"file\" to start from it");
    }
    if (!from_file && !bed.heights.empty()) {
        refuse(scene, "bed.heights",
               "bed.heights belongs to a PNG bed; noise takes bed.low and bed.high");
    }
    if (!from_file && !bed.variable.empty()) {
        refuse(scene, "bed.variable",
               "bed.variable belongs to a NetCDF bed; write bed.kind = \"file\" and bed.file");
    }
    if (!from_file && bed.refine != 1) {
        refuse(scene, "bed.refine",
               "bed.refine belongs to a terrain file; elsewhere take larger grid.nx and grid.ny");
    }
    check_raster_keys(scene, from_file);
    if (bed.heights.size() == 1)
        refuse(scene, "bed.heights", "bed.heights has one number; it takes [low, high]");
    if (bed.heights.size() == 2 && !(bed.heights[0] < bed.heights[1])) {
        refuse(scene, "bed.heights",
               "bed.heights must rise; write [low, high], the heights of black and white");
    }
    if (bed_kind(scene) == BedKind::noise && bed.low > bed.high) {
        refuse(scene, written(scene, "bed.high") ? "bed.high" : "bed.low",
               fmt::format("bed.high ({}) is below bed.low ({}); noise is uniform in [low, high)",
                           bed.high, bed.low));
    }
    if (!from_file && scene.grid.nx * scene.grid.ny > largest_grid_cells) {
        refuse(scene, written(scene, "grid.ny") ? "grid.ny" : "grid.nx",
               fmt::format("{} x {} cells are too many; at most {} in all", scene.grid.nx,
                           scene.grid.ny, largest_grid_cells));
    }
}

void check_frames(const Scene& scene) {
    const FrameSettings& frames = scene.frames;
    const int ways =
        (frames.every > 0 ? 1 : 0) + (frames.at.empty() ? 0 : 1) + (frames.logarithmic > 0 ? 1 : 0);
    if (ways > 1) {
        const char* second = frames.logarithmic > 0 ? "frames.logarithmic" : "frames.at";
        refuse(
            scene, second,
            "two ways to choose frames; keep one of frames.every, frames.at, frames.logarithmic");
    }
    const auto within_run = [&](const std::vector<std::int64_t>& steps, const std::string& key) {
        for (const std::int64_t step : steps) {
            if (step > scene.run.steps) {
                refuse(scene, key,
                       fmt::format("{} names step {}, after the run's end at {}; lengthen "
                                   "run.steps or drop it",
                                   key, step, scene.run.steps));
            }
        }
    };
    within_run(frames.at, "frames.at");
    within_run(scene.output.bed_at, "output.bed_at");
    within_run(scene.output.fields_at, "output.fields_at");
}

void check_look(const Scene& scene) {
    const LookSettings& look = scene.view.look;
    if (!look.low.is_word() && !look.high.is_word() && !(look.low.value < look.high.value)) {
        refuse(scene, "look.high",
               fmt::format("look.high ({}) must be above look.low ({})", look.high.value,
                           look.low.value));
    }
    if (scene.view.image.supersampling == 3) {
        refuse(scene, "image.supersampling", "image.supersampling is 3; it takes 1, 2 or 4");
    }
}

}  // namespace

void check_scene(const Scene& scene) {
    if (scene.model.name != "static" && !written(scene, "run.steps")) {
        refuse(scene, "run.steps",
               "run.steps is missing; say how long to run, for example [run] steps = 1000");
    }
    check_bed(scene);
    check_bed_formats(scene);
    check_frames(scene);
    check_look(scene);
    check_figure(scene);
}

}  // namespace fumon
