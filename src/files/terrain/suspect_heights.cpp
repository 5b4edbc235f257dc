#include "files/terrain/suspect_heights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/error.h"
#include "base/limits.h"

namespace fumon {

namespace {

constexpr double beyond_all_ground = 3e4;   // m; the highest mountain known, on Mars, has 22 km
constexpr double far_from_others = 1000.0;  // m
constexpr std::array<double, 8> customary{-9999.0, 9999.0,  -32768.0, -32767.0,
                                          32767.0, 65535.0, -99999.0, 99999.0};

/// Cells of one kind, and the first of them.
struct Found {
    std::int64_t cells = 0;
    std::size_t first = 0;

    void add(std::size_t cell) {
        if (cells++ == 0) first = cell;
    }
};

}  // namespace

std::string suspect_heights(const Terrain& terrain, const std::string& file) {
    const auto heights = terrain.heights.values();
    std::array<double, customary.size()> suspects = customary;  // in metres
    for (double& suspect : suspects) suspect *= terrain.metres_per_number;
    const auto is_suspect = [&](double height) {
        return std::ranges::any_of(suspects, [&](double suspect) {
            return std::abs(height - suspect) <= 1e-9 * std::abs(suspect);
        });
    };
    const double smallest_suspect = 9999.0 * (1.0 - 1e-9) * std::abs(terrain.metres_per_number);
    const double usual = std::min(beyond_all_ground, smallest_suspect);
    if (std::ranges::all_of(heights, [&](double height) { return std::abs(height) < usual; }))
        return {};

    const auto has_data = [&](std::size_t cell) {
        return terrain.nodata.empty() || terrain.nodata.values()[cell] == 0;
    };
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        const double height = heights[cell];
        if (!has_data(cell) || std::abs(height) >= beyond_all_ground || is_suspect(height))
            continue;
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
    }
    Found beyond;
    Found strange;
    for (std::size_t cell = 0; cell < heights.size(); ++cell) {
        if (!has_data(cell)) continue;
        const double height = heights[cell];
        if (!(std::abs(height) <= largest_height)) beyond.add(cell);
        const bool far = lowest - height > far_from_others || height - highest > far_from_others;
        if (std::abs(height) >= beyond_all_ground ||
            (is_suspect(height) && far && lowest <= highest))
            strange.add(cell);
    }
    const auto nx = static_cast<std::size_t>(terrain.heights.nx());
    const auto where = [&](const Found& found) {
        return fmt::format("the first {:.12g} m at cell ({}, {})", heights[found.first],
                           found.first % nx, found.first / nx);
    };
    // As the file has it, to the last digit, so that it can be copied.
    const auto remedy = [&](const Found& found) {
        double number = heights[found.first] / terrain.metres_per_number;
        const auto* known = std::ranges::find_if(
            customary, [&](double value) { return std::abs(number / value - 1.0) <= 1e-9; });
        if (known != customary.end()) number = *known;
        return fmt::format("bed.nodata_value = {}", number);
    };
    if (beyond.cells > 0) {
        throw InputError(fmt::format(
            "{}: {} of {} cells have heights beyond ±{:g} m, {}; if they mean missing data, write "
            "{}; if they are in another unit, write bed.height_unit",
            file, beyond.cells, heights.size(), largest_height, where(beyond), remedy(beyond)));
    }
    if (strange.cells == 0) return {};
    return fmt::format(
        "{} of {} cells have implausible heights, {}: if they mean missing data, write {}",
        strange.cells, heights.size(), where(strange), remedy(strange));
}

}  // namespace fumon
