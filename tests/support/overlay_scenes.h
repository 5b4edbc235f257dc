#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/image.h"
#include "measure/measured_rows.h"
#include "scene/overlay_keys.h"
#include "scene/read.h"
#include "support/view_beds.h"

namespace fumon {

/// A scene with overlays, coloured by height unless `more` (TOML) says otherwise.
inline Scene scene_of(const std::string& overlays, int width, int height,
                      const std::string& more = "") {
    Scene scene = parse_scene(
        fmt::format("title = \"Dunes of a test\"\n[model]\nname = \"sand\"\ncreep_rate = 0.2\n"
                    "[run]\nsteps = 1200\n[image]\nwidth = {}\nheight = {}\n"
                    "[look]\ncolour_by = \"height\"\n{}\n{}",
                    width, height, more, overlays),
        "test.toml", "");
    name_parameter_keys(scene);
    return scene;
}

/// One [[overlay]].
inline std::string overlay(const std::string& kind, const std::string& corner,
                           const std::string& more = "") {
    return fmt::format("[[overlay]]\nkind = \"{}\"\ncorner = \"{}\"\n{}\n", kind, corner, more);
}

/// A wavy bed; `cell` in metres, or 0 without metres.
inline Snapshot overlay_bed(int nx, int ny, double cell) {
    Snapshot snapshot = wavy_bed(nx, ny);
    snapshot.time_unit = "steps";
    if (cell > 0.0) snapshot.scale = {cell, cell, 1.0, true};
    return snapshot;
}

/// So many rows of a wavelength that grows.
inline MeasuredRows rows_up_to(int count) {
    MeasuredRows rows{{{{"step", "", ""}, {}},
                       {{"time", "steps", ""}, {}},
                       {{"wavelength_spectrum", "sites", ""}, {}}}};
    for (int i = 0; i < count; ++i) {
        rows.columns[0].values.push_back(10.0 * i);
        rows.columns[1].values.push_back(10.0 * i);
        rows.columns[2].values.push_back(3.0 + 0.5 * i);
    }
    return rows;
}

inline Image grey(int width, int height, std::uint8_t level = 150) {
    Image image(width, height);
    std::fill(image.rgb.begin(), image.rgb.end(), level);
    return image;
}

}  // namespace fumon
