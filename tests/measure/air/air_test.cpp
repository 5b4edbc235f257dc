#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "measure/air/air_extremes.h"
#include "measure/air/eddy.h"
#include "measure/air/profile_under_air.h"
#include "measure/air/stress_lead.h"
#include "numerics/stress_fit.h"
#include "support/measured_beds.h"

namespace fumon::test {
namespace {

constexpr double dx = 0.5;
constexpr double dz = 0.25;

/// `waves` waves of height 2 over 80 columns of 0.5 m, with a crest at column `crest`.
Snapshot wavy(int waves, double crest = 0.0) {
    Snapshot snapshot;
    snapshot.scale = {dx, dx, 1.0, true};
    snapshot.bed =
        bed_of(80, 1, [=](int x, int) { return 1.0 + std::cos(turn * waves * (x - crest) / 80); });
    SnapshotSection section;
    section.dx = dx;
    section.dz = dz;
    snapshot.section = std::make_shared<const SnapshotSection>(section);
    return snapshot;
}

std::vector<double> wave(int n, int waves, double mean, double amplitude, double phase) {
    std::vector<double> curve;
    curve.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        curve.push_back(mean + amplitude * std::cos(turn * waves * i / n + phase));
    return curve;
}

TEST(StressFit, FindsTheWaveThatIsThere) {
    for (const double phase : {-3.0, -0.4, 0.0, 0.22, 1.6, 3.1}) {
        const StressFit fit = fit_stress(wave(100, 1, 0.0095, 0.0112, phase), 1);
        EXPECT_NEAR(fit.mean, 0.0095, 1e-15);
        EXPECT_NEAR(fit.amplitude, 0.0112, 1e-15);
        EXPECT_NEAR(fit.phase, phase, 1e-12);
        EXPECT_NEAR(fit.r_squared, 1.0, 1e-12);
    }
    EXPECT_NEAR(fit_stress(wave(99, 3, 1.0, 0.5, 0.7), 3).phase, 0.7, 1e-12);
}

TEST(StressFit, LeavesOverWhatIsNoSuchWave) {
    std::vector<double> curve = wave(90, 1, 2.0, 3.0, 0.5);
    const std::vector<double> other = wave(90, 4, 0.0, 1.5, 0.1);
    for (std::size_t i = 0; i < curve.size(); ++i) curve[i] += other[i];
    const StressFit fit = fit_stress(curve, 1);
    EXPECT_NEAR(fit.amplitude, 3.0, 1e-12);
    EXPECT_NEAR(fit.r_squared, 0.8, 1e-12) << "9 / (9 + 2.25)";
    EXPECT_NEAR(fit_stress(curve, 4).r_squared, 0.2, 1e-12);
    EXPECT_TRUE(std::isnan(fit_stress(std::vector<double>(50, 3.0), 1).phase));
    EXPECT_EQ(fit_stress(std::vector<double>(50, 3.0), 1).mean, 3.0);
    EXPECT_TRUE(std::isnan(fit_stress(curve, 45).mean)) << "too short a wave";
    EXPECT_TRUE(std::isnan(fit_stress(curve, 0).mean));
}

TEST(StressLead, IsUpwindOfTheCrestWhereverThatIs) {
    for (const double crest : {0.0, 7.0, 31.0}) {
        const Snapshot snapshot = wavy(2, crest);
        const ProfileUnderAir bed = profile_under_air(snapshot, 20);
        EXPECT_EQ(bed.waves, 2);
        EXPECT_NEAR(bed.wavelength, 20.0, 1e-12);
        EXPECT_NEAR(bed.crest, std::fmod(crest * dx, 20.0), 1e-9);
        EXPECT_NEAR(bed.from_crest(crest * dx + 1.5), 1.5, 1e-9);
        EXPECT_NEAR(bed.from_crest(crest * dx + 19.0), -1.0, 1e-9);
        const double phase = -turn * 2 * crest / 80 + turn / 12;
        const StressLead lead = stress_lead(wave(80, 2, 1.0, 0.3, phase), bed, dx);
        EXPECT_NEAR(lead.degrees, 30.0, 1e-9);
        EXPECT_NEAR(lead.length, 20.0 / 12, 1e-9);
        EXPECT_NEAR(lead.r_squared, 1.0, 1e-12);
        EXPECT_NEAR(lead.maximum_from_crest, -20.0 / 12, 0.01);
    }
    Snapshot level = wavy(1);
    level.bed = Grid(80, 1, 0.5);
    const StressLead none =
        stress_lead(wave(80, 1, 1.0, 0.3, 0.2), profile_under_air(level, 20), dx);
    EXPECT_TRUE(std::isnan(none.degrees));
}

TEST(ProfileUnderAir, ANodeOnTheBedIsNotAboveIt) {
    Snapshot snapshot = wavy(1);
    snapshot.bed = Grid(80, 1, 0.0);
    snapshot.bed(3, 0) = 4 * dz;
    snapshot.bed(4, 0) = 4 * dz * (1.0 + 1e-12);
    snapshot.bed(5, 0) = 3.9 * dz;
    snapshot.bed(6, 0) = 1000.0;
    const ProfileUnderAir bed = profile_under_air(snapshot, 20);
    EXPECT_EQ(bed.lowest_air[0], 1);
    EXPECT_EQ(bed.lowest_air[3], 5);
    EXPECT_EQ(bed.lowest_air[4], 5);
    EXPECT_EQ(bed.lowest_air[5], 4);
    EXPECT_EQ(bed.lowest_air[6], 20);
}

TEST(Eddy, IsTheLongestStretchThatFlowsBack) {
    Snapshot snapshot = wavy(1);
    snapshot.bed = Grid(80, 1, 2 * dz);
    const ProfileUnderAir bed = profile_under_air(snapshot, 20);
    Grid u(80, 20, 1.0);
    for (int k = 0; k < 3; ++k) {
        for (double& velocity : u.row(k)) velocity = k < 2 ? -5.0 : 1.0;  // within the bed
    }
    EXPECT_EQ(largest_eddy(u, bed, dx, dz).length, 0.0);
    for (int i = 30; i < 33; ++i) u(i, 9) = -0.2;
    for (int i = 77; i < 82; ++i) u(i % 80, 3) = -0.1;  // round the edge
    u(79, 5) = -0.1;
    u(50, 12) = -1e-15;
    const Eddy eddy = largest_eddy(u, bed, dx, dz);
    EXPECT_NEAR(eddy.length, 5 * dx, 1e-14);
    EXPECT_NEAR(eddy.height, 3 * dz, 1e-14) << "node 5 over a bed at node 2";
    EXPECT_NEAR(largest_eddy(Grid(80, 20, -1.0), bed, dx, dz).length, 80 * dx, 1e-12);
}

TEST(AirExtremes, DivergenceIsThatOfALinearFlow) {
    Snapshot snapshot = wavy(1);
    snapshot.bed = Grid(80, 1, 2 * dz);
    const ProfileUnderAir bed = profile_under_air(snapshot, 20);
    const Grid u(80, 20, 3.0);
    const Grid w = bed_of(80, 20, [](int, int k) { return 0.5 * k * dz; });
    const AirExtremes flow = air_extremes(u, w, bed, dx, dz);
    EXPECT_NEAR(flow.largest_divergence, 0.5, 1e-12);
    EXPECT_NEAR(flow.largest_speed, std::hypot(3.0, 0.5 * 19 * dz), 1e-12);
    Grid stepped = u;
    for (double& velocity : stepped.row(1)) velocity = 900.0;  // within the bed
    stepped(10, 4) = 3.5;
    EXPECT_NEAR(air_extremes(stepped, Grid(80, 20), bed, dx, dz).largest_divergence, 0.5, 1e-12)
        << "0.5 m/s over two columns of 0.5 m";
}

TEST(BedPressureExtremes, IsToldWithItsSideOfTheCrest) {
    const Snapshot snapshot = wavy(1, 20.0);
    const ProfileUnderAir bed = profile_under_air(snapshot, 20);
    Grid pressure = bed_of(80, 20, [&](int i, int k) {
        return k == bed.lowest_air[static_cast<std::size_t>(i)] ? std::cos(turn * (i - 12) / 80)
                                                                : 100.0 * (k % 2 == 0 ? 1.0 : -1.0);
    });
    const BedPressureExtremes found = bed_pressure(pressure, bed, dx);
    EXPECT_NEAR(found.highest, 1.0, 1e-12);
    EXPECT_NEAR(found.highest_from_crest, -4.0, 1e-9) << "eight columns upwind: stoss";
    EXPECT_NEAR(found.lowest, -1.0, 1e-12);
    EXPECT_NEAR(found.lowest_from_crest, 16.0, 1e-9) << "lee";
}

}  // namespace
}  // namespace fumon::test
