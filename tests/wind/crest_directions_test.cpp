#include "wind/crest_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fumon {
namespace {

/// Two winds that move sand toward 0 and toward `divergence`, the first `ratio` times as much.
std::vector<SandFlux> two_winds(double ratio, double divergence) {
    return {{0.0, ratio}, {divergence, 1.0}};
}

double nearest(const std::vector<double>& directions, double expected) {
    double least = 360.0;
    for (const double direction : directions)
        least = std::min(least, std::abs(direction - expected));
    return least;
}

struct Reference {
    double flux_ratio;
    double ratio;
    double divergence;
    double instability;
    double fingering;
};

/// Computed on a grid of 0.1 degrees from the equations of Courrech du Pont, Narteau & Gao (2014).
constexpr Reference references[] = {
    {0, 1, 30, 105, 15},       {0, 1, 60, 120, 30},       {0, 1, 90, 45, 45},
    {0, 1, 120, 60, 60},       {0, 1, 150, 75, 75},       {0, 2, 30, 99.9, 9.9},
    {0, 2, 60, 109.1, 19.1},   {0, 2, 90, 63.4, 26.6},    {0, 2, 120, 70.9, 30.0},
    {0, 2, 150, 80.1, 23.8},   {0, 5, 30, 94.9, 4.9},     {0, 5, 60, 98.9, 8.9},
    {0, 5, 90, 78.7, 11.3},    {0, 5, 120, 81.1, 10.9},   {0, 5, 150, 85.1, 6.9},
    {1.6, 1, 30, 105, 15},     {1.6, 1, 60, 120, 30},     {1.6, 1, 90, 45, 45},
    {1.6, 1, 120, 60, 60},     {1.6, 1, 150, 75, 75},     {1.6, 2, 30, 99.6, 11.0},
    {1.6, 2, 60, 106.3, 22.2}, {1.6, 2, 90, 79.0, 32.4},  {1.6, 2, 120, 73.7, 39.2},
    {1.6, 2, 150, 80.4, 35.4}, {1.6, 5, 30, 94.6, 6.4},   {1.6, 5, 60, 96.4, 13.3},
    {1.6, 5, 90, 86.8, 18.5},  {1.6, 5, 120, 83.6, 19.3}, {1.6, 5, 150, 85.4, 12.0},
};

TEST(CrestDirections, OfTwoWindsMeetTheTheory) {
    for (const Reference& of : references) {
        const CrestDirections found =
            crest_directions(two_winds(of.ratio, of.divergence), of.flux_ratio);
        const auto where = ::testing::Message() << "gamma " << of.flux_ratio << ", ratio "
                                                << of.ratio << ", divergence " << of.divergence;
        EXPECT_LE(nearest(found.bed_instability, of.instability), 0.06) << where;
        EXPECT_EQ(found.bed_instability.size(), of.divergence == 90 ? 2U : 1U) << where;
        ASSERT_EQ(found.fingering.size(), 1U) << where;
        EXPECT_LE(nearest(found.fingering, of.fingering), 0.06) << where;
        if (of.flux_ratio == 0) {
            EXPECT_EQ(found.bed_instability, found.gross_normal_transport) << where;
        }
    }
}

TEST(CrestDirections, AreTwoWhereTheWindsStandAtRightAngles) {
    const std::vector<double> found = crest_directions(two_winds(2.0, 90.0), 1.6).bed_instability;
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0], 79.0, 0.06);
    EXPECT_NEAR(found[1], 101.0, 0.06);
}

TEST(CrestDirections, LieAcrossASingleWindWhereverItComesFrom) {
    for (const double toward : {0.0, 33.3, 90.0, 271.0}) {
        const CrestDirections found = crest_directions(std::vector<SandFlux>{{toward, 3.0}}, 1.6);
        ASSERT_EQ(found.bed_instability.size(), 1U);
        EXPECT_NEAR(found.bed_instability[0], std::fmod(toward + 90.0, 180.0), 1e-4);
        ASSERT_EQ(found.fingering.size(), 1U);
        EXPECT_NEAR(found.fingering[0], toward, 1e-4);
    }
}

TEST(CrestDirections, FiveEqualWindsGrowFiveArmsAndNoDrift) {
    std::vector<SandFlux> star;
    for (int wind = 0; wind < 5; ++wind) star.push_back({72.0 * wind, 1.0});
    EXPECT_EQ(drift_of(star).resultant, 0.0);
    EXPECT_TRUE(std::isnan(drift_of(star).toward));
    EXPECT_EQ(crest_directions(star, 1.6).fingering.size() % 5, 0U);
    EXPECT_EQ(crest_directions(star, 1.6).bed_instability.size() % 5, 0U);
}

TEST(CrestDirections, NoneAreFavouredWithoutSand) {
    const CrestDirections found = crest_directions({}, 1.6);
    EXPECT_TRUE(found.bed_instability.empty());
    EXPECT_TRUE(found.fingering.empty());
}

TEST(Drift, OfTwoWindsIsTheirVectorSum) {
    const Drift drift = drift_of(two_winds(2.0, 120.0));
    EXPECT_NEAR(drift.potential, 3.0, 1e-12);
    EXPECT_NEAR(drift.resultant, std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(drift.toward, 30.0, 1e-9);
}

}  // namespace
}  // namespace fumon
