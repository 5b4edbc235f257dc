// Slope, aspect and shaded relief of grounds whose answers are known, and as GDAL has them.

#include "measure/raster/ground_gradient.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace fumon::test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

template <class Height>
Grid ground_of(int nx, int ny, Height height) {
    Grid ground(nx, ny);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x) ground(x, y) = height(x, y);
    return ground;
}

/// A plane that rises by `rise` over its length, toward `azimuth`.
Grid plane(double dx, double dy, double azimuth, double rise) {
    return ground_of(7, 6, [&](int x, int y) {
        return 100.0 +
               rise * (std::sin(azimuth * degree) * x * dx + std::cos(azimuth * degree) * y * dy);
    });
}

double turn_between(double one, double other) {
    return std::abs(std::remainder(one - other, 360.0));
}

TEST(GroundGradient, APlaneHasItsSlopeAndAspectEverywhere) {
    for (const double dy : {10.0, 25.0}) {
        for (int eighth = 0; eighth < 8; ++eighth) {
            const double up = 45.0 * eighth;
            const auto gradient = ground_gradient(plane(10.0, dy, up, 0.5), {}, 10.0, dy);
            const Grid slope = slope_degrees(gradient);
            const Grid ratio = slope_ratio(gradient);
            const Grid aspect = aspect_degrees(gradient);
            for (std::size_t cell = 0; cell < slope.size(); ++cell) {  // edges and corners too
                EXPECT_NEAR(slope.values()[cell], std::atan(0.5) / degree, 1e-10);
                EXPECT_NEAR(ratio.values()[cell], 0.5, 1e-12);
                EXPECT_LT(turn_between(aspect.values()[cell], up + 180.0), 1e-10);
                EXPECT_GE(aspect.values()[cell], 0.0);
                EXPECT_LT(aspect.values()[cell], 360.0);
            }
            EXPECT_EQ(without_aspect(gradient), Mask(7, 6));
        }
    }
}

TEST(GroundGradient, AConeFacesOutwardAndIsAsSteepEverywhere) {
    constexpr double dx = 2.0;
    constexpr double dy = 3.0;
    const Grid cone = ground_of(
        81, 61, [&](int x, int y) { return -0.4 * std::hypot((x - 40) * dx, (y - 30) * dy); });
    const auto gradient = ground_gradient(cone, {}, dx, dy);
    const Grid slope = slope_ratio(gradient);
    const Grid aspect = aspect_degrees(gradient);
    for (int y = 0; y < 61; ++y) {
        for (int x = 0; x < 81; ++x) {
            const double east = (x - 40) * dx;
            const double north = (y - 30) * dy;
            if (std::hypot(east, north) < 30.0) continue;
            const double outward = std::atan2(east, north) / degree;
            EXPECT_NEAR(slope(x, y), 0.4, 0.02) << x << " " << y;
            EXPECT_LT(turn_between(aspect(x, y), outward), 2.5) << x << " " << y;
        }
    }
}

TEST(GroundGradient, LevelGroundFacesNowhere) {
    const auto gradient = ground_gradient(Grid(4, 3, 7.0), {}, 1.0, 1.0);
    EXPECT_EQ(without_aspect(gradient), Mask(4, 3, 1));
    EXPECT_EQ(gradient.unknown, Mask(4, 3));
    const Grid shades = hillshade(gradient, {});
    for (const double shade : shades.values())
        EXPECT_NEAR(shade, 1.0 + 254.0 * std::sin(45.0 * degree), 1e-10);
}

TEST(GroundGradient, CellsWithoutDataDoNotCount) {
    Grid ground = plane(10.0, 25.0, 30.0, 0.5);
    Mask nodata(7, 6);
    for (const auto& [x, y] : {std::pair{3, 3}, {3, 2}, {0, 1}, {5, 0}, {6, 1}}) {
        nodata(x, y) = 1;
        ground(x, y) = -9999.0;
    }
    const auto gradient = ground_gradient(ground, nodata, 10.0, 25.0);
    const Grid slope = slope_ratio(gradient);
    for (std::size_t cell = 0; cell < slope.size(); ++cell) {
        const bool isolated = cell == 6;  // its three neighbours: one has data
        EXPECT_EQ(gradient.unknown.values()[cell], nodata.values()[cell]);
        if (nodata.values()[cell] == 0 && !isolated) {
            EXPECT_NEAR(slope.values()[cell], 0.5, 1e-12) << cell;
        }
    }
    Mask alone(7, 6, 1);
    alone(2, 2) = 0;
    const auto lonely = ground_gradient(ground, alone, 10.0, 25.0);
    EXPECT_EQ(lonely.unknown(2, 2), 1) << "no neighbour has data";
}

TEST(GroundGradient, ARowIsLevelAcross) {
    const auto row = ground_gradient(ground_of(5, 1, [](int x, int) { return 3.0 * x; }), {}, 2, 2);
    const Grid slopes = slope_ratio(row);
    for (const double slope : slopes.values()) EXPECT_DOUBLE_EQ(slope, 1.5);
    // Two cells that touch by a corner, (3, 4) apart and 10 in height.
    Grid two(2, 2);
    two(1, 1) = 10.0;
    Mask nodata(2, 2);
    nodata(1, 0) = nodata(0, 1) = 1;
    const auto corner = ground_gradient(two, nodata, 3.0, 4.0);
    EXPECT_NEAR(corner.x(0, 0), 2.0 * 0.6, 1e-12);
    EXPECT_NEAR(corner.y(0, 0), 2.0 * 0.8, 1e-12);
}

/// The inner cells of a ground of 5 by 4 cells of 10 by 16, north row first, as gdaldem 3.6 shows
/// them.
class AsGdal : public ::testing::Test {
  protected:
    static Grid ground() {
        const std::vector<double> rows{10, 12, 15, 13, 9,  11, 16, 20, 18, 12,
                                       14, 19, 25, 30, 17, 20, 18, 17, 16, 15};
        return ground_of(5, 4, [&](int x, int y) {
            return rows[5 * static_cast<std::size_t>(3 - y) + static_cast<std::size_t>(x)];
        });
    }
    static void expect(const Grid& found, const std::array<double, 6>& gdal, double within) {
        for (std::size_t k = 0; k < gdal.size(); ++k) {
            const int x = 1 + static_cast<int>(k % 3);
            const int y = 2 - static_cast<int>(k / 3);
            EXPECT_NEAR(found(x, y), gdal.at(k), within) << x << " " << y;
        }
    }
};

TEST_F(AsGdal, Hillshade) {
    const auto gradient = ground_gradient(ground(), {}, 10.0, 16.0);
    expect(hillshade(gradient, {}), {237, 232, 162, 221, 202, 129}, 0.5);
    expect(hillshade(gradient, {200.0, 20.0, 2.0}), {43, 1, 1, 90, 134, 41}, 0.5);
}

TEST_F(AsGdal, SlopeAndAspect) {
    expect(slope_degrees(ground_gradient(ground(), {}, 10.0, 16.0)),
           {25.5474377, 21.6876392, 28.9368420, 19.7285100, 15.5873175, 18.0818062}, 2e-5);
    // Of square cells: gdaldem does not ask how large they are.
    expect(aspect_degrees(ground_gradient(ground(), {}, 10.0, 10.0)),
           {309.4724731, 340.0169067, 29.9816399, 289.6538086, 254.7448883, 98.7461624}, 2e-5);
}

}  // namespace
}  // namespace fumon::test
