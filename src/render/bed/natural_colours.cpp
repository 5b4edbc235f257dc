#include "render/bed/natural_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/compensated_sum.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

namespace {

constexpr double natural_spread = 2.2;  // standard deviations from trough to crest, half of it
constexpr double least_natural_range = 0.03;  // of the longer side: a nearly flat bed stays even

}  // namespace

std::pair<double, double> natural_range(const Snapshot& snapshot, const Block& block) {
    CompensatedSum sum;
    CompensatedSum squares;
    std::size_t count = 0;
    for (std::size_t i = 0; i < snapshot.bed.size(); ++i) {
        if (!snapshot.nodata.empty() && snapshot.nodata.values()[i] != 0) continue;
        const double height = snapshot.bed.values()[i] - block.reference;
        sum.add(height);
        squares.add(height * height);
        ++count;
    }
    if (count == 0) return {0.0, 1.0};
    const double mean = sum.value() / static_cast<double>(count);
    const double spread =
        std::sqrt(std::max(squares.value() / static_cast<double>(count) - mean * mean, 0.0));
    const double half =
        std::max(natural_spread * spread, 0.5 * least_natural_range / block.height_scale);
    return {block.reference + mean - half, block.reference + mean + half};
}

glm::vec2 bare_board(const Snapshot& snapshot, const LookSettings& look,
                     std::pair<double, double> range) {
    constexpr double first_grains = 0.2;  // of a smoothed bed, in grains
    constexpr double closed = 1.0;
    if (!draws_poured_sand(snapshot, look) || look.ground == Ground::endless) return {};
    const auto place = [&](double height) {
        return static_cast<float>((height - range.first) / (range.second - range.first));
    };
    return {place(first_grains), place(closed)};
}

glm::vec3 floor_coordinates(const Field<float>& values, std::pair<double, double> range) {
    std::vector<float> sorted(values.values().begin(), values.values().end());
    const auto at = [&](double share) {
        const auto position =
            static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size()));
        std::nth_element(sorted.begin(), sorted.begin() + position, sorted.end());
        return static_cast<double>(sorted[static_cast<std::size_t>(position)]);
    };
    const double low = (at(0.05) - range.first) / (range.second - range.first);
    const double span = (at(0.95) - range.first) / (range.second - range.first) - low;
    const double floors = std::clamp(5.0 * span - 0.5, 0.0, 1.0);
    return {low + 0.02 * span, low + std::max(0.2 * span, 0.01), floors};
}

}  // namespace fumon
