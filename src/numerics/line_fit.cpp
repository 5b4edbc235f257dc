#include "numerics/line_fit.h"

#include <cmath>
#include <vector>

#include "base/elementary.h"

namespace fumon {

namespace {

constexpr double ln10 = 2.302585092994046;

std::vector<double> decimal_logarithms(std::span<const double> values) {
    std::vector<double> logarithms;
    logarithms.reserve(values.size());
    for (const double value : values) logarithms.push_back(elementary::log(value) / ln10);
    return logarithms;
}

}  // namespace

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
    LineFit fit;
    fit.points = static_cast<std::int64_t>(x.size());
    if (x.size() < 2) return fit;
    const auto count = static_cast<double>(x.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / count;
        mean_y += y[i] / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
        yy += (y[i] - mean_y) * (y[i] - mean_y);
    }
    if (!(xx > 0.0)) return fit;
    fit.slope = xy / xx;
    fit.intercept = mean_y - fit.slope * mean_x;
    double residual = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double off = y[i] - (fit.intercept + fit.slope * x[i]);
        residual += off * off;
    }
    if (yy > 0.0) fit.r_squared = 1.0 - residual / yy;
    if (x.size() > 2) fit.standard_error = std::sqrt(residual / (count - 2.0) / xx);
    return fit;
}

LineFit fit_line_in_logarithms(std::span<const double> x, std::span<const double> y) {
    return fit_line(decimal_logarithms(x), decimal_logarithms(y));
}

}  // namespace fumon
