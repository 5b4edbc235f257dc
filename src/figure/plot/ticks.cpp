#include "figure/plot/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/elementary_power.h"
#include "base/truncation.h"

namespace fumon {

namespace {

constexpr double end_rounding_share = 1e-9;  // of a step, by which an end may miss a multiple of it

constexpr int most_power_of_ten = 400;  // of ten: beyond all doubles

std::string with_minus_sign(std::string text) {
    if (!text.empty() && text.front() == '-') text.replace(0, 1, "\u2212");
    return text;
}

std::string superscript(int number) {
    constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : fmt::format("{}", number))
        text += c == '-' ? std::string_view("⁻") : digits.at(static_cast<std::size_t>(c - '0'));
    return text;
}

}  // namespace

int power_below(double value, double above) {
    return truncated_within(std::floor(elementary::log10(value) + above), -most_power_of_ten,
                            most_power_of_ten);
}

double RoundStep::value() const {
    return leading * elementary::pow(10.0, exponent);
}

RoundStep round_step(double low, double high, int most) {
    const double finest = (high - low) / std::max(most, 2);
    int exponent = power_below(finest) - 1;
    for (;; ++exponent) {
        for (const int leading : {1, 2, 5}) {
            const RoundStep step{leading, exponent};
            const auto first = truncated(std::ceil(low / step.value() - end_rounding_share));
            const auto last = truncated(std::floor(high / step.value() + end_rounding_share));
            if (last - first + 1 <= std::max(most, 2)) return step;
        }
    }
}

std::vector<double> multiples(double step, double low, double high) {
    std::vector<double> values;
    const auto first = truncated(std::ceil(low / step - end_rounding_share));
    const auto last = truncated(std::floor(high / step + end_rounding_share));
    for (long long i = first; i <= last; ++i) values.push_back(static_cast<double>(i) * step);
    return values;
}

std::string plain_number(double value, int decimals) {
    return with_minus_sign(fmt::format("{:.{}f}", value, decimals));
}

std::string power_of_ten(int exponent) {
    return "10" + superscript(exponent);
}

Ticks linear_ticks(double low, double high, int most) {
    Ticks ticks;
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) return ticks;
    const RoundStep step = round_step(low, high, most);
    ticks.values = multiples(step.value(), low, high);
    for (const double value : ticks.values)
        ticks.labels.push_back(plain_number(value, std::max(0, -step.exponent)));
    return ticks;
}

Ticks logarithmic_ticks(double low, double high, int most) {
    Ticks ticks;
    if (!(low > 0.0) || !std::isfinite(high) || !(low < high)) return ticks;
    const int first = truncated_within(std::ceil(elementary::log10(low) - end_rounding_share),
                                       -most_power_of_ten, most_power_of_ten);
    const int last = truncated_within(std::floor(elementary::log10(high) + end_rounding_share),
                                      -most_power_of_ten, most_power_of_ten);
    const int every = std::max(1, (last - first + std::max(most, 1)) / std::max(most, 1));
    for (int power = first; power <= last; power += every) {
        ticks.values.push_back(elementary::pow(10.0, power));
        ticks.labels.push_back(power_of_ten(power));
    }
    return ticks;
}

}  // namespace fumon
