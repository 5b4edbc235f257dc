#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vectors/functions_test.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::test {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// Which target this is.
std::int64_t bit() {
    return HWY_TARGET;
}

/// Groups of vectors and, behind them, vectors.
template <class Function>
HWY_INLINE void in_groups(const double* in, int count, double* out, const Function& function) {
    for_each_group<3>(count, [&](auto d, std::size_t x, auto several) HWY_ATTR {
        hn::Vec<decltype(d)> some[several];
        constexpr std::size_t lanes = hn::MaxLanes(d);
        for (std::size_t i = 0; i < several; ++i) some[i] = hn::LoadU(d, in + x + i * lanes);
        function(some);
        for (std::size_t i = 0; i < several; ++i) hn::StoreU(some[i], d, out + x + i * lanes);
    });
}

void exp_of(const double* in, int count, double* out) {
    in_groups(in, count, out, [](auto& x) HWY_ATTR { vectors::HWY_NAMESPACE::exp(x); });
}

void tanh_of(const double* in, int count, double* out) {
    in_groups(in, count, out, [](auto& x) HWY_ATTR { vectors::HWY_NAMESPACE::tanh(x); });
}

void log_of(const double* in, int count, double* out) {
    for_each_cell(
        count, out, [](Vector x) HWY_ATTR { return log_of_normal(x); }, in);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::test
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "base/error.h"
#include "support/temporary_folder.h"
#include "vectors/target.h"

namespace fumon::test {

HWY_EXPORT(bit);
HWY_EXPORT(exp_of);
HWY_EXPORT(tanh_of);
HWY_EXPORT(log_of);

namespace {

using Rows = void (*)(const double* in, int count, double* out);

/// Arguments of all magnitudes, and those at which the functions change their course.
std::vector<double> arguments() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> all{0.0,       -0.0,
                            1.0,       -1.0,
                            22.0,      -22.0,
                            710.0,     -746.0,
                            0x1p-1022, 0x1p-1074,
                            infinity,  -infinity,
                            1e-300,    std::numeric_limits<double>::quiet_NaN()};
    // Side by side, up to where a power of two alone is none any more.
    for (int k = 0; k < 600; ++k)
        all.push_back((k % 2 == 0 ? 1.0 : -1.0) * (690.0 + 0.095 * static_cast<double>(k)));
    std::mt19937_64 random(7);
    for (int k = 0; k < 20'000; ++k) {
        all.push_back(std::bit_cast<double>(random()));
        all.push_back(std::ldexp(static_cast<double>(random()), -59) - 16.0);
        all.push_back(std::ldexp(static_cast<double>(random()), -54) - 512.0);
    }
    return all;
}

bool same_bits(double a, double b) {
    return std::isnan(a) ? std::isnan(b)
                         : std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_same(const std::vector<double>& in, Rows rows, double (*function)(double)) {
    std::vector<double> out(in.size());
    // Rows of every length, so that all lanes are seen with all that can stand before and behind.
    std::size_t begin = 0;
    for (int count = 1; begin + static_cast<std::size_t>(count) <= in.size();
         begin += static_cast<std::size_t>(count), count = count % 37 + 1)
        rows(in.data() + begin, count, out.data() + begin);
    int wrong = 0;
    for (std::size_t k = 0; k < begin && wrong < 5; ++k) {
        if (same_bits(out[k], function(in[k]))) continue;
        ++wrong;
        ADD_FAILURE() << "of " << in[k] << ": " << out[k] << " instead of " << function(in[k]);
    }
}

class VectorFunctions : public ::testing::Test {
  protected:
    void TearDown() override { vectors::use_target(before_); }

  private:
    std::string before_ = vectors::target();
};

TEST_F(VectorFunctions, HaveTheBitsOfThoseOfNumbersOnEveryTarget) {
    const std::vector<double> any = arguments();
    std::vector<double> normal;
    for (const double x : any) {
        if (std::isnormal(x) && x > 0.0) normal.push_back(x);
    }
    std::set<std::int64_t> seen;
    for (const std::string& target : vectors::targets()) {
        SCOPED_TRACE(target);
        vectors::use_target(target);
        EXPECT_EQ(vectors::target(), target);
        EXPECT_TRUE(seen.insert(HWY_DYNAMIC_DISPATCH(bit)()).second) << "another loop each time";
        expect_same(any, HWY_DYNAMIC_DISPATCH(exp_of), elementary::exp);
        expect_same(any, HWY_DYNAMIC_DISPATCH(tanh_of), elementary::tanh);
        expect_same(normal, HWY_DYNAMIC_DISPATCH(log_of), elementary::log_of_normal);
    }
}

TEST_F(VectorFunctions, EveryTargetOfTheProcessorIsThere) {
#ifdef FUMON_SANITIZED
    GTEST_SKIP() << "sanitizers are built with two targets";
#endif
    const std::vector<std::string> targets = vectors::targets();
#if defined(__x86_64__) && defined(__GNUC__)
    const auto has = [&](const char* name) {
        return std::find(targets.begin(), targets.end(), name) != targets.end();
    };
    const bool avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
                      __builtin_cpu_supports("bmi2") != 0;
    const bool avx512 = avx2 && __builtin_cpu_supports("avx512bw") != 0 &&
                        __builtin_cpu_supports("avx512dq") != 0 &&
                        __builtin_cpu_supports("avx512vl") != 0 &&
                        __builtin_cpu_supports("avx512cd") != 0;
    EXPECT_EQ(has("avx2"), avx2);
    EXPECT_EQ(has("avx512"), avx512);
    EXPECT_TRUE(has("plain"));
#endif
    EXPECT_EQ(vectors::target(), targets.front()) << "the best is taken";
    const std::string refusal = message_of<InputError>([] { vectors::use_target("mmx"); });
    EXPECT_NE(refusal.find("there is no vector target \"mmx\" on this processor, but "),
              std::string::npos)
        << refusal;
}

}  // namespace
}  // namespace fumon::test

#endif
