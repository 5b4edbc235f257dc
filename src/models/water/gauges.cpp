#include "models/water/gauges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

constexpr double pieces_a_cell = 16.0;  // of a line: the width of a cell is then known to 6 %

std::string key_of(std::size_t number, const char* key) {
    return fmt::format("gauge.{}.{}", number, key);
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string name_of(const GaugeSettings& gauge, std::size_t number, std::set<std::string>& taken) {
    std::string name = gauge.name.empty() ? fmt::format("gauge_{}", number + 1) : gauge.name;
    const bool fits = is_letter(name.front()) && std::ranges::all_of(name, [](char c) {
                          return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
                      });
    if (!fits) {
        throw KeyError(key_of(number, "name"),
                       fmt::format("\"{}\" begins names of columns; it takes a letter, then "
                                   "letters, digits and underscores",
                                   name));
    }
    if (!taken.insert(name).second) {
        throw KeyError(key_of(number, "name"),
                       fmt::format("two gauges are called \"{}\"; each needs its own name", name));
    }
    return name;
}

/// A place as metres from the grid's south-west corner.
std::array<double, 2> place_in_grid(const GaugeSettings& gauge, std::size_t number, const char* key,
                                    const std::vector<double>& place, const WorldScale& scale) {
    if (place.size() != 2) throw KeyError(key_of(number, key), "write [x, y]");
    if (gauge.coordinates == GaugeCoordinates::grid) return {place[0], place[1]};
    if (!scale.place) {
        throw KeyError(key_of(number, "coordinates"),
                       "the bed lies nowhere on a map; take \"grid\", metres from its south-west "
                       "corner");
    }
    const GeoReference& map = *scale.place;
    return {(place[0] - map.west) / map.dx * scale.dx, (place[1] - map.south) / map.dy * scale.dy};
}

}  // namespace

Gauges::Gauges(const GullyParameters& parameters, const WaterDomain& domain,
               const WorldScale& scale, int nx, int ny)
    : domain_(domain) {
    std::set<std::string> taken;
    for (std::size_t n = 0; n < parameters.gauges.size(); ++n) {
        const GaugeSettings& settings = parameters.gauges[n];
        Gauge gauge{name_of(settings, n, taken), 0, 0, {}};
        const bool at_side = settings.side != GaugeSide::none;
        if (at_side != settings.at.empty()) {
            throw KeyError(key_of(n, at_side ? "side" : "at"),
                           "a gauge stands at a point or line, or at a side: give gauge.at or "
                           "gauge.side");
        }
        const auto locate = [&](const char* key, const std::vector<double>& place) {
            const auto metres = place_in_grid(settings, n, key, place, scale);
            if (metres[0] >= 0.0 && metres[0] < domain.dx * nx && metres[1] >= 0.0 &&
                metres[1] < domain.dy * ny)
                return metres;
            throw KeyError(
                key_of(n, key),
                fmt::format("({:g}, {:g}) is {:.6g} m east and {:.6g} m north of the grid's "
                            "south-west corner; the grid is {:g} m by {:g} m",
                            place[0], place[1], metres[0], metres[1], domain.dx * nx,
                            domain.dy * ny));
        };
        if (at_side) {
            gauge.crossings = over(settings.side, nx, ny);
            if (gauge.crossings.empty())
                throw KeyError(key_of(n, "side"), "no cell along that side has data");
            gauges_.push_back(std::move(gauge));
            continue;
        }
        const auto at = locate("at", settings.at);
        if (settings.to.empty()) {
            gauge.x = static_cast<int>(at[0] / domain.dx);
            gauge.y = static_cast<int>(at[1] / domain.dy);
            if (!domain.nodata.empty() && domain.nodata(gauge.x, gauge.y) != 0)
                throw KeyError(key_of(n, "at"), "there is no data there; choose another place");
        } else {
            const auto to = locate("to", settings.to);
            gauge.crossings = along(nx, ny, at[0], at[1], to[0], to[1]);
            if (gauge.crossings.empty())
                throw KeyError(key_of(n, "to"), "the line has no length, or no data along it");
        }
        gauges_.push_back(std::move(gauge));
    }
}

std::vector<Gauges::Crossing> Gauges::along(int nx, int ny, double from_x, double from_y,
                                            double to_x, double to_y) const {
    const double way_x = to_x - from_x;
    const double way_y = to_y - from_y;
    const double length = std::sqrt(way_x * way_x + way_y * way_y);
    const double pieces = std::ceil(pieces_a_cell * length / std::min(domain_.dx, domain_.dy));
    std::vector<Crossing> crossings;
    for (double piece = 0.0; piece < pieces; ++piece) {
        const double share = (piece + 0.5) / pieces;
        const int x = std::min(static_cast<int>((from_x + share * way_x) / domain_.dx), nx - 1);
        const int y = std::min(static_cast<int>((from_y + share * way_y) / domain_.dy), ny - 1);
        if (!domain_.nodata.empty() && domain_.nodata(x, y) != 0) continue;
        if (crossings.empty() || crossings.back().x != x || crossings.back().y != y)
            crossings.push_back({x, y, 0.0, 0.0});
        crossings.back().width_x -= way_y / pieces;
        crossings.back().width_y += way_x / pieces;
    }
    return crossings;
}

std::vector<Gauges::Crossing> Gauges::over(GaugeSide side, int nx, int ny) const {
    const bool across_x = side == GaugeSide::west || side == GaugeSide::east;
    const bool outward = side == GaugeSide::east || side == GaugeSide::north;
    const int cells = across_x ? ny : nx;
    std::vector<Crossing> crossings;
    for (int cell = 0; cell < cells; ++cell) {
        const int x = across_x ? (outward ? nx - 1 : 0) : cell;
        const int y = across_x ? cell : (outward ? ny - 1 : 0);
        if (!domain_.nodata.empty() && domain_.nodata(x, y) != 0) continue;
        const double width = (across_x ? domain_.dy : domain_.dx) * (outward ? 1.0 : -1.0);
        crossings.push_back({x, y, across_x ? width : 0.0, across_x ? 0.0 : width});
    }
    return crossings;
}

std::vector<SnapshotNumber> Gauges::read(const Water& water, const Grid& bed) const {
    std::vector<SnapshotNumber> numbers;
    for (const Gauge& gauge : gauges_) {
        if (gauge.crossings.empty()) {
            const double depth = water.depth(gauge.x, gauge.y);
            const double u = water.velocity_x(gauge.x, gauge.y);
            const double v = water.velocity_y(gauge.x, gauge.y);
            numbers.push_back({gauge.name + "_depth_m", "m", depth});
            numbers.push_back({gauge.name + "_level_m", "m", bed(gauge.x, gauge.y) + depth});
            numbers.push_back(
                {gauge.name + "_unit_discharge_m2s", "m2/s", depth * std::sqrt(u * u + v * v)});
            continue;
        }
        double discharge = 0.0;
        for (const Crossing& cell : gauge.crossings) {
            discharge +=
                water.depth(cell.x, cell.y) * (water.velocity_x(cell.x, cell.y) * cell.width_x +
                                               water.velocity_y(cell.x, cell.y) * cell.width_y);
        }
        numbers.push_back({gauge.name + "_discharge_m3s", "m3/s", discharge});
    }
    return numbers;
}

}  // namespace fumon
