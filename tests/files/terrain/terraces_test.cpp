// Heights rounded to whole steps: the step is found, the terraces go, and nothing else changes.

#include "files/terrain/terraces/terraces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>

#include "files/terrain/esri_ascii.h"

namespace fumon::test {
namespace {

template <class Height>
Terrain terrain_of(int nx, int ny, Height height) {
    Terrain terrain;
    terrain.heights = Grid(nx, ny);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) terrain.heights(x, y) = height(x, y);
    terrain.dx = terrain.dy = 10.0;
    return terrain;
}

Terrain rounded(Terrain terrain, double step) {
    for (double& height : terrain.heights.values()) height = step * std::round(height / step);
    return terrain;
}

/// Of the differences between neighbours from those of the truth, along both axes.
double slope_error(const Grid& heights, const Grid& truth) {
    double sum = 0.0;
    std::size_t count = 0;
    const auto add = [&](int x, int y, int u, int v) {
        const double error = (heights(u, v) - heights(x, y)) - (truth(u, v) - truth(x, y));
        sum += error * error;
        ++count;
    };
    for (int y = 0; y + 1 < truth.ny(); ++y) {
        for (int x = 0; x + 1 < truth.nx(); ++x) {
            add(x, y, x + 1, y);
            add(x, y, x, y + 1);
        }
    }
    return std::sqrt(sum / static_cast<double>(count));
}

double largest_move(const Grid& one, const Grid& other) {
    double largest = 0.0;
    for (std::size_t cell = 0; cell < one.size(); ++cell)
        largest = std::max(largest, std::abs(one.values()[cell] - other.values()[cell]));
    return largest;
}

Terrain slope() {
    return terrain_of(96, 80, [](int x, int y) { return 300.0 + 0.083 * x + 0.041 * y; });
}

Terrain hills() {
    return terrain_of(120, 100, [](int x, int y) {
        return 300.0 + 9.0 * std::sin(0.06 * x + 0.4) * std::cos(0.05 * y) + 0.05 * x;
    });
}

TEST(Terraces, TheStepIsFound) {
    for (const double step : {1.0, 0.3048, 1200.0 / 3937.0, 0.5, 0.1, 2.0, 10.0})
        EXPECT_NEAR(height_step(rounded(hills(), step)).value_or(0.0), step, 1e-6) << step;
    Terrain scaled = rounded(hills(), 0.37);
    EXPECT_FALSE(height_step(scaled));
    scaled.metres_per_number = 0.37;
    EXPECT_NEAR(height_step(scaled).value_or(0.0), 0.37, 1e-9);
    EXPECT_FALSE(height_step(hills()));
    EXPECT_FALSE(height_step(terrain_of(4, 4, [](int, int) { return 3.0; })));
    // Feet in single precision.
    Terrain feet = rounded(hills(), 0.3048);
    for (double& height : feet.heights.values()) height = static_cast<float>(height);
    EXPECT_NEAR(height_step(feet).value_or(0.0), 0.3048, 1e-6);
}

TEST(Terraces, OnlyWhatIsSeenIsPointedAt) {
    EXPECT_TRUE(has_terraces(rounded(hills(), 1.0), 1.0));
    EXPECT_FALSE(has_terraces(terrain_of(30, 40, [](int x, int) { return x / 2; }), 1.0))
        << "small";
    EXPECT_FALSE(has_terraces(terrain_of(40, 40, [](int x, int) { return x / 8; }), 1.0)) << "flat";
    EXPECT_FALSE(has_terraces(terrain_of(40, 40, [](int x, int) { return x; }), 1.0)) << "steep";
}

TEST(Terraces, ASlopeComesBack) {
    const Grid truth = slope().heights;
    const Terrain terraced = rounded(slope(), 1.0);
    const Grid smooth = without_terraces(terraced, 1.0, 10.0, 10.0);
    EXPECT_LE(largest_move(smooth, terraced.heights), 0.5);
    EXPECT_LT(largest_move(smooth, truth), 0.5);
    EXPECT_LT(slope_error(smooth, truth), 0.2 * slope_error(terraced.heights, truth));
}

TEST(Terraces, HillsComeBackInFeetAndOnOblongCells) {
    const Grid truth = hills().heights;
    const Terrain terraced = rounded(hills(), 0.3048);
    const Grid smooth = without_terraces(terraced, 0.3048, 10.0, 14.0);
    EXPECT_LE(largest_move(smooth, terraced.heights), 0.5 * 0.3048 + 1e-12);
    EXPECT_LT(slope_error(smooth, truth), 0.2 * slope_error(terraced.heights, truth));
}

TEST(Terraces, HolesStayAndDoNotCount) {
    Terrain terraced = rounded(slope(), 1.0);
    terraced.nodata = Mask(96, 80);
    for (int y = 20; y < 60; ++y) {
        for (int x = 30; x < 50; ++x) {
            terraced.nodata(x, y) = 1;
            terraced.heights(x, y) = 0.0;
        }
    }
    terraced.nodata(0, 0) = 1;
    terraced.heights(0, 0) = 0.0;
    EXPECT_EQ(height_step(terraced).value_or(0.0), 1.0);
    const Grid smooth = without_terraces(terraced, 1.0, 10.0, 10.0);
    const Grid truth = slope().heights;
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 96; ++x) {
            if (terraced.nodata(x, y) != 0)
                EXPECT_EQ(smooth(x, y), 0.0);
            else
                EXPECT_NEAR(smooth(x, y), truth(x, y), 0.5);
        }
    }
}

TEST(Terraces, WideWaterStaysLevel) {
    // A bowl with a lake of 30 cells across.
    const Terrain bowl = rounded(terrain_of(90, 90,
                                            [](int x, int y) {
                                                const double r = std::hypot(x - 45.0, y - 45.0);
                                                return r < 15.0 ? 100.0 : 100.0 + 0.12 * (r - 11.0);
                                            }),
                                 1.0);
    const Grid smooth = without_terraces(bowl, 1.0, 10.0, 10.0);
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 90; ++x) {
            if (bowl.heights(x, y) == 100.0) {
                EXPECT_EQ(smooth(x, y), 100.0) << x << " " << y;
            }
        }
    }
    EXPECT_NE(smooth(45, 75), bowl.heights(45, 75));
    // A terrace as wide has lower ground on one side: it goes.
    const Terrain step = rounded(terrain_of(90, 90, [](int x, int) { return 0.04 * x; }), 1.0);
    const Grid sloped = without_terraces(step, 1.0, 10.0, 10.0);
    EXPECT_GT(sloped(60, 40) - sloped(40, 40), 0.7);
}

TEST(Terraces, TheSameTerrainGivesTheSameHeights) {
    const Terrain terraced = rounded(hills(), 1.0);
    const Grid once = without_terraces(terraced, 1.0, 10.0, 14.0);
    EXPECT_EQ(once, without_terraces(terraced, 1.0, 10.0, 14.0));
}

}  // namespace
}  // namespace fumon::test
