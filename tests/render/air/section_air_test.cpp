#include "render/air/section_air.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

/// Four columns over beds of 0, 1, 2 and 1 node, six rows; pressure 10 + column, 0 in the bed.
Snapshot stepped() {
    Snapshot snapshot;
    snapshot.bed = Grid(4, 1);
    snapshot.scale = {0.5, 0.5, 0.25, true};
    auto section = std::make_shared<SnapshotSection>();
    section->dx = 0.5;
    section->dz = 0.25;
    section->fields = {{"velocity_x", "", "m/s", Grid(4, 6)}, {"pressure", "", "Pa", Grid(4, 6)}};
    for (int x = 0; x < 4; ++x) {
        const int bed = x == 3 ? 1 : x;
        snapshot.bed(x, 0) = bed;
        for (int z = bed + 1; z < 6; ++z) {
            section->fields[0].values(x, z) = z - bed;
            section->fields[1].values(x, z) = 10.0 + x;
        }
    }
    snapshot.section = section;
    return snapshot;
}

TEST(SectionAir, IsLinearBetweenNodesAndPeriodic) {
    const Snapshot snapshot = stepped();
    const SectionAir air(snapshot);
    const SnapshotField& velocity = *air.find("velocity_x");
    EXPECT_EQ(air.find("speed"), nullptr);
    EXPECT_DOUBLE_EQ(air.length(), 2.0);
    EXPECT_DOUBLE_EQ(air.height(), 1.25);
    EXPECT_DOUBLE_EQ(air.bed(0.25), 0.125);
    EXPECT_DOUBLE_EQ(air.bed(1.75), 0.125) << "between the last column and the first";
    EXPECT_DOUBLE_EQ(air.value(velocity, 0.0, 0.625), 2.5);
    EXPECT_DOUBLE_EQ(air.value(velocity, 0.25, 0.75), 2.5);
    EXPECT_DOUBLE_EQ(air.value(velocity, -1.75, 0.75), 2.5);
    for (const double z : {0.875, 1.125, 1.2}) {
        EXPECT_DOUBLE_EQ(air.value(velocity, 0.0, z), z / 0.25) << "higher than it is long";
        EXPECT_DOUBLE_EQ(air.value_of_air(velocity, 0.0, z), z / 0.25);
    }
    EXPECT_DOUBLE_EQ(air.value(velocity, 1.0, 9.0), 3.0) << "above the top";
}

/// 0.005 m round to five periods, but to a column just before their end: what is read outside the
/// field is seen by AddressSanitizer.
TEST(SectionAir, StaysInsideWhereRoundingLeavesItJustBeforeItsStart) {
    Snapshot snapshot;
    snapshot.bed = Grid(100, 1, 5.0);
    snapshot.scale = {1e-5, 1e-5, 1.0, true};
    auto section = std::make_shared<SnapshotSection>();
    section->dx = 1e-5;
    section->dz = 1e-5;
    snapshot.section = section;
    EXPECT_DOUBLE_EQ(SectionAir(snapshot).bed(0.005), 5.0);
}

TEST(SectionAir, TakesNoPressureFromTheBed) {
    const Snapshot snapshot = stepped();
    const SectionAir air(snapshot);
    const SnapshotField& pressure = *air.find("pressure");
    for (const double z : {0.0, 0.1, 0.5, 0.6, 1.25}) {
        EXPECT_DOUBLE_EQ(air.value_of_air(pressure, 1.0, z), 12.0) << z;
        EXPECT_DOUBLE_EQ(air.value_of_air(pressure, 0.75, z), 11.5) << z;
    }
    EXPECT_LT(air.value(pressure, 1.0, 0.6), 6.0);
}

}  // namespace
}  // namespace fumon
