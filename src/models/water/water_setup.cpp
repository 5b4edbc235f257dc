#include "models/water/water_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace fumon {

namespace {

std::string edge_key(std::size_t number, const char* key) {
    return fmt::format("edge.{}.{}", number, key);
}

bool rises(const std::vector<double>& times) {
    return std::ranges::adjacent_find(times, std::greater_equal<>()) == times.end();
}

/// The first cell whose middle is at `place` m or beyond.
int first_from(double place, double size, int count) {
    return static_cast<int>(
        std::clamp(std::ceil(place / size - 0.5 - 1e-9), 0.0, static_cast<double>(count)));
}

void check_edge(const EdgeSettings& edge, std::size_t number) {
    const bool flows = edge.kind == EdgeFlow::discharge || edge.kind == EdgeFlow::level;
    if (edge.times.size() != edge.values.size()) {
        throw KeyError(edge_key(number, "values"),
                       fmt::format("there are {} times and {} values; give one value for each time",
                                   edge.times.size(), edge.values.size()));
    }
    if (!rises(edge.times))
        throw KeyError(edge_key(number, "times"), "times must rise from each to the next");
    if (!flows && !edge.times.empty())
        throw KeyError(edge_key(number, "times"), "only a discharge or a level changes with time");
    const bool negative =
        edge.value < 0.0 || std::ranges::any_of(edge.values, [](double v) { return v < 0.0; });
    if (edge.kind == EdgeFlow::discharge && negative) {
        throw KeyError(edge_key(number, edge.value < 0.0 ? "value" : "values"),
                       "a discharge comes in and is 0 or more; for water that leaves take kind = "
                       "\"open\" or \"level\"");
    }
    if (edge.depth > 0.0 && edge.kind != EdgeFlow::discharge)
        throw KeyError(edge_key(number, "depth"), "belongs to kind = \"discharge\"");
}

}  // namespace

std::vector<EdgeSegment> edge_segments_of(const GullyParameters& parameters,
                                          const WaterDomain& domain, int nx, int ny) {
    std::vector<EdgeSegment> segments;
    for (std::size_t n = 0; n < parameters.edges.size(); ++n) {
        const EdgeSettings& edge = parameters.edges[n];
        check_edge(edge, n);
        const bool across_x = edge.side == GridSide::west || edge.side == GridSide::east;
        if ((across_x ? domain.edges_x : domain.edges_y) == EdgeKind::periodic) {
            throw KeyError(edge_key(n, "side"),
                           fmt::format("these edges are periodic and have no segments; take "
                                       "model.edges_{} = \"wall\" or \"open\"",
                                       across_x ? "x" : "y"));
        }
        const double size = across_x ? domain.dy : domain.dx;
        const int count = across_x ? ny : nx;
        EdgeSegment segment;
        segment.side = edge.side;
        segment.kind = edge.kind;
        segment.depth = edge.depth;
        segment.first = first_from(edge.from, size, count);
        segment.last = (edge.to > 0.0 ? first_from(edge.to, size, count) : count) - 1;
        if (segment.first > segment.last) {
            throw KeyError(
                edge_key(n, edge.to > 0.0 ? "to" : "from"),
                fmt::format("no cell centre lies between {:g} m and {:g} m of a "
                            "side of {:g} m",
                            edge.from, edge.to > 0.0 ? edge.to : size * count, size * count));
        }
        segment.times = edge.times.empty() ? std::vector{0.0} : edge.times;
        segment.values = edge.times.empty() ? std::vector{edge.value} : edge.values;
        for (std::size_t k = 0; k < segments.size(); ++k) {
            const EdgeSegment& other = segments[k];
            if (other.side != segment.side || other.last < segment.first ||
                segment.last < other.first)
                continue;
            throw KeyError(edge_key(n, "from"),
                           fmt::format("this segment overlaps that of edge.{}; separate them", k));
        }
        segments.push_back(std::move(segment));
    }
    return segments;
}

void fill_regions(const GullyParameters& parameters, const WaterDomain& domain, const Grid& bed,
                  Water& water) {
    for (std::size_t n = 0; n < parameters.regions.size(); ++n) {
        const RegionSettings& region = parameters.regions[n];
        const auto key = [&](const char* name) { return fmt::format("water.{}.{}", n, name); };
        if (region.depth.is_word() == region.level.is_word()) {
            throw KeyError(key("depth"), "give the water's depth or its level, and not both");
        }
        int first_x = 0;
        int first_y = 0;
        int end_x = bed.nx();
        int end_y = bed.ny();
        if (!region.window.empty()) {
            if (region.window.size() != 4 || !(region.window[0] < region.window[2]) ||
                !(region.window[1] < region.window[3])) {
                throw KeyError(
                    key("window"),
                    "write [west, south, east, north] with west < east and south < north");
            }
            first_x = first_from(region.window[0], domain.dx, bed.nx());
            first_y = first_from(region.window[1], domain.dy, bed.ny());
            end_x = first_from(region.window[2], domain.dx, bed.nx());
            end_y = first_from(region.window[3], domain.dy, bed.ny());
            if (first_x >= end_x || first_y >= end_y) {
                throw KeyError(
                    key("window"),
                    fmt::format("no cell centre lies in this window; the grid is {:g} m by "
                                "{:g} m",
                                domain.dx * bed.nx(), domain.dy * bed.ny()));
            }
        }
        for (int y = first_y; y < end_y; ++y) {
            for (int x = first_x; x < end_x; ++x) {
                if (!domain.nodata.empty() && domain.nodata(x, y) != 0) continue;
                const double depth = region.depth.is_word()
                                         ? std::max(region.level.value - bed(x, y), 0.0)
                                         : region.depth.value;
                water.depth(x, y) = depth;
                water.velocity_x(x, y) = depth > 0.0 ? region.velocity_x : 0.0;
                water.velocity_y(x, y) = depth > 0.0 ? region.velocity_y : 0.0;
            }
        }
    }
}

void check_rain(const GullyParameters& parameters) {
    if (parameters.rain_times.size() != parameters.rain_rates.size()) {
        throw KeyError("model.rain_rates",
                       fmt::format("there are {} times and {} rates; give one rate for each time",
                                   parameters.rain_times.size(), parameters.rain_rates.size()));
    }
    if (!rises(parameters.rain_times))
        throw KeyError("model.rain_times", "times must rise from each to the next");
    if (!parameters.rain_times.empty() && parameters.rain > 0.0)
        throw KeyError("model.rain",
                       "model.rain_times already sets the rain; leave one of them out");
}

}  // namespace fumon
