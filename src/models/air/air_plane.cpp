#include "models/air/air_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"

namespace fumon {

namespace {

bool is_level(const Grid& bed) {
    const auto heights = bed.values();
    return std::all_of(heights.begin(), heights.end(),
                       [&](double height) { return height == heights.front(); });
}

std::vector<double> cosine_bed(const AirflowParameters& parameters, const ModelSetup& setup) {
    const int nx = setup.bed.nx();
    const double amplitude = parameters.bed_amplitude * metres_per_millimetre;
    const auto waves = static_cast<double>(parameters.bed_waves);
    const double steepness = 2.0 * std::numbers::pi * waves * amplitude / (nx * setup.scale.dx);
    if (steepness > 1.0) {
        throw KeyError("model.bed_amplitude",
                       fmt::format("{} wave(s) of {:.4g} mm over {:.4g} mm are as steep as {:.3g}; "
                                   "the bed's staircase takes at most 1 (Terada 2025, eq. 27)",
                                   parameters.bed_waves, parameters.bed_amplitude,
                                   nx * setup.scale.dx / metres_per_millimetre, steepness));
    }
    std::vector<double> heights;
    for (int i = 0; i < nx; ++i) {
        const auto turn = static_cast<double>((parameters.bed_waves * i) % nx) / nx;
        heights.push_back(amplitude * (elementary::cos(2.0 * std::numbers::pi * turn) + 1.0));
    }
    return heights;
}

std::vector<double> given_bed(const AirflowParameters& parameters, const ModelSetup& setup) {
    if (!setup.nodata.empty()) {
        throw KeyError("bed.file",
                       "the bed has cells without data, over which no air can flow; write "
                       "bed.nodata = \"fill\" or give them a height");
    }
    if (parameters.bed_row >= setup.bed.ny()) {
        throw KeyError("model.bed_row",
                       fmt::format("model.bed_row is {}, but the bed has rows 0 to {}",
                                   parameters.bed_row, setup.bed.ny() - 1));
    }
    const auto row = setup.bed.row(static_cast<int>(parameters.bed_row));
    const double lowest = *std::min_element(row.begin(), row.end());
    std::vector<double> heights;
    for (const double height : row) heights.push_back((height - lowest) * setup.scale.height_unit);
    return heights;
}

void check_grid(const ModelSetup& setup) {
    constexpr int fewest_columns = 4;
    if (setup.bed.nx() < fewest_columns) {
        throw KeyError("grid.nx", fmt::format("grid.nx is {}; air takes at least {} columns",
                                              setup.bed.nx(), fewest_columns));
    }
}

void check_room(const AirPlane& plane) {
    constexpr int least_room = 2;
    const int highest = *std::max_element(plane.under_bed.begin(), plane.under_bed.end());
    if (highest + least_room >= plane.nz) {
        throw KeyError("model.nz", fmt::format("model.nz is {}, but the bed reaches up to cell {}; "
                                               "take {} or more",
                                               plane.nz, highest, highest + least_room + 1));
    }
}

void check_stairs(const AirPlane& plane) {
    for (int i = 0; i < plane.nx; ++i) {
        const auto here = static_cast<std::size_t>(i);
        const auto next = static_cast<std::size_t>(plane.right(i));
        if (std::abs(plane.under_bed[here] - plane.under_bed[next]) <= 1) continue;
        throw KeyError(
            "bed.kind",
            fmt::format("the bed rises by {:.4g} m over the {:.4g} m from column {} to "
                        "{}; its staircase takes slopes up to 1 (Terada 2025, eq. 27)",
                        plane.height[next] - plane.height[here], plane.spacing, i, next));
    }
}

}  // namespace

AirPlane make_air_plane(const AirflowParameters& parameters, const ModelSetup& setup) {
    check_grid(setup);
    const bool cosine =
        parameters.bed == AirBedShape::cosine ||
        (parameters.bed == AirBedShape::automatic && setup.nodata.empty() && is_level(setup.bed));
    AirPlane plane;
    plane.nx = setup.bed.nx();
    plane.nz = static_cast<int>(parameters.nz);
    plane.spacing = setup.scale.dx;
    plane.height = cosine ? cosine_bed(parameters, setup) : given_bed(parameters, setup);
    plane.largest_height = *std::max_element(plane.height.begin(), plane.height.end());
    const double lid = plane.nz * plane.spacing;
    if (!(plane.largest_height < lid)) {
        throw KeyError("model.nz", fmt::format("the bed is {:.4g} m high and the lid at {:.4g} m; "
                                               "take a larger model.nz, or a lower bed",
                                               plane.largest_height, lid));
    }
    for (const double height : plane.height) {
        plane.under_bed.push_back(
            static_cast<int>(std::floor(height / plane.spacing + on_bed_tolerance)));
    }
    check_room(plane);
    check_stairs(plane);
    return plane;
}

}  // namespace fumon
