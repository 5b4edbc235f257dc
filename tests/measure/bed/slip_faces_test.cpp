#include "measure/bed/slip_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace fumon::test {
namespace {

/// A ridge across x: a gentle rise and a face of 10 cells that falls by 0.6 a metre, in shadow.
struct Ridge {
    Ridge() : bed(60, 8), shadow(60, 8) {
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 60; ++x) {
                bed(x, y) = x <= 30 ? 0.2 * x : std::max(0.0, 6.0 - 0.6 * (x - 30));
                shadow(x, y) = x > 30 && x < 50 ? 1.0 : 0.0;
            }
        }
    }
    Grid bed;
    Grid shadow;
};

TEST(SlipFaces, AreSteepAndInShadow) {
    const Ridge ridge;
    const SlipFaces faces = slip_faces(ridge.bed, ridge.shadow, true, 1.0, 1.0);
    EXPECT_NEAR(faces.angle, std::atan(0.6) * degrees_per_radian, 1e-9);
    EXPECT_NEAR(faces.cover, 9.0 / 60.0, 1e-12) << "the foot's centred gradient is 17 degrees";
    const SlipFaces inside = slip_faces(ridge.bed, ridge.shadow, false, 1.0, 1.0);
    EXPECT_NEAR(inside.cover, 9.0 * 6.0 / 480.0, 1e-12);
    const SlipFaces wide = slip_faces(ridge.bed, ridge.shadow, true, 1.5, 1.0);
    EXPECT_NEAR(wide.angle, std::atan(0.4) * degrees_per_radian, 1e-9);
}

TEST(SlipFaces, AreNoneWhereTheWindBlowsOrNothingIsSteep) {
    Ridge ridge;
    const SlipFaces gentle = slip_faces(ridge.bed, ridge.shadow, true, 2.0, 2.0);
    EXPECT_TRUE(std::isnan(gentle.angle));
    EXPECT_EQ(gentle.cover, 0.0);
    std::ranges::fill(ridge.shadow.values(), 0.9);
    EXPECT_EQ(slip_faces(ridge.bed, ridge.shadow, true, 1.0, 1.0).cover, 0.0);
}

}  // namespace
}  // namespace fumon::test
