#include "numerics/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace fumon {
namespace {

double value_of(const std::string& text, double x = 2.0) {
    return Expression(text, {{"a", 1.5}, {"L_0", -3.0}}).at(x);
}

std::string refusal_of(const std::string& text) {
    try {
        const Expression formula(text, {{"a", 1.5}});
    } catch (const InputError& fault) {
        return fault.what();
    }
    return "";
}

TEST(ExpressionTest, HasTheRanksOfMathematics) {
    EXPECT_EQ(value_of("1 + 2 * x"), 5.0);
    EXPECT_EQ(value_of("(1 + 2) * x"), 6.0);
    EXPECT_EQ(value_of("7 - 2 - 1"), 4.0);
    EXPECT_EQ(value_of("8 / 4 / 2"), 1.0);
    EXPECT_EQ(value_of("2 ^ 3 ^ 2"), 512.0) << "from the right";
    EXPECT_EQ(value_of("-x^2"), -4.0);
    EXPECT_EQ(value_of("2^-1"), 0.5);
    EXPECT_EQ(value_of("2 * -x"), -4.0);
    EXPECT_EQ(value_of("--x + +x"), 4.0);
    EXPECT_EQ(value_of("a*x + L_0"), 0.0);
    EXPECT_EQ(value_of("1.5e-3 * 1000"), 1.5);
}

TEST(ExpressionTest, KnowsFunctionsAndConstants) {
    EXPECT_DOUBLE_EQ(value_of("sqrt(x)"), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(value_of("exp(ln(5))"), 5.0);
    EXPECT_EQ(value_of("log10(1000)"), 3.0);
    EXPECT_NEAR(value_of("sin(pi / 6)"), 0.5, 1e-15);
    EXPECT_NEAR(value_of("cos(pi)"), -1.0, 1e-15);
    EXPECT_NEAR(value_of("tan(pi / 4)"), 1.0, 1e-15);
    EXPECT_NEAR(value_of("tanh(atan(1)) "), 0.655794202632672, 1e-14);
    EXPECT_EQ(value_of("abs(L_0) ^ 2"), 9.0);
    EXPECT_NEAR(value_of("ln(e)"), 1.0, 1e-15);
    EXPECT_FALSE(std::isfinite(value_of("1 / (x - 2)")));
    EXPECT_TRUE(std::isnan(value_of("sqrt(-x)")));
}

TEST(ExpressionTest, RefusesWithTheColumn) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"2x", "column 2: \"x\" follows without an operator; write * between factors"},
        {"1 + b * x", "column 5: \"b\" is neither x nor one of the constants"},
        {"(1 + x", "column 1: this parenthesis is not closed"},
        {"1 + x)", "column 6: this closing parenthesis has no opening one"},
        {"1 +", "column 4: a number, a name or a parenthesis is missing at the end"},
        {"", "column 1: a number, a name or a parenthesis is missing"},
        {"x ** 2", "column 3: powers are written with ^"},
        {"sine(x)", "column 1: there is no function \"sine\"; did you mean \"sin\"?"},
        {"log(x)", "column 1: log is ambiguous; write ln or log10"},
        {"x * * 2", "column 5: \"*\" found where a number"},
        {"1e999", "column 1: this is not a number"},
        {std::string(2000, '('), "column 1001: a formula has up to 1000 letters"},
        {std::string(500, '('), "nested too deeply"},
        {std::string(500, '-') + "x", "nested too deeply"},
    };
    for (const auto& [text, said] : cases)
        EXPECT_NE(refusal_of(text).find(said), std::string::npos)
            << text << ": " << refusal_of(text);
}

TEST(ExpressionTest, ReadsNamedNumbers) {
    EXPECT_EQ(read_named_number(" g = 9.81 "), NamedNumber("g", 9.81));
    for (const char* wrong : {"g", "g =", "= 1", "2g = 1", "g = 1 m", "g h = 1", "g = inf"})
        EXPECT_THROW(read_named_number(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace fumon
