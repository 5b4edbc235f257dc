#include "numerics/prominent_maxima.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "numerics/gaussian_line.h"

namespace fumon::test {
namespace {

using Line = std::vector<double>;

std::vector<int> sites(const Line& line, bool periodic, double least = 0.0) {
    std::vector<int> found;
    for (const LineMaximum& maximum : prominent_maxima(line, periodic, least))
        found.push_back(maximum.site);
    return found;
}

TEST(ProminentMaxima, AreMeasuredFromTheirHighestSaddle) {
    const Line line{0, 5, 3, 8, 1, 6, 4, 7, 2};
    const auto maxima = prominent_maxima(line, false, 0.0);
    ASSERT_EQ(maxima.size(), 4U);
    EXPECT_EQ(maxima[0].prominence, 2.0) << "5 over the saddle 3 toward 8";
    EXPECT_EQ(maxima[1].prominence, 8.0) << "the highest, over the lowest";
    EXPECT_EQ(maxima[2].prominence, 2.0) << "6 over the saddle 4 toward 7, not 1 toward 8";
    EXPECT_EQ(maxima[3].prominence, 6.0) << "7 over the saddle 1 toward 8";
    EXPECT_EQ(sites(line, false, 2.5), (std::vector{3, 7}));
    EXPECT_EQ(prominent_maxima(line, true, 0.0)[3].prominence, 6.0) << "round the edge it is 0";
}

TEST(ProminentMaxima, OfALineThatGoesOnRoundItsEdge) {
    const Line line{9, 1, 4, 2, 6, 5};
    EXPECT_EQ(sites(line, true), (std::vector{0, 2, 4}));
    const auto maxima = prominent_maxima(line, true, 0.0);
    EXPECT_EQ(maxima[0].prominence, 8.0);
    EXPECT_EQ(maxima[1].prominence, 2.0);
    EXPECT_EQ(maxima[2].prominence, 1.0) << "over 5, to 9 round the edge";
    EXPECT_EQ(prominent_maxima(line, false, 0.0)[2].prominence, 5.0) << "over 1, inside";
}

TEST(ProminentMaxima, LevelRunsCountOnceAndEqualOnesAreNotDoubled) {
    EXPECT_EQ(sites({0, 3, 3, 3, 1}, false), std::vector{2});
    EXPECT_EQ(sites({3, 1, 0, 1, 3}, true), std::vector{4}) << "one run, round the edge";
    EXPECT_EQ(sites({3, 1, 0, 1, 3}, false), (std::vector{0, 4}));
    EXPECT_EQ(sites({0, 7, 6.9, 7, 0, 1}, true, 1.5), std::vector{1}) << "a dip between equals";
    EXPECT_EQ(sites({0, 7, 0, 7, 0, 7}, true, 7.0), (std::vector{1, 3, 5}));
    EXPECT_TRUE(sites({2, 2, 2}, true).empty());
    EXPECT_TRUE(sites({}, true).empty());
    EXPECT_EQ(sites({0, 1, 2}, false), std::vector{2}) << "an end";
    EXPECT_TRUE(sites({0, 2, 2, 3, 1}, false, 3.5).empty());
}

/// The definition word by word: flood the line from the maximum's height downward.
double plain_prominence(const Line& line, int site) {
    const int n = static_cast<int>(line.size());
    const double top = line[static_cast<std::size_t>(site)];
    double base = *std::ranges::min_element(line);
    for (const int step : {-1, 1}) {
        double saddle = top;
        for (int x = site, gone = 0; gone < n; x = (x + step + n) % n, ++gone) {
            saddle = std::min(saddle, line[static_cast<std::size_t>(x)]);
            if (line[static_cast<std::size_t>(x)] > top) {
                base = std::max(base, saddle);
                break;
            }
        }
    }
    return top - base;
}

TEST(ProminentMaxima, AreThoseOfThePlainDefinition) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Line line(200);
        RandomStream stream(seed, 0, 0, Purpose::initial_bed);
        for (double& height : line) height = stream.uniform();
        const auto maxima = prominent_maxima(line, true, 0.3);
        std::vector<int> expected;
        for (int x = 0; x < 200; ++x) {
            const auto at = [&](int i) { return line[static_cast<std::size_t>((i + 200) % 200)]; };
            if (at(x) > at(x - 1) && at(x) > at(x + 1) && plain_prominence(line, x) >= 0.3)
                expected.push_back(x);
        }
        EXPECT_EQ(sites(line, true, 0.3), expected);
        for (const LineMaximum& maximum : maxima)
            EXPECT_EQ(maximum.prominence, plain_prominence(line, maximum.site));
    }
}

TEST(GaussianLine, KeepsTheSumAndSpreadsASiteAsItsNameSays) {
    Line spike(60, 0.0);
    spike[1] = 1.0;
    for (const bool periodic : {true, false}) {
        const Line smooth = gaussian_smoothed(spike, 2.0, periodic);
        double sum = 0.0;
        for (const double value : smooth) sum += value;
        EXPECT_NEAR(sum, 1.0, 1e-14) << "mirrored or round the edge, nothing is lost";
    }
    const Line round = gaussian_smoothed(spike, 2.0, true);
    EXPECT_EQ(round[59], round[3]) << "round the edge";
    EXPECT_NEAR(round[3] / round[1], std::exp(-0.5), 1e-14);
    const Line mirrored = gaussian_smoothed(spike, 2.0, false);
    EXPECT_NEAR(mirrored[0], round[0] + round[3], 1e-15) << "the image of 1 is -2";
    EXPECT_EQ(mirrored[59], 0.0);
    const Line level = gaussian_smoothed(Line(3, 4.0), 2.0, true);
    for (const double value : level) EXPECT_NEAR(value, 4.0, 1e-14) << "a line below the kernel";
}

}  // namespace
}  // namespace fumon::test
