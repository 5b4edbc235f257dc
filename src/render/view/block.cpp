#include "render/view/block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/compensated_sum.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr double terrain_smoothness = 0.5;  // neighbours' correlation that tells terrain from noise
constexpr double wanted_relief = 0.12;      // of the longer side: reads as relief at 30° elevation
constexpr double wanted_carving = 0.04;     // for what water is still to carve
constexpr std::array<double, 11> steps = {1, 1.5, 2, 3, 5, 10, 15, 20, 30, 50, 100};
constexpr std::array<double, 4> flattening = {0.1, 0.2, 0.3, 0.5};  // of heights without a unit

constexpr double growth_of_noise = 0.05;  // of the longer side: dunes of 5 sites on 100
constexpr double growth_of_terrain = 0.01;
constexpr double depths_carved = 10.0;    // channels cut a film's bed this many depths deep
constexpr double deepest_carving = 0.05;  // of the longer side: room kept for it
constexpr double thickness = 0.055;       // of the block under its lowest place, in longer sides
constexpr double lowest_sand = -0.5;      // model heights; the sand models dip to about −0.1

constexpr double least_mountain = 150.0;  // metres of relief: higher than dunes usually are
constexpr double full_mountain = 450.0;

constexpr double steepest_shown = 1.0;  // the tangent of 45°

/// As the sheet of air over a strip is framed: no higher than this share of the longer side.
constexpr double highest_air = 0.35;

/// The height of a section's top in metres, 0 without one.
double air_height(const Snapshot& snapshot) {
    if (!snapshot.section || snapshot.section->fields.empty()) return 0.0;
    return (snapshot.section->fields.front().values.ny() - 1) * snapshot.section->dz;
}

double longer_side(const Snapshot& snapshot) {
    return std::max(snapshot.bed.nx() * snapshot.scale.dx, snapshot.bed.ny() * snapshot.scale.dy);
}

std::vector<glm::dvec2> outline_of(const Snapshot& snapshot, const Block& block) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    const auto corner = [&](int x, int y) {
        return glm::dvec2((static_cast<double>(x) / nx - 0.5) * block.width_x,
                          (static_cast<double>(y) / ny - 0.5) * block.width_y);
    };
    std::vector<glm::dvec2> outline;
    for (int y = 0; y < ny && !snapshot.nodata.empty(); ++y) {
        const auto row = snapshot.nodata.row(y);
        const auto first = std::find(row.begin(), row.end(), std::uint8_t{0});
        if (first == row.end()) continue;
        const auto last = std::find(row.rbegin(), row.rend(), std::uint8_t{0});
        const auto west = static_cast<int>(first - row.begin());
        const auto east = static_cast<int>(row.rend() - last);
        for (const int x : {west, east}) {
            outline.push_back(corner(x, y));
            outline.push_back(corner(x, y + 1));
        }
    }
    if (outline.empty()) outline = {corner(0, 0), corner(nx, 0), corner(0, ny), corner(nx, ny)};
    return outline;
}

/// The relief in metres that a snapshot's water is expected to carve, 0 without water.
double carved_relief(const Snapshot& first) {
    return depths_carved * water_statistics(first).high_depth;
}

bool is_terrain(const HeightStatistics& heights) {
    return heights.smoothness >= terrain_smoothness;
}

/// The tangent of the slope that so many per cent of the cells stay below, by central differences
/// where both neighbours are there.
double steep_slope(const Snapshot& snapshot, std::size_t percent = 99) {
    const Grid& bed = snapshot.bed;
    const auto inside = [&](int x, int y) {
        return x >= 0 && x < bed.nx() && y >= 0 && y < bed.ny() &&
               (snapshot.nodata.empty() || snapshot.nodata(x, y) == 0);
    };
    const auto rise = [&](int x, int y, int east, int north, double distance) {
        const bool before = inside(x - east, y - north);
        const bool after = inside(x + east, y + north);
        if (!before && !after) return 0.0;
        const double low = before ? bed(x - east, y - north) : bed(x, y);
        const double high = after ? bed(x + east, y + north) : bed(x, y);
        const double distances = before && after ? 2.0 * distance : distance;
        return (high - low) * snapshot.scale.height_unit / distances;
    };
    std::vector<double> squares;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (!inside(x, y)) continue;
            const double eastward = rise(x, y, 1, 0, snapshot.scale.dx);
            const double northward = rise(x, y, 0, 1, snapshot.scale.dy);
            squares.push_back(eastward * eastward + northward * northward);
        }
    }
    if (squares.empty()) return 0.0;
    const auto position = static_cast<std::ptrdiff_t>(squares.size() * percent / 100);
    std::nth_element(squares.begin(), squares.begin() + position, squares.end());
    return std::sqrt(squares[static_cast<std::size_t>(position)]);
}

}  // namespace

HeightStatistics height_statistics(const Grid& bed, const Mask& nodata) {
    HeightStatistics result{std::numeric_limits<double>::max(),
                            std::numeric_limits<double>::lowest(), 0.0, 0.0};
    CompensatedSum sum;  // which is that of a periodic bed wherever it begins
    std::size_t count = 0;
    const auto inside = [&](int x, int y) { return nodata.empty() || nodata(x, y) == 0; };
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (!inside(x, y)) continue;
            result.low = std::min(result.low, bed(x, y));
            result.high = std::max(result.high, bed(x, y));
            sum.add(bed(x, y));
            ++count;
        }
    }
    if (count == 0) return {};
    result.mean = sum.value() / static_cast<double>(count);
    double variance = 0.0;
    double covariance = 0.0;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x + 1 < bed.nx(); ++x) {
            if (!inside(x, y) || !inside(x + 1, y)) continue;
            const double here = bed(x, y) - result.mean;
            const double next = bed(x + 1, y) - result.mean;
            covariance += here * next;
            variance += 0.5 * (here * here + next * next);
        }
    }
    if (variance > 0.0) result.smoothness = covariance / variance;
    return result;
}

double relief_exaggeration(const Snapshot& first) {
    if (!first.scale.in_metres) return 1.0;
    const HeightStatistics heights = height_statistics(first.bed, first.nodata);
    const double carved = carved_relief(first);
    const bool terrain = is_terrain(heights);
    if (!terrain && carved == 0.0) return 1.0;
    const double relief = std::max((heights.high - heights.low) * first.scale.height_unit, carved);
    const double wanted = terrain ? wanted_relief : wanted_carving;
    const double air = air_height(first) - heights.low * first.scale.height_unit;
    double chosen = steps.front();
    for (const double step : steps) {
        if (air_height(first) > 0.0 && air * step > highest_air * longer_side(first)) break;
        chosen = step;
        if (relief * step >= wanted * longer_side(first)) break;
    }
    return chosen;
}

double automatic_exaggeration(const Snapshot& first) {
    const double shown = relief_exaggeration(first);
    if (shown == steps.front() || first.section ||
        !is_terrain(height_statistics(first.bed, first.nodata)))
        return shown;
    const double slope = steep_slope(first);
    double chosen = steps.front();
    for (const double step : steps) {
        if (step <= shown && step * slope <= steepest_shown) chosen = step;
    }
    return chosen;
}

double figure_exaggeration(const Snapshot& snapshot) {
    if (snapshot.section || carved_relief(snapshot) > 0.0) return automatic_exaggeration(snapshot);
    const HeightStatistics heights = height_statistics(snapshot.bed, snapshot.nodata);
    const double relief = (heights.high - heights.low) * snapshot.scale.height_unit;
    if (!(relief > 0.0)) return 1.0;
    // Grain by grain piles are rough, which is no slope of theirs.
    const double slope = steep_slope(snapshot, snapshot.scale.in_metres ? 99 : 90);
    const double wanted = wanted_relief * longer_side(snapshot);
    double chosen = snapshot.scale.in_metres ? steps.front() : flattening.front();
    const auto try_step = [&](double step) {
        if (chosen * relief < wanted && step * slope <= steepest_shown) chosen = step;
    };
    if (!snapshot.scale.in_metres) std::ranges::for_each(flattening, try_step);
    std::ranges::for_each(steps, try_step);
    return chosen;
}

Block frame_block(const Snapshot& first, double exaggeration, const WordOrReal& room,
                  const WordOrReal& footing) {
    const HeightStatistics heights = height_statistics(first.bed, first.nodata);
    Block block;
    block.side = longer_side(first);
    if (first.scale.in_metres) block.kilometres = 1e-3 * block.side;
    block.width_x = first.bed.nx() * first.scale.dx / block.side;
    block.width_y = first.bed.ny() * first.scale.dy / block.side;
    block.outline = outline_of(first, block);
    block.exaggeration = exaggeration;
    block.reference = heights.mean;
    block.height_scale = first.scale.height_unit * exaggeration / block.side;
    block.surface = 0.0;
    const bool terrain = is_terrain(heights);
    const double carved = carved_relief(first) / first.scale.height_unit;
    const double lacking = std::max(carved - (heights.high - heights.low), 0.0);
    double lowest = heights.low - std::min(0.5 * lacking, deepest_carving / block.height_scale);
    if (!terrain && carved == 0.0) lowest = std::min(lowest, lowest_sand);
    const double longer_thickness = std::min(thickness, std::min(block.width_x, block.width_y));
    block.base = block.z(lowest) - longer_thickness;
    if (!footing.is_word()) block.base = block.z(heights.low - footing.value);
    block.top = block.z(heights.high) + (terrain ? growth_of_terrain : growth_of_noise);
    block.top = std::max(block.top, block.z(first.highest_expected));
    if (!room.is_word()) block.top = block.z(heights.high + room.value);
    if (first.section)
        block.top = std::max(block.top, block.z(air_height(first) / first.scale.height_unit));
    if (terrain && first.scale.in_metres) {
        const double relief = (heights.high - heights.low) * first.scale.height_unit;
        block.rock =
            std::clamp((relief - least_mountain) / (full_mountain - least_mountain), 0.0, 1.0);
    }
    return block;
}

}  // namespace fumon
