#include "measure/network/stream_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "base/error.h"

namespace fumon {

StreamPath stream_path(const FlowRouting& routing, const Mask& nodata, int x, int y) {
    const int nx = routing.level.nx();
    const bool in_grid = x >= 0 && y >= 0 && x < nx && y < routing.level.ny();
    if (!in_grid || (!nodata.empty() && nodata(x, y) != 0)) {
        throw InputError(fmt::format("cell ({}, {}) {}", x, y,
                                     in_grid ? "has no data" : "lies outside the grid"));
    }
    StreamPath path;
    double distance = 0.0;
    for (std::int32_t cell = y * nx + x; cell != FlowRouting::outlet;
         cell = routing.receiver.values()[static_cast<std::size_t>(cell)]) {
        path.x.push_back(cell % nx);
        path.y.push_back(cell / nx);
        path.distance.push_back(distance);
        distance += routing.length(cell);
    }
    return path;
}

std::int32_t main_stream_head(const FlowRouting& routing) {
    std::vector<double> down(routing.level.size());
    std::int32_t head = FlowRouting::outlet;
    double longest = -1.0;
    for (const std::int32_t cell : routing.upward) {
        const auto here = static_cast<std::size_t>(cell);
        const std::int32_t next = routing.receiver.values()[here];
        if (next != FlowRouting::outlet)
            down[here] = down[static_cast<std::size_t>(next)] + routing.length(cell);
        if (down[here] > longest) {
            longest = down[here];
            head = cell;
        }
    }
    return head;
}

Grid longest_path_lengths(const FlowRouting& routing) {
    Grid ways(routing.level.nx(), routing.level.ny());
    for (auto cell = routing.upward.rbegin(); cell != routing.upward.rend(); ++cell) {
        const auto here = static_cast<std::size_t>(*cell);
        const std::int32_t next = routing.receiver.values()[here];
        if (next == FlowRouting::outlet) continue;
        double& below = ways.values()[static_cast<std::size_t>(next)];
        below = std::max(below, ways.values()[here] + routing.length(*cell));
    }
    return ways;
}

}  // namespace fumon
