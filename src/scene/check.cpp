#include "scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/limits.h"
#include "files/terrain/terrain_format.h"
#include "models/registry.h"
#include "scene/figure_check.h"
#include "scene/initial_bed.h"
#include "scene/placed_sun.h"
#include "scene/scene.h"
#include "scene/view/palette_names.h"

namespace fumon {

namespace {

bool written(const Scene& scene, const std::string& key) {
    return scene.locations.contains(key);
}

/// Adds faults located at a key.
struct Refuse {
    const Scene& scene;
    Faults& faults;
    void operator()(const std::string& key, const std::string& what) const {
        faults.add(InputError(scene.at(key) + what));
    }
};

/// What chooses a part of a terrain file and its cells.
void check_raster_keys(const Scene& scene, bool from_file, const Refuse& refuse) {
    const BedSettings& bed = scene.bed;
    const auto belongs_to_file = [&](const char* key, bool given) {
        if (from_file || !given) return;
        refuse(key,
               fmt::format("{} belongs to a terrain file; write bed.kind = \"file\" and bed.file",
                           key));
    };
    belongs_to_file("bed.band", bed.band != 0);
    belongs_to_file("bed.record", bed.record != 0);
    belongs_to_file("bed.height_unit", !bed.height_unit.empty());
    belongs_to_file("bed.height_factor", bed.height_factor != 1.0);
    belongs_to_file("bed.height_sign", bed.height_sign != HeightSign::automatic);
    belongs_to_file("bed.window", !bed.window.empty());
    belongs_to_file("bed.smooth_terraces", bed.smooth_terraces);
    belongs_to_file("bed.crs", !bed.crs.empty());
    belongs_to_file("bed.resample", bed.resample != 0.0);
    if (!bed.window.empty() && bed.window.size() != 4) {
        refuse("bed.window",
               fmt::format("bed.window has {} number{}; it takes [west, south, east, north]",
                           bed.window.size(), bed.window.size() == 1 ? "" : "s"));
    }
    if (bed.window.size() == 4 && !(bed.window[0] < bed.window[2] && bed.window[1] < bed.window[3]))
        refuse(
            "bed.window",
            "bed.window must have west < east and south < north; write [west, south, east, north]");
}

void check_bed_formats(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const std::vector<std::string>& names = scene.output.bed_format;
    if (names.empty())
        refuse("output.bed_format",
               fmt::format("output.bed_format is empty; take {}", written_terrain_formats()));
    for (std::size_t k = 0; k < names.size(); ++k) {
        const TerrainFormat* format = find_written_format(names[k]);
        if (format == nullptr) {
            refuse("output.bed_format", fmt::format("output.bed_format has \"{}\"; it takes {}",
                                                    names[k], written_terrain_formats()));
            continue;
        }
        if (const std::string missing = format->missing(); !missing.empty())
            refuse("output.bed_format", fmt::format("\"{}\" {}", names[k], missing));
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(k), names[k]) !=
            names.begin() + static_cast<std::ptrdiff_t>(k))
            refuse("output.bed_format",
                   fmt::format("output.bed_format has \"{}\" twice", names[k]));
    }
}

void check_bed(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const BedSettings& bed = scene.bed;
    const bool from_file = bed_kind(scene) == BedKind::file;
    if (from_file && bed.file.empty())
        refuse("bed.kind", "bed.file is missing; name the terrain file");
    if (!from_file && !bed.file.empty()) {
        refuse("bed.file",
               "bed.file is given but not used; write bed.kind = \"file\" to start from it");
    }
    if (!from_file && !bed.heights.empty()) {
        refuse("bed.heights", "bed.heights belongs to a PNG bed; noise takes bed.low and bed.high");
    }
    if (!from_file && !bed.variable.empty()) {
        refuse("bed.variable",
               "bed.variable belongs to a NetCDF bed; write bed.kind = \"file\" and bed.file");
    }
    if (!from_file && !bed.nodata_value.is_word()) {
        refuse(
            "bed.nodata_value",
            "bed.nodata_value belongs to a terrain file; write bed.kind = \"file\" and bed.file");
    }
    if (!from_file && bed.refine != 1) {
        refuse("bed.refine",
               "bed.refine belongs to a terrain file; elsewhere take larger grid.nx and grid.ny");
    }
    const bool is_heap = bed_kind(scene) == BedKind::heap;
    if (is_heap && bed.heap_radius == 0.0)
        refuse("bed.kind", "bed.heap_radius is missing; write how far the heap reaches");
    if (!is_heap && bed.heap_radius != 0.0)
        refuse("bed.heap_radius",
               "bed.heap_radius belongs to a heap; write bed.kind = \"heap\" and bed.height");
    check_raster_keys(scene, from_file, refuse);
    if (bed.heights.size() == 1)
        refuse("bed.heights", "bed.heights has one number; it takes [low, high]");
    if (bed.heights.size() == 2 && !(bed.heights[0] < bed.heights[1])) {
        refuse("bed.heights",
               "bed.heights must rise; write [low, high], the heights of black and white");
    }
    if (bed_kind(scene) == BedKind::noise && bed.low > bed.high) {
        refuse(written(scene, "bed.high") ? "bed.high" : "bed.low",
               fmt::format("bed.high ({}) is below bed.low ({}); noise is uniform in [low, high)",
                           bed.high, bed.low));
    }
    if (!from_file && scene.grid.nx * scene.grid.ny > largest_grid_cells) {
        refuse(written(scene, "grid.ny") ? "grid.ny" : "grid.nx",
               fmt::format("{} x {} cells are too many; at most {} in all", scene.grid.nx,
                           scene.grid.ny, largest_grid_cells));
    }
}

void check_frames(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const FrameSettings& frames = scene.frames;
    const int ways =
        (frames.every > 0 ? 1 : 0) + (frames.at.empty() ? 0 : 1) + (frames.logarithmic > 0 ? 1 : 0);
    if (ways > 1) {
        const char* second = frames.logarithmic > 0 ? "frames.logarithmic" : "frames.at";
        refuse(second,
               "frames are chosen more than once; keep one of frames.every, frames.at, "
               "frames.logarithmic");
    }
    const auto within_run = [&](const std::vector<std::int64_t>& steps, const std::string& key) {
        const auto late = std::find_if(steps.begin(), steps.end(),
                                       [&](std::int64_t step) { return step > scene.run.steps; });
        if (late == steps.end()) return;
        refuse(key, fmt::format("{} names step {}, after the run's end at {}; lengthen "
                                "run.steps or drop it",
                                key, *late, scene.run.steps));
    };
    within_run(frames.at, "frames.at");
    within_run(scene.output.bed_at, "output.bed_at");
    within_run(scene.output.fields_at, "output.fields_at");
}

void check_camera(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const CameraSettings& camera = scene.view.camera;
    const bool perspective = camera.projection == Projection::perspective;
    const auto check_place = [&](const char* key, const std::vector<double>& place) {
        if (place.empty()) return;
        if (place.size() != 3) {
            refuse(key, fmt::format("{} has {} number{}; it takes [east, north, above the bed]",
                                    key, place.size(), place.size() == 1 ? "" : "s"));
        } else if (!perspective) {
            refuse(key, fmt::format("{} belongs to camera.projection = \"perspective\"", key));
        }
    };
    check_place("camera.at", camera.at);
    check_place("camera.look_at", camera.look_at);
    if (camera.framing != Framing::block) {
        if (!perspective)
            refuse("camera.framing",
                   "camera.framing belongs to camera.projection = \"perspective\"");
        const auto check_alone = [&](const char* key, const std::vector<double>& place) {
            // Resolved scenes list all keys.
            if (place.empty()) return;
            refuse(
                key,
                fmt::format(
                    "{} and camera.framing both set the camera's position; keep one of them", key));
        };
        check_alone("camera.at", camera.at);
        check_alone("camera.look_at", camera.look_at);
    }
    if (!camera.focal_length.is_word() && written(scene, "camera.field_of_view") &&
        camera.field_of_view != CameraSettings{}.field_of_view)
        refuse(
            "camera.focal_length",
            "camera.focal_length and camera.field_of_view set the same quantity; keep one of them");
    if (scene.view.look.ground != Ground::endless) return;
    if (scene.view.look.background == Background::transparent)
        refuse("look.background",
               "look.background = \"transparent\" takes look.ground = \"table\": endless ground "
               "leaves nothing transparent");
    if (!perspective)
        refuse("look.ground",
               "look.ground = \"endless\" takes camera.projection = \"perspective\"");
    if (scene.view.look.mode != ViewMode::scenic)
        refuse("look.ground", "look.ground = \"endless\" takes look.mode = \"scenic\"");
    if (scene.view.look.draws_contours())
        refuse("look.contours", "look.contours are drawn over look.ground = \"table\" only");
}

void check_lens(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const CameraSettings& camera = scene.view.camera;
    const WordOrReal& samples = camera.lens_samples;
    if (!samples.is_word() && samples.value != std::floor(samples.value))
        refuse("camera.lens_samples",
               fmt::format("camera.lens_samples is {:g}; it takes a whole number", samples.value));
    if (!camera.has_lens()) {
        for (const char* key : {"camera.focus", "camera.lens_samples"}) {
            const WordOrReal& value =
                key == std::string_view("camera.focus") ? camera.focus : samples;
            if (!value.is_word())
                refuse(key, fmt::format("{} belongs to a lens; write camera.f_number or "
                                        "camera.aperture",
                                        key));
        }
        return;
    }
    const char* lens = camera.f_number.is_word() ? "camera.aperture" : "camera.f_number";
    if (!camera.f_number.is_word() && camera.aperture > 0.0)
        refuse("camera.aperture",
               "camera.f_number and camera.aperture set the same quantity; keep one of them");
    if (camera.projection != Projection::perspective)
        refuse(lens, fmt::format("{} belongs to camera.projection = \"perspective\"", lens));
    if (scene.view.look.mode != ViewMode::scenic)
        refuse(lens, fmt::format("{} belongs to look.mode = \"scenic\"", lens));
}

void check_look(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const LookSettings& look = scene.view.look;
    const bool by_field =
        look.colour_by == Colouring::field || look.colour_by == Colouring::field_change;
    if (by_field && look.field.empty())
        refuse("look.colour_by", "look.colour_by = \"field\" needs look.field, the field's name");
    if (!look.low.is_word() && !look.high.is_word() && !(look.low.value < look.high.value)) {
        refuse("look.high", fmt::format("look.high ({}) must be above look.low ({})",
                                        look.high.value, look.low.value));
    }
    try {
        check_palette_name(look.palette);
    } catch (const InputError& unknown) {
        faults.add(placed(scene.at("look.palette"), unknown));
    }
    if (scene.view.image.supersampling == 3) {
        refuse("image.supersampling", "image.supersampling is 3; it takes 1, 2 or 4");
    }
}

void check_layer_data(const LayerSettings& layer,
                      const std::function<std::string(const char*)>& key, const Refuse& refuse) {
    if (layer.data == LayerData::file) {
        if (layer.file.empty()) {
            refuse(key("file"),
                   fmt::format("{} is missing; name a GeoJSON, GeoPackage or shapefile, or say "
                               "{} = \"contours\", \"streams\" or \"gauges\"",
                               key("file"), key("data")));
        }
        return;
    }
    const auto of_files = [&](const char* name, const std::string& text) {
        if (text.empty()) return;
        refuse(key(name), fmt::format("{} belongs to {} = \"file\"", key(name), key("data")));
    };
    of_files("file", layer.file);
    of_files("name", layer.name);
    of_files("where", layer.where);
    const char* field = layer.data == LayerData::contours  ? "height"
                        : layer.data == LayerData::streams ? "order"
                                                           : "name";
    if (!layer.label.empty() && layer.label != field) {
        refuse(key("label"), fmt::format("{} is \"{}\"; this layer has the label \"{}\" alone",
                                         key("label"), layer.label, field));
    }
}

void check_layers(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    for (std::size_t n = 0; n < scene.view.layers.size(); ++n) {
        const LayerSettings& layer = scene.view.layers[n];
        const auto key = [n](const char* name) { return fmt::format("layer.{}.{}", n, name); };
        const auto check_colour = [&](const char* name, const std::string& colour) {
            if (layer_colour(colour)) return;
            refuse(key(name), fmt::format("{} is \"{}\"; it takes a colour as \"#b5651d\": two "
                                          "hexadecimal digits each of red, green and blue",
                                          key(name), colour));
        };
        check_layer_data(layer, key, refuse);
        check_colour("colour", layer.colour);
        if (!layer.fill.empty()) check_colour("fill", layer.fill);
        const bool some =
            std::ranges::any_of(layer.dash, [](double length) { return length > 0.0; });
        if (!layer.dash.empty() && !some)
            refuse(key("dash"),
                   key("dash") + " has no length above 0; write [6, 4], or leave it out");
    }
}

void check_streamers(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const View& view = scene.view;
    if (view.streamers.strength == 0.0) return;
    const char* key = "streamers.strength";
    if (view.look.mode != ViewMode::scenic)
        refuse(key, "streamers.strength is for scenic views (look.mode)");
    if (view.camera.projection != Projection::perspective)
        refuse(key, "streamers.strength is for the perspective camera (camera.projection)");
    if (view.look.background == Background::transparent)
        refuse(key,
               "streamers.strength takes look.background = \"surroundings\": blown sand needs a "
               "background to be seen against");
}

void check_clouds(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    const View& view = scene.view;
    if (view.air.clouds == Clouds::none) return;
    if (view.look.sky == SkyModel::two_colours || view.look.sky == SkyModel::overcast)
        refuse("air.clouds", "air.clouds need look.sky = \"atmosphere\" or \"auto\"");
    if (view.air.clouds == Clouds::cumulus && view.air.planet != Planet::earth)
        refuse("air.clouds",
               "air.clouds = \"cumulus\" need the Earth's air; thin air takes \"cirrus\"");
}

void check_length(const Scene& scene, Faults& faults) {
    const Refuse refuse{scene, faults};
    if (find_model(scene.model.name)->landform == Landform::terrain || written(scene, "run.steps"))
        return;
    refuse("run.steps",
           "run.steps is missing; set the length of the run, for example [run] steps = 1000");
}

/// Some rules, and the sections that they read.
struct Rules {
    std::vector<const char*> sections;
    void (*check)(const Scene& scene, Faults& faults);
};

}  // namespace

void check_scene(const Scene& scene, const std::set<std::string>& faulty, Faults& faults) {
    const std::array all{Rules{{"run"}, check_length},
                         Rules{{"grid", "bed"}, check_bed},
                         Rules{{"output"}, check_bed_formats},
                         Rules{{"frames", "run", "output"}, check_frames},
                         Rules{{"look", "image"}, check_look},
                         Rules{{"camera", "look"}, check_camera},
                         Rules{{"camera", "look"}, check_lens},
                         Rules{{"streamers", "look", "camera"}, check_streamers},
                         Rules{{"sun", "air"}, check_sun},
                         Rules{{"layer"}, check_layers},
                         Rules{{"figure"}, check_figure},
                         Rules{{"air", "look"}, check_clouds}};
    for (const Rules& rules : all) {
        const bool sound =
            std::none_of(rules.sections.begin(), rules.sections.end(),
                         [&](const char* section) { return faulty.contains(section); });
        if (sound) rules.check(scene, faults);
    }
}

}  // namespace fumon
