#include "render/land/sea_level.h"

#include <algorithm>
#include <cstddef>

namespace fumon {

namespace {

constexpr double least_share = 0.2;
constexpr float edge_within = 1.5F;   // cells
constexpr float inner_from = 3.5F;    // cells
constexpr float inner_within = 5.0F;  // cells

}  // namespace

std::optional<double> sea_level(const Grid& surface, const Field<float>& depth, double tolerance) {
    double lowest = 1e300;
    for (std::size_t i = 0; i < surface.size(); ++i)
        if (depth.values()[i] > 0.0F && depth.values()[i] <= edge_within)
            lowest = std::min(lowest, surface.values()[i]);
    const auto is_level = [&](float from, float within) {
        std::size_t level = 0;
        std::size_t all = 0;
        for (std::size_t i = 0; i < surface.size(); ++i) {
            if (depth.values()[i] <= from || depth.values()[i] > within) continue;
            ++all;
            if (surface.values()[i] <= lowest + tolerance) ++level;
        }
        return all > 0 && static_cast<double>(level) >= least_share * static_cast<double>(all);
    };
    if (!is_level(0.0F, edge_within) || !is_level(inner_from, inner_within)) return std::nullopt;
    return lowest;
}

}  // namespace fumon
