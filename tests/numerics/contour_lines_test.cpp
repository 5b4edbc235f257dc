#include "numerics/contour_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace fumon {
namespace {

/// Twice the area that a line goes around with it on the left.
double twice_area(const ContourLine& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
        sum += line.points[i - 1].x * line.points[i].y - line.points[i].x * line.points[i - 1].y;
    return sum;
}

Grid made(int nx, int ny, double (*height)(double, double)) {
    Grid grid(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) grid(x, y) = height(x, y);
    }
    return grid;
}

TEST(ContourLines, OfAConeAreCirclesWithItsTopOnTheLeft) {
    const Grid cone =
        made(101, 101, [](double x, double y) { return -std::hypot(x - 50.0, y - 50.0); });
    for (const double radius : {10.3, 25.0, 44.7}) {
        const auto lines = contour_lines(cone, {}, -radius);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_TRUE(lines[0].closed());
        for (const glm::dvec2& point : lines[0].points)
            EXPECT_NEAR(std::hypot(point.x - 50.0, point.y - 50.0), radius, 0.02);
        EXPECT_NEAR(0.5 * twice_area(lines[0]), std::numbers::pi * radius * radius,
                    0.01 * radius * radius);
    }
    const Grid pit =
        made(41, 41, [](double x, double y) { return std::hypot(x - 20.0, y - 20.0); });
    const auto around = contour_lines(pit, {}, 10.5);
    ASSERT_EQ(around.size(), 1U);
    EXPECT_LT(twice_area(around[0]), 0.0);
}

TEST(ContourLines, OfAPlaneAreStraightAndEndAtTheEdges) {
    const Grid plane = made(30, 20, [](double x, double y) { return x + 2.0 * y; });
    const auto lines = contour_lines(plane, {}, 30.4);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].closed());
    for (const glm::dvec2& point : lines[0].points)
        EXPECT_NEAR(point.x + 2.0 * point.y, 30.4, 1e-12);
    const glm::dvec2 ends = lines[0].points.front() + lines[0].points.back();
    EXPECT_NEAR(ends.x, 29.0 + 0.0, 1e-9);  // y from 15.2 at x = 0 to 0.7 at x = 29
    EXPECT_TRUE(contour_lines(plane, {}, 1e3).empty());
}

TEST(ContourLines, ASaddleJoinsWhatItsMiddleSays) {
    Grid saddle(2, 2);
    saddle(0, 0) = saddle(1, 1) = 1.0;
    saddle(1, 0) = saddle(0, 1) = 0.0;
    const auto turning = [&](double level) {
        const auto lines = contour_lines(saddle, {}, level);
        EXPECT_EQ(lines.size(), 2U);
        // Whether the first line cuts off the south-western corner.
        return lines[0].points[0].x + lines[0].points[0].y + lines[0].points[1].x +
                   lines[0].points[1].y <
               1.0;
    };
    EXPECT_TRUE(turning(0.75));   // the middle is lower: two hills
    EXPECT_FALSE(turning(0.25));  // higher: a ridge
}

TEST(ContourLines, KeepOffCellsOutsideTheDomain) {
    Grid plane = made(20, 20, [](double x, double /*y*/) { return x; });
    Mask nodata(20, 20, 0);
    nodata(10, 10) = 1;
    const auto lines = contour_lines(plane, nodata, 10.5);
    ASSERT_EQ(lines.size(), 2U);
    for (const ContourLine& line : lines) {
        for (const glm::dvec2& point : line.points) EXPECT_GE(std::abs(point.y - 10.0), 1.0);
    }
    plane(10, 10) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(contour_lines(plane, {}, 10.5).size(), 2U);
}

TEST(ContourInterval, IsRoundAndDrawsNoMoreThanAsked) {
    EXPECT_EQ(contour_interval(2000.0, 3300.0), 100.0);
    EXPECT_EQ(contour_interval(0.0, 16.0), 1.0);
    EXPECT_EQ(contour_interval(0.0, 17.0), 2.0);
    EXPECT_NEAR(contour_interval(-0.01, 0.023), 0.005, 1e-15);
    EXPECT_EQ(contour_interval(1.0, 1.0), 0.0);
    for (double range = 1e-3; range < 1e5; range *= 1.37) {
        const double interval = contour_interval(0.0, range);
        EXPECT_LE(range / interval, 16.0 + 1e-9);
        EXPECT_GE(range / interval, 6.0);
    }
}

}  // namespace
}  // namespace fumon
