#include "figure/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "terrain/elementary_power.h"

namespace fumon {

namespace {

constexpr double rounding = 1e-9;  // of a step, by which an end may miss a multiple of it

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

Ticks linear_ticks(double low, double high, int most) {
    Ticks ticks;
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) return ticks;
    const double finest = (high - low) / std::max(most, 2);
    int exponent = static_cast<int>(std::floor(elementary::log10(finest))) - 1;
    for (;; ++exponent) {
        for (const int leading : {1, 2, 5}) {
            const double step = leading * elementary::pow(10.0, exponent);
            const auto first = static_cast<std::int64_t>(std::ceil(low / step - rounding));
            const auto last = static_cast<std::int64_t>(std::floor(high / step + rounding));
            if (last - first + 1 > std::max(most, 2)) continue;
            const int decimals = std::max(0, -exponent);
            for (std::int64_t i = first; i <= last; ++i) {
                const double value = static_cast<double>(i) * step;
                ticks.values.push_back(value);
                ticks.labels.push_back(with_minus_sign(fmt::format("{:.{}f}", value, decimals)));
            }
            return ticks;
        }
    }
}

Ticks logarithmic_ticks(double low, double high, int most) {
    Ticks ticks;
    if (!(low > 0.0) || !std::isfinite(high) || !(low < high)) return ticks;
    const int first = static_cast<int>(std::ceil(elementary::log10(low) - rounding));
    const int last = static_cast<int>(std::floor(elementary::log10(high) + rounding));
    const int every = std::max(1, (last - first + std::max(most, 1)) / std::max(most, 1));
    for (int power = first; power <= last; power += every) {
        ticks.values.push_back(elementary::pow(10.0, power));
        ticks.labels.push_back("10" + superscript(power));
    }
    return ticks;
}

}  // namespace fumon
