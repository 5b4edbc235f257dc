#include "numerics/gaussian_line.h"

#include <cmath>
#include <cstddef>

#include "base/elementary.h"

namespace fumon {

namespace {

std::vector<double> kernel_of(double sigma) {
    const int radius = static_cast<int>(std::ceil(4.0 * sigma));
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        weights.push_back(elementary::exp(-0.5 * i * i / (sigma * sigma)));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

std::size_t site_or_mirrored(int x, int count, bool periodic) {
    const int period = periodic ? count : 2 * count;
    const int inside = ((x % period) + period) % period;
    return static_cast<std::size_t>(inside < count ? inside : period - 1 - inside);
}

}  // namespace

std::vector<double> gaussian_smoothed(std::span<const double> line, double sigma, bool periodic) {
    const std::vector<double> weights = kernel_of(sigma);
    const int radius = static_cast<int>(weights.size() / 2);
    const int count = static_cast<int>(line.size());
    std::vector<double> padded;
    padded.reserve(line.size() + weights.size());
    for (int x = -radius; x < count + radius && count > 0; ++x)
        padded.push_back(line[site_or_mirrored(x, count, periodic)]);
    std::vector<double> smooth(line.size(), 0.0);
    for (std::size_t x = 0; x < line.size(); ++x) {
        for (std::size_t i = 0; i < weights.size(); ++i) smooth[x] += weights[i] * padded[x + i];
    }
    return smooth;
}

}  // namespace fumon
