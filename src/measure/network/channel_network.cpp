#include "measure/network/channel_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.h"
#include "base/error.h"
#include "measure/network/channel_distance.h"
#include "measure/network/stream_path.h"
#include "numerics/line_fit.h"

namespace fumon {

namespace {

constexpr double ln10 = 2.302585092994046;
constexpr double bins_per_decade = 5.0;
constexpr int least_cells = 5;  // of a bin that counts

/// Ten to the slope of a line through decimal logarithms of positive values of orders 1, 2 …
double ratio_of_orders(const std::vector<double>& values) {
    std::vector<double> orders;
    std::vector<double> logarithms;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] > 0.0)) continue;
        orders.push_back(static_cast<double>(i + 1));
        logarithms.push_back(elementary::log(values[i]));
    }
    return elementary::exp(fit_line(orders, logarithms).slope);
}

double slope_area_exponent(const FlowRouting& routing, const ChannelNetwork& network,
                           const Grid& area, double threshold) {
    struct Bin {
        double fall = 0.0;
        double length = 0.0;
        int cells = 0;
    };
    std::vector<Bin> bins;
    for (const std::int32_t cell : routing.upward) {
        const auto here = static_cast<std::size_t>(cell);
        const double length = routing.length(cell);
        if (network.order.values()[here] == 0 || length == 0.0) continue;
        const double decades = elementary::log(area.values()[here] / threshold) / ln10;
        const auto number = static_cast<std::size_t>(std::max(0.0, bins_per_decade * decades));
        if (number >= bins.size()) bins.resize(number + 1);
        bins[number].fall += routing.fall(cell);
        bins[number].length += length;
        ++bins[number].cells;
    }
    std::vector<double> areas;
    std::vector<double> slopes;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        if (bins[i].cells < least_cells || !(bins[i].fall > 0.0)) continue;
        areas.push_back(threshold *
                        elementary::exp((static_cast<double>(i) + 0.5) / bins_per_decade * ln10));
        slopes.push_back(bins[i].fall / bins[i].length);
    }
    if (areas.size() < 3) return undefined;
    return -fit_line_in_logarithms(areas, slopes).slope;
}

/// Of the basins above the mouths of all streams.
double length_area_exponent(const FlowRouting& routing, const ChannelNetwork& network,
                            const Grid& area, const Grid& ways) {
    std::vector<double> areas;
    std::vector<double> lengths;
    for (const std::int32_t cell : routing.upward) {
        const auto here = static_cast<std::size_t>(cell);
        const int order = network.order.values()[here];
        const std::int32_t next = routing.receiver.values()[here];
        const bool mouth = next == FlowRouting::outlet ||
                           network.order.values()[static_cast<std::size_t>(next)] > order;
        if (order == 0 || !mouth || !(ways.values()[here] > 0.0)) continue;
        areas.push_back(area.values()[here]);
        lengths.push_back(ways.values()[here]);
    }
    if (areas.size() < 3) return undefined;
    return fit_line_in_logarithms(areas, lengths).slope;
}

}  // namespace

ChannelNetwork channel_network(const FlowRouting& routing, const Grid& area, double threshold) {
    if (!(threshold > 0.0)) {
        throw InputError(
            fmt::format("a channel's least drainage area is {}; it must be above 0", threshold));
    }
    ChannelNetwork network;
    network.order = Field<std::uint8_t>(area.nx(), area.ny());
    Field<std::uint8_t> highest(area.nx(), area.ny());  // of the streams that flow in
    Field<std::uint8_t> equals(area.nx(), area.ny());   // how many of these
    for (auto cell = routing.upward.rbegin(); cell != routing.upward.rend(); ++cell) {
        const auto here = static_cast<std::size_t>(*cell);
        if (area.values()[here] < threshold) continue;
        const int inflow = highest.values()[here];
        const bool begins = inflow == 0 || equals.values()[here] > 1;
        const int order = inflow + (begins ? 1 : 0);
        network.order.values()[here] = static_cast<std::uint8_t>(order);
        const auto kind = static_cast<std::size_t>(order - 1);
        if (kind >= network.streams.size()) {
            network.streams.resize(kind + 1);
            network.lengths.resize(kind + 1);
        }
        if (begins) network.streams[kind] += 1.0;
        const double length = routing.length(*cell);
        network.lengths[kind] += length;
        network.total_length += length;
        const std::int32_t next = routing.receiver.values()[here];
        if (next == FlowRouting::outlet) continue;
        const auto below = static_cast<std::size_t>(next);
        if (order > highest.values()[below]) {
            highest.values()[below] = static_cast<std::uint8_t>(order);
            equals.values()[below] = 1;
        } else if (order == highest.values()[below]) {
            ++equals.values()[below];
        }
    }
    return network;
}

double weighted_mean_ratio(const std::vector<double>& values, const std::vector<double>& streams) {
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        const double weight = streams[i] + streams[i + 1];
        sum += weight * (values[i] / values[i + 1]);
        weights += weight;
    }
    return weights > 0.0 ? sum / weights : undefined;
}

NetworkShape network_shape(const FlowRouting& routing, double threshold, const Mask& nodata,
                           bool wraps_x) {
    const Grid area = drainage_area(routing);
    const ChannelNetwork network = channel_network(routing, area, threshold);
    const Grid ways = longest_path_lengths(routing);
    NetworkShape shape;
    if (routing.upward.empty()) return shape;
    shape.drainage_density = network.total_length /
                             (static_cast<double>(routing.upward.size()) * routing.dx * routing.dy);
    shape.highest_order = static_cast<double>(network.streams.size());
    shape.sources = network.streams.empty() ? 0.0 : network.streams.front();
    if (network.streams.size() > 1) {
        shape.bifurcation_ratio = 1.0 / ratio_of_orders(network.streams);
        std::vector<double> means = network.lengths;
        for (std::size_t i = 0; i < means.size(); ++i) means[i] /= network.streams[i];
        shape.length_ratio = ratio_of_orders(means);
        shape.weighted_bifurcation_ratio = weighted_mean_ratio(network.streams, network.streams);
        // One over each mean, so that the ratio is that of the higher order over the lower.
        for (double& mean : means) mean = 1.0 / mean;
        shape.weighted_length_ratio = weighted_mean_ratio(means, network.streams);
    }
    shape.concavity = slope_area_exponent(routing, network, area, threshold);
    shape.hack_exponent = length_area_exponent(routing, network, area, ways);
    shape.spacing =
        4.0 * mean_channel_distance(network.order, nodata, routing.dx, routing.dy, wraps_x);
    shape.longest_path_length = *std::ranges::max_element(ways.values());
    return shape;
}

}  // namespace fumon
