#include "render/land/edge_lake.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace fumon {

namespace {

constexpr float lake_edge_within = 1.5F;   // cells
constexpr float lake_inner_from = 3.5F;    // cells
constexpr float lake_inner_within = 5.0F;  // cells
constexpr std::size_t least_cells = 4;     // at the edge, and within
constexpr double still_speed = 0.05;       // m/s

}  // namespace

std::optional<EdgeLake> lake_at_edge(const Grid& surface, const Grid& water, const Grid& speed,
                                     const Field<float>& depth, double least_depth,
                                     double tolerance) {
    const int nx = surface.nx();
    const int ny = surface.ny();
    Mask seen(nx, ny);
    std::optional<EdgeLake> lake;
    std::size_t most = 0;
    std::vector<std::pair<int, int>> cells;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const double level = surface(x, y);
            const auto reach = [&](int u, int v) {
                if (u < 0 || v < 0 || u >= nx || v >= ny || seen(u, v) != 0) return;
                if (!(depth(u, v) > 0.0F) || water(u, v) < least_depth ||
                    std::abs(surface(u, v) - level) > tolerance || speed(u, v) > still_speed)
                    return;
                seen(u, v) = 1;
                cells.emplace_back(u, v);
            };
            cells.clear();
            if (depth(x, y) <= lake_edge_within) reach(x, y);
            std::size_t at_edge = 0;
            std::size_t within = 0;
            for (std::size_t i = 0; i < cells.size(); ++i) {
                const auto [u, v] = cells[i];
                const float deep = depth(u, v);
                if (deep <= lake_edge_within) ++at_edge;
                if (deep > lake_inner_from && deep <= lake_inner_within) ++within;
                reach(u + 1, v);
                reach(u - 1, v);
                reach(u, v + 1);
                reach(u, v - 1);
            }
            if (at_edge < least_cells || within < least_cells || at_edge <= most) continue;
            most = at_edge;
            lake = EdgeLake{Mask(nx, ny), level};
            for (const auto& [u, v] : cells)
                if (depth(u, v) <= lake_edge_within) lake->edge(u, v) = 1;
        }
    }
    return lake;
}

}  // namespace fumon
