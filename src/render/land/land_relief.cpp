#include "render/land/land_relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "base/elementary.h"
#include "measure/network/flow_routing.h"

namespace fumon {

namespace {

constexpr double concavity = 0.45;        // of graded rivers
constexpr std::size_t enough_in_bin = 8;  // cells

std::size_t bin_of(double area, double cell) {
    return static_cast<std::size_t>(std::max(std::ilogb(std::max(area / cell, 1.0)), 0));
}

}  // namespace

SlopeByArea::SlopeByArea(const Grid& heights, const Mask& nodata, double dx, double dy)
    : cell_(dx * dy) {
    const FlowRouting routing = route_flow(heights, nodata, dx, dy);
    const Grid area = drainage_area(routing);
    struct Bin {
        double sum = 0.0;
        std::size_t count = 0;
    };
    std::vector<Bin> bins;
    for (const std::int32_t cell : routing.upward) {
        const double length = routing.length(cell);
        if (length == 0.0) continue;
        const std::size_t bin = bin_of(area.values()[static_cast<std::size_t>(cell)], cell_);
        if (bin >= bins.size()) bins.resize(bin + 1);
        bins[bin].sum += routing.fall(cell) / length;
        ++bins[bin].count;
    }
    for (const Bin& bin : bins) {
        if (bin.count < enough_in_bin) break;
        slopes_.push_back(bin.sum / static_cast<double>(bin.count));
    }
}

double SlopeByArea::at(double area) const {
    if (slopes_.empty()) return 0.0;
    const double octave = elementary::log(std::max(area / cell_, 1.0)) / std::numbers::ln2;
    const auto last = static_cast<double>(slopes_.size() - 1);
    if (octave >= last)
        return slopes_.back() * elementary::exp(-concavity * std::numbers::ln2 * (octave - last));
    const auto bin = static_cast<std::size_t>(octave);
    return std::lerp(slopes_[bin], slopes_[bin + 1], octave - static_cast<double>(bin));
}

double mean_gradient(const Grid& heights, const Mask& nodata, double dx, double dy) {
    const auto known = [&](int x, int y) { return nodata.empty() || nodata(x, y) == 0; };
    double sum = 0.0;
    std::size_t count = 0;
    for (int y = 1; y + 1 < heights.ny(); ++y) {
        for (int x = 1; x + 1 < heights.nx(); ++x) {
            if (!known(x - 1, y) || !known(x + 1, y) || !known(x, y - 1) || !known(x, y + 1))
                continue;
            const double east = (heights(x + 1, y) - heights(x - 1, y)) / (2.0 * dx);
            const double north = (heights(x, y + 1) - heights(x, y - 1)) / (2.0 * dy);
            sum += std::sqrt(east * east + north * north);
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double mean_bend(const Grid& heights, const Mask& nodata, double dx, double dy) {
    const auto known = [&](int x, int y) { return nodata.empty() || nodata(x, y) == 0; };
    double sum = 0.0;
    std::size_t count = 0;
    for (int y = 1; y + 1 < heights.ny(); ++y) {
        for (int x = 1; x + 1 < heights.nx(); ++x) {
            if (!known(x, y) || !known(x - 1, y) || !known(x + 1, y) || !known(x, y - 1) ||
                !known(x, y + 1))
                continue;
            sum += std::abs(heights(x + 1, y) - 2.0 * heights(x, y) + heights(x - 1, y)) / dx +
                   std::abs(heights(x, y + 1) - 2.0 * heights(x, y) + heights(x, y - 1)) / dy;
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

LandRelief relief_of(const Grid& heights, const Mask& nodata, double dx, double dy) {
    const double gradient = mean_gradient(heights, nodata, dx, dy);
    return {gradient, gradient > 0.0 ? mean_bend(heights, nodata, dx, dy) / gradient : 0.0};
}

}  // namespace fumon
