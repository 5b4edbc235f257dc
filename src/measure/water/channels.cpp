#include "measure/water/channels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "measure/water/downslope_mean.h"
#include "numerics/gaussian_line.h"
#include "numerics/peak_offset.h"
#include "numerics/prominent_maxima.h"

namespace fumon {

namespace {

constexpr double smoothing = 2.0;           // cells
constexpr double least_prominence = 0.25;   // of the range
constexpr double rounding_of_depth = 1e-9;  // of the largest depth

double refined(std::span<const double> line, int site, bool periodic) {
    const int count = static_cast<int>(line.size());
    if (!periodic && (site == 0 || site == count - 1)) return site;
    const auto at = [&](int x) { return line[static_cast<std::size_t>((x + count) % count)]; };
    return site + peak_offset(at(site - 1), at(site), at(site + 1));
}

void measure_distances(Channels& channels, bool periodic) {
    const std::vector<double>& x = channels.positions;
    if (x.size() < 2) return;
    std::vector<double> distances;
    for (std::size_t i = 1; i < x.size(); ++i) distances.push_back(x[i] - x[i - 1]);
    if (periodic) distances.push_back(x.front() + channels.width - x.back());
    const auto count = static_cast<double>(distances.size());
    double sum = 0.0;
    for (const double distance : distances) sum += distance;
    const double mean = sum / count;
    double squares = 0.0;
    for (const double distance : distances) squares += (distance - mean) * (distance - mean);
    channels.mean_distance = mean;
    channels.distance_variation = std::sqrt(squares / count) / mean;
}

}  // namespace

Channels find_channels(const Grid& depth, const Mask& nodata, double dx, bool periodic) {
    Channels channels;
    channels.width = dx * depth.nx();
    const std::vector<double> line =
        gaussian_smoothed(downslope_mean(depth, nodata), smoothing, periodic);
    if (line.empty() || std::ranges::any_of(line, [](double h) { return std::isnan(h); }))
        return channels;
    const auto [lowest, highest] = std::ranges::minmax(line);
    const double range = highest - lowest;
    channels.count = 0.0;
    if (!(range > rounding_of_depth * std::max(std::abs(lowest), std::abs(highest))))
        return channels;
    for (const LineMaximum& maximum : prominent_maxima(line, periodic, least_prominence * range)) {
        channels.sites.push_back(maximum.site);
        channels.positions.push_back((refined(line, maximum.site, periodic) + 0.5) * dx);
    }
    channels.count = static_cast<double>(channels.sites.size());
    if (!channels.sites.empty()) channels.spacing = channels.width / channels.count;
    measure_distances(channels, periodic);
    return channels;
}

}  // namespace fumon
