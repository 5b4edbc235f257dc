#include "numerics/curve_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "base/elementary_power.h"
#include "base/error.h"
#include "numerics/hop_law.h"
#include "numerics/line_fit.h"
#include "numerics/stress_fit.h"

namespace fumon {

namespace {

constexpr std::size_t fewest_points = 3;

void check_above_zero(std::span<const double> values, const char* which) {
    if (std::any_of(values.begin(), values.end(), [](double value) { return !(value > 0.0); }))
        throw Error(fmt::format("the fit takes logarithms, but some {} is not above 0", which));
}

CurveLaw line_law(std::span<const double> x, std::span<const double> y) {
    const LineFit fit = fit_line(x, y);
    return {CurveFit::line,
            {{"a", fit.intercept},
             {"b", fit.slope},
             {"b_standard_error", fit.standard_error},
             {"r_squared", fit.r_squared}}};
}

CurveLaw power_law(std::span<const double> x, std::span<const double> y) {
    check_above_zero(x, "x");
    check_above_zero(y, "y");
    const LineFit fit = fit_line_in_logarithms(x, y);
    return {CurveFit::power,
            {{"a", elementary::pow(10.0, fit.intercept)},
             {"b", fit.slope},
             {"b_standard_error", fit.standard_error},
             {"r_squared", fit.r_squared}}};
}

CurveLaw exponential_law(std::span<const double> x, std::span<const double> y) {
    check_above_zero(y, "y");
    std::vector<double> logarithms;
    for (const double value : y) logarithms.push_back(elementary::log(value));
    const LineFit fit = fit_line(x, logarithms);
    return {CurveFit::exponential,
            {{"a", elementary::exp(fit.intercept)},
             {"b", fit.slope},
             {"b_standard_error", fit.standard_error},
             {"r_squared", fit.r_squared}}};
}

CurveLaw hop_law(std::span<const double> x, std::span<const double> y) {
    std::vector<HopPoint> points;
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], 0.0, y[i]});
    const ExponentialLaw law = fit_exponential(points);
    return {CurveFit::hop, {{"a", law.base}, {"r_squared", law.r_squared}}};
}

CurveLaw cosine_law(std::span<const double> x, std::span<const double> y) {
    constexpr double evenness = 1e-6;  // of the spacing
    const auto gaps = static_cast<double>(x.size() - 1);
    const double spacing = (x.back() - x.front()) / gaps;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double expected = x.front() + static_cast<double>(i) * spacing;
        if (!(std::abs(x[i] - expected) <= evenness * spacing))
            throw Error("a cosine fit needs evenly spaced x");
    }
    const StressFit fit = fit_stress(y, 1);
    CurveLaw law{
        CurveFit::cosine,
        {{"a", fit.mean}, {"b", fit.amplitude}, {"c", fit.phase}, {"r_squared", fit.r_squared}}};
    law.start = x.front();
    law.length = spacing * static_cast<double>(x.size());
    return law;
}

/// "−2.5", "2.088·10^{4}".
std::string number(double value) {
    const std::string digits = fmt::format("{:.4g}", std::abs(value));
    const std::size_t power = digits.find('e');
    const char* sign = value < 0.0 ? "\u2212" : "";
    if (power == std::string::npos) return sign + digits;
    const int exponent = std::stoi(digits.substr(power + 1));
    return fmt::format("{}{}·10^{{{}{}}}", sign, digits.substr(0, power),
                       exponent < 0 ? "\u2212" : "", std::abs(exponent));
}

/// "1.83 x", "− 1.83 x" after another term.
std::string term(double factor, const std::string& of) {
    return fmt::format("{} {}{}", factor < 0.0 ? "\u2212" : "+", number(std::abs(factor)), of);
}

/// "1.83 x", "x", "−x".
std::string times(double factor, const std::string& of) {
    const std::string digits = number(factor);
    if (digits == "1") return of;
    return digits == "\u22121" ? "\u2212" + of : digits + " " + of;
}

std::string formula(const CurveLaw& law) {
    switch (law.form) {
        case CurveFit::line:
            return fmt::format("y = {} {}", times(law.value("b"), "x"), term(law.value("a"), ""));
        case CurveFit::power:
            return "y = " + times(law.value("a"), "x^{" + number(law.value("b")) + "}");
        case CurveFit::exponential:
            return "y = " + times(law.value("a"), "exp(" + times(law.value("b"), "x") + ")");
        case CurveFit::hop:
            return fmt::format("y = {}^{{x}} \u2212 1", number(law.value("a")));
        case CurveFit::cosine:
            return fmt::format("y = {} + {} cos(2\u03c0x/L {})", number(law.value("a")),
                               number(law.value("b")), term(law.value("c"), ""));
        case CurveFit::none:
            break;
    }
    return {};
}

}  // namespace

double CurveLaw::value(const std::string& name) const {
    for (const auto& [known, value] : values) {
        if (known == name) return value;
    }
    throw Error(fmt::format("a fit has no {}", name));
}

double CurveLaw::at(double x) const {
    switch (form) {
        case CurveFit::line:
            return value("a") + value("b") * x;
        case CurveFit::power:
            return value("a") * elementary::pow(x, value("b"));
        case CurveFit::exponential:
            return value("a") * elementary::exp(value("b") * x);
        case CurveFit::hop:
            return elementary::pow(value("a"), x) - 1.0;
        case CurveFit::cosine:
            return value("a") +
                   value("b") *
                       elementary::cos(2.0 * std::numbers::pi * (x - start) / length + value("c"));
        case CurveFit::none:
            break;
    }
    return 0.0;
}

std::string CurveLaw::text() const {
    return fmt::format("{}, R² = {:.3f}", formula(*this), value("r_squared"));
}

CurveLaw fit_law(CurveFit form, std::span<const double> x, std::span<const double> y) {
    if (x.size() < fewest_points)
        throw Error(fmt::format("{} points are too few for a fit", x.size()));
    switch (form) {
        case CurveFit::line:
            return line_law(x, y);
        case CurveFit::power:
            return power_law(x, y);
        case CurveFit::exponential:
            return exponential_law(x, y);
        case CurveFit::hop:
            return hop_law(x, y);
        case CurveFit::cosine:
            return cosine_law(x, y);
        case CurveFit::none:
            break;
    }
    return {};
}

}  // namespace fumon
