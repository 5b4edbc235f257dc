#include "figure/plot/plot_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary_power.h"
#include "base/truncation.h"
#include "figure/plot/ticks.h"

namespace fumon {

namespace {

constexpr int rounding_tick_count = 6;
constexpr double step_rounding_share = 1e-9;  // of a step
constexpr double most_waste_share = 0.12;     // of the range, for an end at a labelled number
constexpr double near_zero_share = 0.35;      // of the far end: then 0 is shown
constexpr double most_decade_waste_share = 0.31;

/// What a step is divided into by minor ticks.
int parts_of(const RoundStep& step) {
    return step.leading == 2 ? 4 : 5;
}

/// The nearest multiple of a step that is not above, or not below, a value.
double rounded(double value, double step, bool up) {
    const double steps = value / step;
    return step *
           (up ? std::ceil(steps - step_rounding_share) : std::floor(steps + step_rounding_share));
}

double rounded_end(double value, const RoundStep& step, double range, bool up) {
    const double end = rounded(value, step.value(), up);
    if (std::abs(end - value) <= most_waste_share * range) return end;
    return rounded(value, step.value() / parts_of(step), up);
}

ValueRange with_width(ValueRange values, bool logarithmic) {
    if (values.empty()) return logarithmic ? ValueRange{1.0, 10.0} : ValueRange{0.0, 1.0};
    if (values.low < values.high) return values;
    if (logarithmic) return {0.5 * values.low, 2.0 * values.high};
    const double half = values.low == 0.0 ? 1.0 : 0.1 * std::abs(values.low);
    return {values.low - half, values.high + half};
}

/// The power of ten beyond a value, or the next of 1, 2 and 5 of one where that is far.
double logarithmic_end(double value, bool up) {
    const double power = elementary::log10(value);
    const double whole =
        up ? std::ceil(power - step_rounding_share) : std::floor(power + step_rounding_share);
    if (std::abs(whole - power) <= most_decade_waste_share) return elementary::pow(10.0, whole);
    const double decade = elementary::pow(10.0, std::floor(power));
    double best = up ? 10.0 * decade : decade;
    for (const double leading : {2.0, 5.0}) {
        const double end = leading * decade;
        if (up && end >= value * (1.0 - step_rounding_share)) best = std::min(best, end);
        if (!up && end <= value * (1.0 + step_rounding_share)) best = std::max(best, end);
    }
    return best;
}

PlotScale logarithmic_scale(const PlotAxis& axis, const ValueRange& values, double room) {
    const double margin = elementary::pow(values.high / values.low, room);
    return {axis.low.value_or(logarithmic_end(values.low / margin, false)),
            axis.high.value_or(logarithmic_end(values.high * margin, true)), true};
}

PlotScale linear_scale(const PlotAxis& axis, ValueRange values, double room) {
    const double margin = room * (values.high - values.low);
    if (values.low > 0.0 && values.low < near_zero_share * values.high) values.low = 0.0;
    if (values.high < 0.0 && values.high > near_zero_share * values.low) values.high = 0.0;
    const double low = axis.low.value_or(values.low == 0.0 ? 0.0 : values.low - margin);
    const double high = axis.high.value_or(values.high == 0.0 ? 0.0 : values.high + margin);
    const RoundStep step = round_step(low, high, rounding_tick_count);
    return {axis.low.value_or(rounded_end(low, step, high - low, false)),
            axis.high.value_or(rounded_end(high, step, high - low, true)), false};
}

std::string logarithmic_label(double value) {
    const int power = power_below(value, step_rounding_share);
    constexpr int most_digits = 4;
    if (std::abs(power) > most_digits) {
        const int leading =
            truncated_within(std::round(value / elementary::pow(10.0, power)), 0, 10);
        return leading == 1 ? power_of_ten(power)
                            : fmt::format("{}×{}", leading, power_of_ten(power));
    }
    return plain_number(value, std::max(0, -power));
}

/// Marks within one decade or so: 1, 2 and 5 of each.
PlotTicks narrow_logarithmic_ticks(const PlotScale& scale, int most) {
    PlotTicks ticks;
    const int first = power_below(scale.low);
    const int last = power_below(scale.high);
    for (int power = first; power <= last; ++power) {
        for (int leading = 1; leading < 10; ++leading) {
            const double value = leading * elementary::pow(10.0, power);
            if (value < scale.low * (1.0 - step_rounding_share) ||
                value > scale.high * (1.0 + step_rounding_share))
                continue;
            const bool labelled = leading == 1 || leading == 2 || leading == 5;
            (labelled ? ticks.values : ticks.minor).push_back(value);
            if (labelled) ticks.labels.push_back(logarithmic_label(value));
        }
    }
    if (ticks.values.size() >= 2 && ticks.values.size() <= static_cast<std::size_t>(most))
        return ticks;
    const Ticks linear = linear_ticks(scale.low, scale.high, most);
    return {linear.values, linear.labels, {}, 0};
}

PlotTicks wide_logarithmic_ticks(const PlotScale& scale, int most) {
    PlotTicks ticks;
    const Ticks powers = logarithmic_ticks(scale.low, scale.high, most);
    ticks.values = powers.values;
    ticks.labels = powers.labels;
    const int first = power_below(scale.low, step_rounding_share);
    const int last = power_below(scale.high, step_rounding_share);
    constexpr int most_decades = 12;  // with minor marks in each
    const bool all = ticks.values.size() < 2 || ticks.values[1] < 11.0 * ticks.values[0];
    for (int power = first; power <= last; ++power) {
        const double decade = elementary::pow(10.0, power);
        const bool labelled =
            std::any_of(ticks.values.begin(), ticks.values.end(), [decade](double value) {
                return std::abs(value - decade) < step_rounding_share * decade;
            });
        for (int leading = labelled ? 2 : 1; leading < 10; ++leading) {
            const double value = leading * decade;
            if (leading > 1 && (!all || last - first > most_decades)) break;
            if (value >= scale.low * (1.0 - step_rounding_share) &&
                value <= scale.high * (1.0 + step_rounding_share))
                ticks.minor.push_back(value);
        }
    }
    return ticks;
}

PlotTicks linear_plot_ticks(const PlotScale& scale, int most) {
    PlotTicks ticks;
    const RoundStep step = round_step(scale.low, scale.high, most);
    ticks.values = multiples(step.value(), scale.low, scale.high);
    double largest = 0.0;
    for (const double value : ticks.values) largest = std::max(largest, std::abs(value));
    if (largest > 0.0 && (largest >= 1e5 || largest < 1e-2)) {
        ticks.power = power_below(largest, step_rounding_share);
    }
    for (const double value : ticks.values)
        ticks.labels.push_back(plain_number(value / elementary::pow(10.0, ticks.power),
                                            std::max(0, ticks.power - step.exponent)));
    const int parts = parts_of(step);
    for (const double value : multiples(step.value() / parts, scale.low, scale.high)) {
        const double steps = value / step.value();
        if (std::abs(steps - std::round(steps)) > 0.5 / parts) ticks.minor.push_back(value);
    }
    return ticks;
}

void add_with_error(ValueRange& range, const PlotAxis& axis, double value, double error) {
    const auto add = [&range, &axis](double one) {
        if (std::isfinite(one) && (one > 0.0 || !axis.logarithmic)) range.add(one);
    };
    add(value);
    if (!(error > 0.0)) return;
    add(value - error);
    add(value + error);
}

}  // namespace

double PlotScale::share(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    if (!(value > 0.0)) return -INFINITY;
    return elementary::log10(value / low) / elementary::log10(high / low);
}

bool PlotScale::shows(double value) const {
    return std::isfinite(value) && (value > 0.0 || !logarithmic);
}

PlotScale plot_scale(const PlotAxis& axis, const ValueRange& values, double room) {
    ValueRange range = values;
    if (axis.low && axis.high) return {*axis.low, *axis.high, axis.logarithmic};
    if (axis.low) range = {*axis.low, std::max(range.high, *axis.low)};
    if (axis.high) range = {std::min(range.low, *axis.high), *axis.high};
    range = with_width(range, axis.logarithmic);
    return axis.logarithmic ? logarithmic_scale(axis, range, room)
                            : linear_scale(axis, range, room);
}

PlotScale stretched(const PlotScale& scale, double share) {
    if (scale.logarithmic)
        return {scale.low, scale.high * elementary::pow(scale.high / scale.low, share), true};
    PlotAxis axis;
    axis.low = scale.low;
    return linear_scale(axis, {scale.low, scale.high + share * (scale.high - scale.low)}, 0.0);
}

PlotRanges plot_ranges(const Plot& plot) {
    PlotRanges ranges;
    for (const PlotSeries& series : plot.series) {
        const PlotAxis& y_axis = series.on_right && plot.right ? *plot.right : plot.y;
        ValueRange& y = series.on_right && plot.right ? ranges.right : ranges.y;
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) continue;
            add_with_error(ranges.x, plot.x, series.x[i],
                           series.x_error.empty() ? 0.0 : series.x_error[i]);
            add_with_error(y, y_axis, series.y[i],
                           series.y_error.empty() ? 0.0 : series.y_error[i]);
            if (!series.y_low.empty()) add_with_error(y, y_axis, series.y_low[i], 0.0);
        }
    }
    for (const PlotBox& box : plot.boxes) {
        for (const double x : {box.x_low, box.x_high}) add_with_error(ranges.x, plot.x, x, 0.0);
        for (const double y : {box.y_low, box.y_high}) add_with_error(ranges.y, plot.y, y, 0.0);
    }
    for (const ReferenceLine& line : plot.lines)
        add_with_error(line.upright ? ranges.x : ranges.y, line.upright ? plot.x : plot.y,
                       line.value, 0.0);
    return ranges;
}

double room_along_x(const Plot& plot) {
    constexpr double room = 0.03;
    const bool only_curves =
        std::all_of(plot.series.begin(), plot.series.end(), [](const PlotSeries& series) {
            return series.kind != SeriesKind::points && series.kind != SeriesKind::line_and_points;
        });
    return only_curves && plot.boxes.empty() ? 0.0 : room;
}

PlotTicks plot_ticks(const PlotScale& scale, int most) {
    most = std::max(most, 2);
    if (!scale.logarithmic) return linear_plot_ticks(scale, most);
    const Ticks powers = logarithmic_ticks(scale.low, scale.high, 1000);
    return powers.values.size() < 2 ? narrow_logarithmic_ticks(scale, most)
                                    : wide_logarithmic_ticks(scale, most);
}

}  // namespace fumon
