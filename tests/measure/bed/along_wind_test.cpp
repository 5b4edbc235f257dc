// Beds under winds that do not blow toward +x are measured as they would be if they did.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "measure/bed/bed_along_wind.h"
#include "measure/bed/celerity.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/isolated_dunes.h"
#include "measure/suite.h"
#include "support/measured_beds.h"

namespace fumon {
namespace {

using test::turn;

Snapshot snapshot_of(Grid bed, std::int64_t step, std::vector<SnapshotWind> winds) {
    Snapshot snapshot;
    snapshot.step = step;
    snapshot.bed = std::move(bed);
    snapshot.scale = {1.0, 1.0, 1.0, true};
    snapshot.periodic = true;
    snapshot.winds = std::move(winds);
    snapshot.fields = {{"sand", "", "m", snapshot.bed}};
    return snapshot;
}

/// Two crescents of height 3 and 4 on bare ground, horns downwind, moved by some sites.
double crescents(double along, double across, double moved) {
    double height = 0.0;
    for (const auto& [x0, y0, size] : {std::array{20.0, -14.0, 3.0}, std::array{46.0, 12.0, 4.0}}) {
        const double y = (across - y0) / (2.4 * size);
        const double x = (along - x0 - moved - 1.2 * size * y * y) / (1.6 * size);
        height = std::max(height, size * (1.0 - x * x * (x > 0.0 ? 4.0 : 1.0) - 0.8 * y * y));
    }
    return height;
}

std::vector<double> measured(const std::vector<Snapshot>& snapshots, const std::string& name) {
    MeasureSuite suite(Landform::bed, snapshots.front());
    std::vector<double> values;
    for (const Snapshot& snapshot : snapshots) {
        const std::vector<double> row = suite.row(snapshot);
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (suite.columns()[k].name == name) values.push_back(row[k]);
        }
    }
    return values;
}

/// The field under a wind that blows toward an angle from +x, counterclockwise.
std::vector<Snapshot> field(double angle, int side) {
    const double c = std::abs(std::cos(angle)) < 1e-12 ? 0.0 : std::cos(angle);
    const double s = std::abs(std::sin(angle)) < 1e-12 ? 0.0 : std::sin(angle);
    std::vector<Snapshot> snapshots;
    for (const int step : {0, 4}) {
        const Grid bed = test::bed_of(side, side, [&](int i, int j) {
            const double x = i - 0.5 * (side - 1);
            const double y = j - 0.5 * (side - 1);
            return crescents(x * c + y * s + 32.0, y * c - x * s, 0.5 * step);
        });
        snapshots.push_back(snapshot_of(bed, step, {{c, s, 80.0}}));
    }
    return snapshots;
}

TEST(BedAlongWind, IsMeasuredAlikeUnderEveryWind) {
    constexpr int side = 96;
    const std::vector<Snapshot> east = field(0.0, side);
    for (const char* name : {"celerity", "dune_horn_lag", "dune_horns_downwind",
                             "stoss_to_lee_slope", "lone_dune_count", "lone_dune_horns_downwind",
                             "lone_dune_height_to_width", "crest_orientation"}) {
        SCOPED_TRACE(name);
        const double expected = measured(east, name).at(1);
        ASSERT_FALSE(std::isnan(expected));
        for (int quarter = 1; quarter < 4; ++quarter)
            EXPECT_NEAR(measured(field(quarter * turn / 4.0, side), name).at(1), expected, 1e-9);
        const double oblique = measured(field(0.6, side), name).at(1);
        const bool is_angle = std::string(name) == "crest_orientation";
        EXPECT_NEAR(oblique, expected, is_angle ? 2.0 : 0.35 * std::abs(expected));
    }
    EXPECT_NEAR(measured(east, "celerity").at(1), 0.5, 0.03);
    EXPECT_EQ(measured(east, "lone_dune_count").at(1), 2.0);
}

TEST(BedAlongWind, WavesAcrossAnObliqueWindHaveTheirLength) {
    // Normal (3, 4)/5, wavelength 12; the box takes whole waves of it.
    const auto bed = [](double moved) {
        return test::bed_of(60, 60, [=](int x, int y) {
            return 5.0 + std::cos(turn * (0.6 * x + 0.8 * y - moved) / 12.0);
        });
    };
    const std::vector<SnapshotWind> winds{{0.6, 0.8, 1.0}};
    const std::vector<Snapshot> both{snapshot_of(bed(0.0), 0, winds),
                                     snapshot_of(bed(2.5), 1, winds)};
    EXPECT_NEAR(measured(both, "wavelength_autocorrelation").at(1), 12.0, 0.2);
    EXPECT_NEAR(measured(both, "wavelength_crossings").at(1), 12.0, 0.3);
    EXPECT_NEAR(measured(both, "celerity").at(1), 2.5, 0.1);
    EXPECT_NEAR(measured(both, "crest_orientation").at(1), 0.0, 0.5);
    EXPECT_NEAR(measured(both, "crest_direction").at(1), 180.0 - 53.13 + 0.0, 0.5)
        << "clockwise from north: the normal points 36.9 degrees from it";
    EXPECT_NEAR(measured(both, "predicted_crests_gross_transport").at(1), 126.87, 0.1);
}

/// 30 m²/yr northward and 40 m²/yr eastward: 50 toward atan(40/30).
TEST(Drift, OfTwoWindsByHand) {
    const Grid bed = test::bed_of(20, 20, [](int x, int) { return 0.1 * x; });
    const Snapshot two = snapshot_of(bed, 0, {{0.0, 1.0, 30.0}, {1.0, 0.0, 40.0}});
    const std::vector<Snapshot> both{two, two};
    EXPECT_NEAR(measured(both, "drift_potential").at(1), 70.0, 1e-12);
    EXPECT_NEAR(measured(both, "resultant_drift_potential").at(1), 50.0, 1e-12);
    EXPECT_NEAR(measured(both, "rdp_dp").at(1), 50.0 / 70.0, 1e-12);
    EXPECT_NEAR(measured(both, "resultant_drift_direction").at(1), 53.130102, 1e-6);
    const Snapshot calm = snapshot_of(bed, 0, {{0.0, 1.0, 0.0}});
    const std::vector<Snapshot> calms{calm, calm};
    EXPECT_EQ(measured(calms, "drift_potential").at(1), 0.0);
    EXPECT_TRUE(std::isnan(measured(calms, "rdp_dp").at(1)));
    EXPECT_TRUE(std::isnan(measured(calms, "resultant_drift_direction").at(1)));
}

TEST(BedAlongWind, WindsThatCancelHaveNoDownwind) {
    std::vector<SnapshotWind> winds;
    for (int k = 0; k < 5; ++k)
        winds.push_back({std::cos(k * turn / 5), std::sin(k * turn / 5), 1});
    std::vector<Snapshot> both = field(0.0, 64);
    for (Snapshot& one : both) one.winds = winds;
    for (const char* name : {"celerity", "dune_horn_lag", "stoss_slope"})
        EXPECT_TRUE(std::isnan(measured(both, name).at(1))) << name;
    EXPECT_FALSE(downwind(both[0]).has_value());
    winds[2].drift = 1.2;
    both[0].winds = winds;
    ASSERT_TRUE(downwind(both[0]).has_value());
    EXPECT_NEAR(downwind(both[0])->x, std::cos(2 * turn / 5), 1e-9);
}

TEST(BedAlongWind, HeightsBetweenCellsFollowParabolas) {
    const Grid bed =
        test::bed_of(12, 10, [](int x, int y) { return 0.3 * x * x - x * y + 2.0 * y; });
    EXPECT_NEAR(height_between(bed, false, 5.25, 4.5), 0.3 * 5.25 * 5.25 - 5.25 * 4.5 + 9.0, 1e-12);
    EXPECT_NEAR(height_between(bed, true, 17.25, -5.5), height_between(bed, true, 5.25, 4.5),
                1e-12);
}

/// Two dunes that touch are no lone dunes; the third is, and its horns count though it is small.
TEST(IsolatedDunes, LeaveOutWhatTouches) {
    Grid bed(120, 80);
    const auto dome = [&](double x0, double y0, double height, double bend) {
        for (int y = 0; y < 80; ++y) {
            for (int x = 0; x < 120; ++x) {
                const double v = (y - y0) / (3.0 * height);
                const double u = (x - x0 - bend * v * v) / (2.0 * height);
                bed(x, y) = std::max(bed(x, y), height * (1.0 - u * u - v * v));
            }
        }
    };
    dome(30, 30, 5.0, -3.0);
    dome(38, 50, 5.0, -3.0);
    dome(90, 40, 1.5, 3.0);
    const IsolatedDunes found = isolated_dunes(bed, true, {});
    EXPECT_EQ(found.count, 1);
    EXPECT_EQ(found.share_horns_downwind, 1.0);
    EXPECT_NEAR(found.height_to_width, 1.5 / 9.0, 0.03);
    EXPECT_NEAR(found.height, 1.5, 0.05);
    EXPECT_EQ(found.width, 9.0) << "odd rows within 4.1 cells of its middle";
    EXPECT_EQ(found.length, 6.0) << "its horns trail";
    EXPECT_TRUE(std::isnan(found.volume_ratio)) << "there is no second one";
    EXPECT_EQ(separate_dunes(bed, true).dunes.size(), 1U) << "the small one lies below the level";
}

/// Blocks of sand under a wind toward −y: extents, and the second largest volume over the largest.
TEST(IsolatedDunes, HaveExtentsAcrossAndAlongTheWindAndARatioOfVolumes) {
    Grid bed(60, 40);
    const auto block = [&](int x0, int y0, int nx, int ny, double height) {
        for (int y = y0; y < y0 + ny; ++y) {
            for (int x = x0; x < x0 + nx; ++x) bed(x, y) = height;
        }
    };
    block(5, 5, 10, 20, 2.0);
    block(25, 5, 8, 12, 2.5);
    block(45, 5, 5, 6, 3.0);
    const IsolatedDunes found = isolated_dunes(bed, false, {{0.0, -1.0}, 1.5});
    EXPECT_EQ(found.count, 3);
    EXPECT_EQ(found.height, 2.5);
    EXPECT_EQ(found.width, 8.0);
    EXPECT_EQ(found.length, 1.5 * 11.0 + 1.0) << "rows are 1.5 columns' breadths wide";
    EXPECT_NEAR(found.volume_ratio, (8 * 12 * 2.5) / (10 * 20 * 2.0), 1e-12);
    EXPECT_TRUE(std::isnan(found.place)) << "of which?";
    std::ranges::fill(bed.values(), 0.0);
    block(25, 5, 8, 12, 2.5);
    EXPECT_NEAR(isolated_dunes(bed, false, {{0.0, -1.0}, 1.5}).place, -1.5 * 10.5, 1e-12);
    EXPECT_NEAR(isolated_dunes(bed, false, {}).place, 28.5, 1e-12);
}

TEST(IsolatedDunes, MoveDownwindOverOpenEdges) {
    std::vector<Snapshot> snapshots;
    for (const int moved : {0, 3, 10}) {
        const Grid bed = test::bed_of(60, 30, [&](int x, int y) {
            return std::max(0.0, 4.0 - 0.1 * std::hypot(x - 20.0 + moved, y - 15.0) *
                                           std::hypot(x - 20.0 + moved, y - 15.0));
        });
        snapshots.push_back(snapshot_of(bed, 2 * moved, {{-1.0, 0.0, 80.0}}));
        snapshots.back().periodic = false;
    }
    const std::vector<double> speed = measured(snapshots, "lone_dune_speed");
    EXPECT_TRUE(std::isnan(speed.at(0)));
    EXPECT_NEAR(speed.at(1), 0.5, 1e-9);
    EXPECT_NEAR(speed.at(2), 0.5, 1e-9);
    for (Snapshot& snapshot : snapshots) snapshot.periodic = true;
    EXPECT_TRUE(std::isnan(measured(snapshots, "lone_dune_speed").at(2))) << "celerity says it";
}

}  // namespace
}  // namespace fumon
