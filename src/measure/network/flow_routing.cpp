#include "measure/network/flow_routing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "base/snapshot_lookup.h"
#include "measure/network/level_queue.h"

namespace fumon {

namespace {

struct Neighbour {
    int x;
    int y;
};
constexpr std::array<Neighbour, 8> neighbours{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

class Router {
  public:
    Router(const Grid& level, const Mask& nodata, double dx, double dy, bool wraps_x)
        : nodata_(nodata), wraps_x_(wraps_x) {
        routing_.level = level;
        routing_.receiver = Field<std::int32_t>(level.nx(), level.ny(), FlowRouting::outlet);
        routing_.dx = dx;
        routing_.dy = dy;
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const Neighbour& step = neighbours[k];
            lengths_[k] = std::sqrt(step.x * step.x * dx * dx + step.y * step.y * dy * dy);
        }
    }

    FlowRouting route() && {
        flood();
        for (const std::int32_t cell : routing_.upward) descend(cell);
        return std::move(routing_);
    }

  private:
    /// Visits the neighbours of a cell that water can reach, by their place in `neighbours`.
    template <class Visit>
    void for_neighbours(std::int32_t cell, const Visit& visit) const {
        const int nx = routing_.level.nx();
        const int ny = routing_.level.ny();
        const int x = cell % nx;
        const int y = cell / nx;
        if (x > 0 && y > 0 && x < nx - 1 && y < ny - 1) {
            for (std::size_t k = 0; k < neighbours.size(); ++k) {
                const std::int32_t other = cell + neighbours[k].y * nx + neighbours[k].x;
                if (nodata_.empty() || nodata_.values()[static_cast<std::size_t>(other)] == 0)
                    visit(k, other);
            }
            return;
        }
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const int v = y + neighbours[k].y;
            int u = x + neighbours[k].x;
            if (wraps_x_) u = (u + nx) % nx;
            if (u < 0 || v < 0 || u >= nx || v >= ny) continue;
            if (nodata_.empty() || nodata_(u, v) == 0) visit(k, v * nx + u);
        }
    }

    [[nodiscard]] bool is_at_rim(std::int32_t cell) const {
        std::size_t reached = 0;
        for_neighbours(cell, [&](std::size_t, std::int32_t) { ++reached; });
        return reached < neighbours.size();
    }

    double& level(std::int32_t cell) {
        return routing_.level.values()[static_cast<std::size_t>(cell)];
    }
    std::int32_t& receiver(std::int32_t cell) {
        return routing_.receiver.values()[static_cast<std::size_t>(cell)];
    }

    /// Fills hollows from the outlets up; every other cell gets the one from which it was reached.
    void flood() {
        const auto cells = static_cast<std::int32_t>(routing_.level.size());
        std::vector<char> known(routing_.level.size());
        const auto know = [&](std::int32_t cell) -> char& {
            return known[static_cast<std::size_t>(cell)];
        };
        routing_.upward.reserve(routing_.level.size());
        LevelQueue rim;
        for (std::int32_t cell = 0; cell < cells; ++cell) {
            if (!nodata_.empty() && nodata_.values()[static_cast<std::size_t>(cell)] != 0) continue;
            if (!is_at_rim(cell)) continue;
            know(cell) = 1;
            rim.push(level(cell), cell);
        }
        while (!rim.empty()) {
            const LevelQueue::Entry from = rim.pop();
            routing_.upward.push_back(from.cell);
            for_neighbours(from.cell, [&](std::size_t, std::int32_t cell) {
                if (know(cell) != 0) return;
                know(cell) = 1;
                level(cell) = std::max(level(cell), from.level);
                receiver(cell) = from.cell;
                rim.push(level(cell), cell);
            });
        }
    }

    /// Turns a cell's receiver to its steepest lower neighbour, where there is one.
    void descend(std::int32_t cell) {
        if (receiver(cell) == FlowRouting::outlet) return;
        const double here = level(cell);
        double steepest = 0.0;
        for_neighbours(cell, [&](std::size_t k, std::int32_t lower) {
            const double slope = (here - level(lower)) / lengths_[k];
            if (slope <= steepest) return;
            steepest = slope;
            receiver(cell) = lower;
        });
    }

    FlowRouting routing_;
    const Mask& nodata_;
    bool wraps_x_;
    std::array<double, neighbours.size()> lengths_{};
};

}  // namespace

double FlowRouting::length(std::int32_t cell) const {
    const std::int32_t next = receiver.values()[static_cast<std::size_t>(cell)];
    if (next == outlet) return 0.0;
    const int nx = level.nx();
    const double x = cell % nx != next % nx ? dx : 0.0;
    const double y = cell / nx != next / nx ? dy : 0.0;
    return std::sqrt(x * x + y * y);
}

double FlowRouting::fall(std::int32_t cell) const {
    const std::int32_t next = receiver.values()[static_cast<std::size_t>(cell)];
    if (next == outlet) return 0.0;
    return level.values()[static_cast<std::size_t>(cell)] -
           level.values()[static_cast<std::size_t>(next)];
}

FlowRouting route_flow(const Grid& level, const Mask& nodata, double dx, double dy, bool wraps_x) {
    return Router(level, nodata, dx, dy, wraps_x).route();
}

Grid drainage_area(const FlowRouting& routing) {
    Grid area(routing.level.nx(), routing.level.ny());
    const auto values = area.values();
    for (auto cell = routing.upward.rbegin(); cell != routing.upward.rend(); ++cell) {
        const auto here = static_cast<std::size_t>(*cell);
        values[here] += 1.0;
        const std::int32_t next = routing.receiver.values()[here];
        if (next != FlowRouting::outlet) values[static_cast<std::size_t>(next)] += values[here];
    }
    for (double& cells : values) cells *= routing.dx * routing.dy;
    return area;
}

Grid ground_of(const Snapshot& snapshot) {
    const WorldScale& scale = snapshot.scale;
    const double slope = number_of(snapshot, "mean_slope").value_or(0.0);
    const double slope_x = number_of(snapshot, "mean_slope_x").value_or(0.0);
    Grid ground = snapshot.bed;
    for (int y = 0; y < ground.ny(); ++y) {
        for (int x = 0; x < ground.nx(); ++x) {
            const double plane = slope * scale.dy * y - slope_x * scale.dx * x;
            ground(x, y) = ground(x, y) * scale.height_unit + plane;
        }
    }
    return ground;
}

bool wraps_across(const Snapshot& snapshot) {
    return snapshot.periodic && number_of(snapshot, "mean_slope").value_or(0.0) > 0.0 &&
           number_of(snapshot, "mean_slope_x").value_or(0.0) == 0.0;
}

FlowRouting route_flow(const Snapshot& snapshot) {
    return route_flow(ground_of(snapshot), snapshot.nodata, snapshot.scale.dx, snapshot.scale.dy,
                      wraps_across(snapshot));
}

}  // namespace fumon
