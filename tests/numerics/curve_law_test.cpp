#include "numerics/curve_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"

namespace fumon::test {
namespace {

struct Points {
    std::vector<double> x, y;
};

template <class Function>
Points sample(double low, double step, int count, const Function& function) {
    Points points;
    for (int i = 0; i < count; ++i) {
        points.x.push_back(low + step * i);
        points.y.push_back(function(points.x.back()));
    }
    return points;
}

TEST(CurveLaw, FindsTheLawThatMadeThePoints) {
    const Points line = sample(-1.0, 0.5, 9, [](double x) { return 3.0 - 2.0 * x; });
    const CurveLaw straight = fit_law(CurveFit::line, line.x, line.y);
    EXPECT_NEAR(straight.value("a"), 3.0, 1e-12);
    EXPECT_NEAR(straight.value("b"), -2.0, 1e-12);
    EXPECT_NEAR(straight.value("r_squared"), 1.0, 1e-12);
    EXPECT_EQ(straight.text(), "y = \u22122 x + 3, R² = 1.000");
    const Points unit = sample(0.0, 0.5, 9, [](double x) { return x - 5.0; });
    EXPECT_EQ(fit_law(CurveFit::line, unit.x, unit.y).text(), "y = x \u2212 5, R² = 1.000");
    const Points falling = sample(0.0, 0.5, 9, [](double x) { return 2.0 - x; });
    EXPECT_EQ(fit_law(CurveFit::line, falling.x, falling.y).text(), "y = \u2212x + 2, R² = 1.000");
    const Points powers = sample(1.0, 2.0, 8, [](double x) { return 5.0 * std::pow(x, -1.5); });
    const CurveLaw power = fit_law(CurveFit::power, powers.x, powers.y);
    EXPECT_NEAR(power.value("a"), 5.0, 1e-10);
    EXPECT_NEAR(power.value("b"), -1.5, 1e-12);
    const Points growth = sample(0.0, 0.3, 8, [](double x) { return 0.5 * std::exp(1.2 * x); });
    const CurveLaw exponential = fit_law(CurveFit::exponential, growth.x, growth.y);
    EXPECT_NEAR(exponential.value("a"), 0.5, 1e-12);
    EXPECT_NEAR(exponential.value("b"), 1.2, 1e-12);
    const Points hops = sample(0.0, 0.1, 20, [](double x) { return std::pow(5.4, x) - 1.0; });
    EXPECT_NEAR(fit_law(CurveFit::hop, hops.x, hops.y).value("a"), 5.4, 1e-6);
    const Points wave = sample(2.0, 0.25, 16, [](double x) {
        return 1.0 + 0.2 * std::cos(2.0 * std::numbers::pi * (x - 2.0) / 4.0 + 0.7);
    });
    const CurveLaw cosine = fit_law(CurveFit::cosine, wave.x, wave.y);
    EXPECT_NEAR(cosine.value("a"), 1.0, 1e-12);
    EXPECT_NEAR(cosine.value("b"), 0.2, 1e-12);
    EXPECT_NEAR(cosine.value("c"), 0.7, 1e-12);
    for (const auto& [points, law] :
         {std::pair{line, straight}, {powers, power}, {growth, exponential}, {wave, cosine}}) {
        for (std::size_t i = 0; i < points.x.size(); ++i)
            EXPECT_NEAR(law.at(points.x[i]), points.y[i], 1e-10) << law.text();
    }
}

TEST(CurveLaw, LeastSquaresOfScatteredPoints) {
    const std::vector<double> x{0.0, 1.0, 2.0, 3.0};
    const std::vector<double> y{1.0, 0.0, 3.0, 2.0};  // by hand: y = 0.6 x + 0.6
    const CurveLaw law = fit_law(CurveFit::line, x, y);
    EXPECT_NEAR(law.value("b"), 0.6, 1e-12);
    EXPECT_NEAR(law.value("a"), 0.6, 1e-12);
    EXPECT_NEAR(law.value("r_squared"), 1.0 - 3.2 / 5.0, 1e-12);
}

TEST(CurveLaw, RefusesWhatItCannotFit) {
    const std::vector<double> x{0.0, 1.0, 2.5};
    const std::vector<double> y{1.0, -1.0, 2.0};
    EXPECT_THROW(fit_law(CurveFit::line, std::vector{1.0, 2.0}, std::vector{1.0, 2.0}), Error);
    EXPECT_THROW(fit_law(CurveFit::power, x, y), Error);
    EXPECT_THROW(fit_law(CurveFit::exponential, x, y), Error);
    EXPECT_THROW(fit_law(CurveFit::cosine, x, y), Error) << "not evenly spaced";
}

}  // namespace
}  // namespace fumon::test
