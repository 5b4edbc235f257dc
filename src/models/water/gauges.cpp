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
                       fmt::format("\"{}\" cannot begin the name of a column; write a letter, then "
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
        throw KeyError(
            key_of(number, "coordinates"),
            "the bed has no map coordinates; take \"grid\", metres from its south-west corner");
    }
    const GeoReference& map = *scale.place;
    return {(place[0] - map.west) / map.dx * scale.dx, (place[1] - map.south) / map.dy * scale.dy};
}

GridSide side_of(GaugeSide side) {
    switch (side) {
        case GaugeSide::east:
            return GridSide::east;
        case GaugeSide::south:
            return GridSide::south;
        case GaugeSide::north:
            return GridSide::north;
        case GaugeSide::none:
        case GaugeSide::west:
        case GaugeSide::all:
            break;
    }
    return GridSide::west;
}

/// Within which ends of lines on the grid's edges may miss these, in cells: 100 times .57
/// is less than 57 in binary numbers, and coordinates of maps are rounded.
constexpr double rounding_of_edges = 1e-6;

/// The line between cells next to a place, from 0 to `count`.
int nearest_line(double place, double size, int count) {
    return std::clamp(static_cast<int>(std::floor(place / size + 0.5)), 0, count);
}

}  // namespace

Gauges::Gauges(const GullyParameters& parameters, const WaterDomain& domain,
               const WorldScale& scale, int nx, int ny)
    : domain_(domain), nx_(nx), ny_(ny), time_step_(parameters.time_step) {
    std::set<std::string> taken;
    for (std::size_t n = 0; n < parameters.gauges.size(); ++n) {
        const GaugeSettings& settings = parameters.gauges[n];
        gauges_.push_back({name_of(settings, n, taken)});
        Gauge& gauge = gauges_.back();
        const bool at_side = settings.side != GaugeSide::none;
        if (at_side != settings.at.empty()) {
            throw KeyError(key_of(n, at_side ? "side" : "at"),
                           "a gauge needs a position: give either gauge.at or gauge.side");
        }
        const bool is_line = !settings.to.empty();
        const auto locate = [&](const char* key, const std::vector<double>& place) {
            const auto metres = place_in_grid(settings, n, key, place, scale);
            const auto lies_in = [&](double at, double size, int count) {
                const double end = size * count;
                const double rounding = rounding_of_edges * size;
                return is_line ? at >= -rounding && at <= end + rounding : at >= 0.0 && at < end;
            };
            if (lies_in(metres[0], domain.dx, nx) && lies_in(metres[1], domain.dy, ny))
                return metres;
            throw KeyError(
                key_of(n, key),
                fmt::format("({:g}, {:g}) is {:.6g} m east and {:.6g} m north of the grid's "
                            "south-west corner; the grid is {:g} m by {:g} m",
                            place[0], place[1], metres[0], metres[1], domain.dx * nx,
                            domain.dy * ny));
        };
        if (settings.side == GaugeSide::all) {
            if (!watch_all())
                throw KeyError(key_of(n, "side"),
                               "nothing leaves: all edges are periodic and all cells have data");
        } else if (at_side) {
            if (!watch_side(side_of(settings.side)))
                throw KeyError(key_of(n, "side"), "no cell along that side has data");
        } else if (is_line) {
            const auto at = locate("at", settings.at);
            if (!watch_line(at, locate("to", settings.to)))
                throw KeyError(key_of(n, "to"),
                               "the line has no length or crosses no data; it must cross at least "
                               "one cell with data");
        } else {
            const auto at = locate("at", settings.at);
            gauge.is_point = true;
            gauge.x = std::min(static_cast<int>(at[0] / domain.dx), nx - 1);
            gauge.y = std::min(static_cast<int>(at[1] / domain.dy), ny - 1);
            if (!has_data(gauge.x, gauge.y))
                throw KeyError(key_of(n, "at"), "there is no data at this point; choose another");
        }
    }
}

bool Gauges::has_data(int x, int y) const {
    return domain_.nodata.empty() || domain_.nodata(x, y) == 0;
}

/// Watches a face of a cell for the last gauge; whether the cell has data.
bool Gauges::watch(int x, int y, GridSide side, double sign) {
    if (!has_data(x, y)) return false;
    faces_.rows.resize(static_cast<std::size_t>(ny_));
    faces_.rows[static_cast<std::size_t>(y)].push_back({x, side, sign, gauges_.size() - 1});
    return true;
}

/// Walks along the sides of cells, always to that of the two next corners which lies nearer to the
/// line, from its western end (of two above one another: the southern) whichever is its first.
bool Gauges::watch_line(std::array<double, 2> from, std::array<double, 2> to) {
    double sign = 1.0;
    if (to < from) {
        std::swap(from, to);
        sign = -1.0;
    }
    const auto corner_of = [&](const std::array<double, 2>& place) {
        return std::array{nearest_line(place[0], domain_.dx, nx_),
                          nearest_line(place[1], domain_.dy, ny_)};
    };
    const auto distance = [&](int column, int row) {
        return std::fabs((column * domain_.dx - from[0]) * (to[1] - from[1]) -
                         (row * domain_.dy - from[1]) * (to[0] - from[0]));
    };
    auto [column, row] = corner_of(from);
    const auto end = corner_of(to);
    const int up = end[1] < row ? -1 : 1;
    bool any = false;
    while (column != end[0] || row != end[1]) {
        const bool may_rise = row != end[1];
        const bool along_x = column != end[0] &&
                             (!may_rise || distance(column + 1, row) <= distance(column, row + up));
        bool has_face = false;
        if (along_x) {  // what passes northward, to the left of the way
            has_face = (row > 0 && watch(column, row - 1, GridSide::north, sign)) ||
                       (row < ny_ && watch(column, row, GridSide::south, -sign));
            ++column;
        } else {  // what passes westward on the way north
            const int y = up > 0 ? row : row - 1;
            has_face = (column > 0 && watch(column - 1, y, GridSide::east, -up * sign)) ||
                       (column < nx_ && watch(column, y, GridSide::west, up * sign));
            row += up;
        }
        any = has_face || any;
    }
    return any;
}

bool Gauges::watch_side(GridSide side) {
    const bool across_x = side == GridSide::west || side == GridSide::east;
    bool any = false;
    for (int cell = 0; cell < (across_x ? ny_ : nx_); ++cell) {
        const int x = across_x ? (side == GridSide::east ? nx_ - 1 : 0) : cell;
        const int y = across_x ? cell : (side == GridSide::north ? ny_ - 1 : 0);
        any = watch(x, y, side, 1.0) || any;
    }
    return any;
}

bool Gauges::watch_all() {
    const bool wraps_x = domain_.edges_x == EdgeKind::periodic;
    const bool wraps_y = domain_.edges_y == EdgeKind::periodic;
    const auto is_outside = [&](int x, int y) {
        if ((!wraps_x && (x < 0 || x >= nx_)) || (!wraps_y && (y < 0 || y >= ny_))) return true;
        return !has_data((x + nx_) % nx_, (y + ny_) % ny_);
    };
    bool any = false;
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            const auto look = [&](GridSide side, int to_x, int to_y) {
                if (is_outside(to_x, to_y)) any = watch(x, y, side, 1.0) || any;
            };
            look(GridSide::west, x - 1, y);
            look(GridSide::east, x + 1, y);
            look(GridSide::south, x, y - 1);
            look(GridSide::north, x, y + 1);
        }
    }
    return any;
}

void Gauges::begin_step() {
    for (Gauge& gauge : gauges_) gauge.step_volume = 0.0;
}

void Gauges::end_sub_step() {
    std::vector<CompensatedSum> passed(faces_.rows.empty() ? 0 : gauges_.size());
    for (std::vector<WatchedFace>& row : faces_.rows) {
        for (WatchedFace& face : row) {
            passed[face.gauge].add(face.sign * face.volume);
            face.volume = 0.0;
        }
    }
    for (std::size_t n = 0; n < passed.size(); ++n) {
        gauges_[n].volume.add(passed[n].value());
        gauges_[n].step_volume += passed[n].value();
    }
}

std::vector<SnapshotNumber> Gauges::read(const Water& water, const Grid& bed) const {
    std::vector<SnapshotNumber> numbers;
    for (const Gauge& gauge : gauges_) {
        if (!gauge.is_point) {
            numbers.push_back(
                {gauge.name + "_discharge_m3s", "m3/s", gauge.step_volume / time_step_});
            numbers.push_back({gauge.name + "_volume_m3", "m3", gauge.volume.value()});
            continue;
        }
        const double depth = water.depth(gauge.x, gauge.y);
        const double u = water.velocity_x(gauge.x, gauge.y);
        const double v = water.velocity_y(gauge.x, gauge.y);
        numbers.push_back({gauge.name + "_depth_m", "m", depth});
        numbers.push_back({gauge.name + "_level_m", "m", bed(gauge.x, gauge.y) + depth});
        numbers.push_back(
            {gauge.name + "_unit_discharge_m2s", "m2/s", depth * std::sqrt(u * u + v * v)});
    }
    return numbers;
}

void Gauges::serialise(StateArchive& archive) {
    for (Gauge& gauge : gauges_) {
        if (gauge.is_point) continue;
        gauge.volume.serialise(gauge.name + "_volume", archive);
        archive.value(gauge.name + "_step_volume", gauge.step_volume);
    }
}

}  // namespace fumon
