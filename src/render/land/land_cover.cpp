#include "render/land/land_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/find_named.h"
#include "measure/network/flow_routing.h"
#include "numerics/smooth_step.h"

namespace fumon {

namespace {

constexpr double least_rock_slope = 0.35;
constexpr double most_rock_slope = 0.62;
constexpr double steepest_share = 1.0 / 12.0;
constexpr double least_slope = 0.01;       // of the wetness index
constexpr double dry_share = 0.15;         // of the land, drier than which nothing counts
constexpr double wet_share = 0.97;         // wetter than which likewise
constexpr double snow_band_share = 0.06;   // of the relief, over which snow sets in
constexpr double shady_snow_share = 0.10;  // of the relief, by which it lies lower in shade
constexpr double full_shade_slope = 0.4;
constexpr double grows_to = 0.1;  // m of water, under which plants grow
constexpr double bare_from = 0.3;

/// The value that a share of others falls below.
double value_at(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(255.0 * std::clamp(share, 0.0, 1.0) + 0.5);
}

struct GroundSlope {
    double east = 0.0;
    double north = 0.0;
};

/// By central differences; at edges and beside cells without data by those there are.
GroundSlope slope_of(const Grid& ground, const Mask& nodata, int x, int y, double dx, double dy) {
    const auto known = [&](int u, int v) {
        return u >= 0 && v >= 0 && u < ground.nx() && v < ground.ny() &&
               (nodata.empty() || nodata(u, v) == 0);
    };
    const auto along = [&](int u, int v, double length) {
        const bool up = known(x + u, y + v);
        const bool down = known(x - u, y - v);
        const double high = up ? ground(x + u, y + v) : ground(x, y);
        const double low = down ? ground(x - u, y - v) : ground(x, y);
        return up || down ? (high - low) / (length * ((up ? 1 : 0) + (down ? 1 : 0))) : 0.0;
    };
    return {along(1, 0, dx), along(0, 1, dy)};
}

/// A mean over some cells of those that are land, three times along both axes: single ways of water
/// show the directions of the grid.
Grid softened(Grid field, const Mask& nodata) {
    constexpr int passes = 3;
    const int nx = field.nx();
    const int ny = field.ny();
    const auto mean_along = [&](const Grid& from, int x, int y, int u, int v) {
        constexpr std::array<double, 5> weights{1.0, 4.0, 6.0, 4.0, 1.0};
        double sum = 0.0;
        double weight = 0.0;
        for (int k = -2; k <= 2; ++k) {
            const int at_x = x + k * u;
            const int at_y = y + k * v;
            if (at_x < 0 || at_y < 0 || at_x >= nx || at_y >= ny) continue;
            if (!nodata.empty() && nodata(at_x, at_y) != 0) continue;
            const double share = weights.at(static_cast<std::size_t>(k + 2));
            sum += share * from(at_x, at_y);
            weight += share;
        }
        return weight > 0.0 ? sum / weight : from(x, y);
    };
    for (int pass = 0; pass < passes; ++pass) {
        Grid across(nx, ny);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) across(x, y) = mean_along(field, x, y, 1, 0);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) field(x, y) = mean_along(across, x, y, 0, 1);
    }
    return field;
}

}  // namespace

Field<CellCover> land_cover(const Snapshot& snapshot, std::optional<double> snow_line) {
    const Grid ground = ground_of(snapshot);
    const Mask& nodata = snapshot.nodata;
    const int nx = ground.nx();
    const int ny = ground.ny();
    const auto is_land = [&](std::size_t i) { return nodata.empty() || nodata.values()[i] == 0; };
    const Grid area = drainage_area(route_flow(snapshot));
    Grid steep(nx, ny);
    Grid shade(nx, ny);
    Grid wetness(nx, ny);
    std::vector<double> steeps;
    std::vector<double> wetnesses;
    double low = 1e300;
    double high = -1e300;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (!nodata.empty() && nodata(x, y) != 0) continue;
            const GroundSlope slope =
                slope_of(ground, nodata, x, y, snapshot.scale.dx, snapshot.scale.dy);
            steep(x, y) = std::sqrt(slope.east * slope.east + slope.north * slope.north);
            shade(x, y) = std::clamp(-slope.north / full_shade_slope, -1.0, 1.0);
            wetness(x, y) = elementary::log(area(x, y) / snapshot.scale.dx /
                                            std::max(steep(x, y), least_slope));
            steeps.push_back(steep(x, y));
            low = std::min(low, ground(x, y));
            high = std::max(high, ground(x, y));
        }
    }
    wetness = softened(std::move(wetness), nodata);
    for (std::size_t i = 0; i < wetness.size(); ++i)
        if (is_land(i)) wetnesses.push_back(wetness.values()[i]);
    const double rock_from =
        std::clamp(value_at(steeps, 1.0 - steepest_share), least_rock_slope, most_rock_slope);
    const double dry = value_at(wetnesses, dry_share);
    const double wet = std::max(value_at(wetnesses, wet_share), dry + 1e-6);
    const double relief = std::max(high - low, 1e-6);
    const SnapshotField* water = find_named(snapshot.fields, "water_depth");
    const auto above_water = [&](std::size_t i) {
        if (water == nullptr) return 1.0;
        return 1.0 - smooth_step(grows_to, bare_from, water->values.values()[i]);
    };
    Field<CellCover> cover(nx, ny);
    for (std::size_t i = 0; i < cover.size(); ++i) {
        if (!is_land(i)) continue;
        const double s = steep.values()[i];
        const double north = shade.values()[i];
        const double damp = std::clamp((wetness.values()[i] - dry) / (wet - dry), 0.0, 1.0);
        CellCover& cell = cover.values()[i];
        const double uncovered = above_water(i);
        cell.rock = byte_of(uncovered * smooth_step(0.8 * rock_from, 1.3 * rock_from, s));
        cell.green = byte_of(0.15 + 0.75 * damp + 0.35 * north);
        cell.grass = byte_of(uncovered * (0.45 + 0.6 * damp + 0.30 * north) *
                             (1.0 - smooth_step(0.7 * rock_from, 1.2 * rock_from, s)));
        if (!snow_line) continue;
        const double above = ground.values()[i] - *snow_line + shady_snow_share * relief * north;
        const double band = snow_band_share * relief;
        cell.snow =
            byte_of(uncovered * smooth_step(-band, band, above) * (1.0 - smooth_step(0.8, 1.4, s)));
    }
    return cover;
}

}  // namespace fumon
