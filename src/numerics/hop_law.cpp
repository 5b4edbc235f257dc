#include "numerics/hop_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/error.h"

namespace fumon {

namespace {

constexpr std::size_t fewest_flights = 3;

void check_count(std::span<const HopPoint> points) {
    if (points.size() >= fewest_flights) return;
    throw Error(fmt::format("{} flights are too few for a hop law; it takes {}", points.size(),
                            fewest_flights));
}

double sum(std::span<const HopPoint> points, const std::function<double(const HopPoint&)>& term) {
    double total = 0.0;
    for (const HopPoint& point : points) total += term(point);
    return total;
}

double squared_misfit(std::span<const HopPoint> points,
                      const std::function<double(const HopPoint&)>& law) {
    return sum(points, [&](const HopPoint& point) {
        const double miss = point.length - law(point);
        return miss * miss;
    });
}

double r_squared(std::span<const HopPoint> points,
                 const std::function<double(const HopPoint&)>& law) {
    const double mean = sum(points, [](const HopPoint& point) { return point.length; }) /
                        static_cast<double>(points.size());
    const double spread = squared_misfit(points, [&](const HopPoint&) { return mean; });
    if (!(spread > 0.0)) return std::numeric_limits<double>::quiet_NaN();
    return 1.0 - squared_misfit(points, law) / spread;
}

struct FittedLine {
    double constant;
    double rise;
};

/// Least squares of the length over one of the point's numbers.
FittedLine fit_line(std::span<const HopPoint> points, const char* what,
                    const std::function<double(const HopPoint&)>& abscissa) {
    check_count(points);
    const auto n = static_cast<double>(points.size());
    const double mean_x = sum(points, abscissa) / n;
    const double mean_l = sum(points, [](const HopPoint& point) { return point.length; }) / n;
    const double spread = sum(points, [&](const HopPoint& point) {
        const double off = abscissa(point) - mean_x;
        return off * off;
    });
    if (!(spread > 0.0)) {
        throw Error(
            fmt::format("all flights start at the same {}; a hop law needs a bed with "
                        "relief",
                        what));
    }
    const double rise = sum(points,
                            [&](const HopPoint& point) {
                                return (abscissa(point) - mean_x) * (point.length - mean_l);
                            }) /
                        spread;
    return {mean_l - rise * mean_x, rise};
}

}  // namespace

double ExponentialLaw::length(double height) const {
    return elementary::pow(base, height) - 1.0;
}

ExponentialLaw fit_exponential(std::span<const HopPoint> points) {
    static_cast<void>(
        fit_line(points, "height", [](const HopPoint& point) { return point.height; }));
    const auto misfit = [&](double rate) {
        return squared_misfit(points, [&](const HopPoint& point) {
            return elementary::exp(rate * point.height) - 1.0;
        });
    };
    // The first guess is the law's least squares in ln(1 + l); then Gauss and Newton's steps, each
    // halved until it helps.
    constexpr double shortest = -0.999;  // grains that land upwind do not spoil the guess
    double rate =
        sum(points,
            [&](const HopPoint& point) {
                return point.height * elementary::log(1.0 + std::max(point.length, shortest));
            }) /
        sum(points, [](const HopPoint& point) { return point.height * point.height; });
    double best = misfit(rate);
    constexpr int most_steps = 200;
    constexpr double fine_enough = 1e-13;
    for (int step = 0; step < most_steps; ++step) {
        double along = 0.0;
        double curvature = 0.0;
        for (const HopPoint& point : points) {
            const double grown = elementary::exp(rate * point.height);
            const double gradient = point.height * grown;
            along += gradient * (point.length - (grown - 1.0));
            curvature += gradient * gradient;
        }
        double change = along / curvature;
        while (!(misfit(rate + change) <= best) && std::fabs(change) > fine_enough) change *= 0.5;
        if (!(std::fabs(change) > fine_enough * (1.0 + std::fabs(rate)))) break;
        rate += change;
        best = misfit(rate);
    }
    ExponentialLaw law{elementary::exp(rate), 0.0};
    law.r_squared = r_squared(
        points, [&](const HopPoint& point) { return elementary::exp(rate * point.height) - 1.0; });
    return law;
}

LinearLaw fit_linear(std::span<const HopPoint> points) {
    const FittedLine line =
        fit_line(points, "height", [](const HopPoint& point) { return point.height; });
    LinearLaw law{line.constant, line.rise, 0.0};
    law.r_squared =
        r_squared(points, [&](const HopPoint& point) { return law.length(point.height); });
    return law;
}

SlopeLaw fit_slope(std::span<const HopPoint> points) {
    const auto steepness = [](const HopPoint& point) { return elementary::tanh(point.slope); };
    const FittedLine line = fit_line(points, "slope", steepness);
    SlopeLaw law{line.constant, -line.rise, 0.0};
    law.r_squared = r_squared(points, [&](const HopPoint& point) {
        return law.constant - law.factor * steepness(point);
    });
    return law;
}

HopTable tabulate(std::span<const HopPoint> points, int bins) {
    static_cast<void>(
        fit_line(points, "height", [](const HopPoint& point) { return point.height; }));
    const auto [lowest, highest] = std::minmax_element(
        points.begin(), points.end(),
        [](const HopPoint& a, const HopPoint& b) { return a.height < b.height; });
    const double low = lowest->height;
    const double width = (highest->height - low) / bins;
    HopTable sums;
    sums.heights.resize(static_cast<std::size_t>(bins));
    sums.lengths.resize(static_cast<std::size_t>(bins));
    sums.counts.resize(static_cast<std::size_t>(bins));
    for (const HopPoint& point : points) {
        const int bin = std::min(static_cast<int>((point.height - low) / width), bins - 1);
        const auto k = static_cast<std::size_t>(bin);
        sums.heights[k] += point.height;
        sums.lengths[k] += point.length;
        ++sums.counts[k];
    }
    HopTable table;
    for (std::size_t k = 0; k < sums.counts.size(); ++k) {
        if (sums.counts[k] == 0) continue;
        table.heights.push_back(sums.heights[k] / sums.counts[k]);
        table.lengths.push_back(sums.lengths[k] / sums.counts[k]);
        table.counts.push_back(sums.counts[k]);
    }
    return table;
}

}  // namespace fumon
