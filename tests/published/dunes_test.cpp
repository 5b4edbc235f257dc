// Dunes against what is known of real ones: slip faces, proportions, speeds. A single heap of sand
// on bare rock becomes a barchan, under a wind along the grid or across it.

#include "models/dunes/dunes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "base/units.h"
#include "base/worker_pool.h"
#include "models/avalanche/slope_relaxation.h"

namespace fumon::test {
namespace {

/// A dune in coordinates along and across the wind, metres and years.
struct Shape {
    double height = 0.0;
    double width = 0.0;  ///< across the wind, of what is higher than a tenth of the height
    double along = 0.0;  ///< centroid of that
    double lee = 0.0;    ///< degrees: median over the lee side's steep cells
    double stoss = 0.0;  ///< degrees: mean over the upper stoss side
    double horns = 0.0;  ///< m by which the flanks' middles lie downwind of the whole's
};

Shape shape_of(const DuneBed& bed, double wind_x, double wind_y) {
    const int nx = bed.surface.nx();
    const int ny = bed.surface.ny();
    const auto height = [&](int x, int y) { return to_metres(bed.surface(x, y)); };
    Shape shape;
    for (const std::int64_t cell : bed.surface.values())
        shape.height = std::max(shape.height, to_metres(cell));
    double sand = 0.0;
    double least = 1e9;
    double most = -1e9;
    std::vector<double> lee;
    double stoss = 0.0;
    int stoss_cells = 0;
    for (int y = 1; y + 1 < ny; ++y) {
        for (int x = 1; x + 1 < nx; ++x) {
            const double here = height(x, y);
            constexpr double outline = 0.05;  // m
            if (here < outline) continue;
            least = std::min(least, y * wind_x - x * wind_y);
            most = std::max(most, y * wind_x - x * wind_y);
            if (here < 0.1 * shape.height) continue;
            sand += here;
            shape.along += here * (x * wind_x + y * wind_y);
            if (here < 0.3 * shape.height) continue;
            const double gx = 0.5 * (height(x + 1, y) - height(x - 1, y));
            const double gy = 0.5 * (height(x, y + 1) - height(x, y - 1));
            const double rise = gx * wind_x + gy * wind_y;
            const double steepness = std::atan(std::hypot(gx, gy)) * degrees_per_radian;
            constexpr double surely_lee = 20.0;
            if (rise < 0.0 && steepness > surely_lee) lee.push_back(steepness);
            if (rise > 0.0) {
                stoss += std::atan(rise) * degrees_per_radian;
                ++stoss_cells;
            }
        }
    }
    shape.along /= sand;
    shape.width = most - least;
    if (!lee.empty()) {
        const auto middle = lee.begin() + static_cast<std::ptrdiff_t>(lee.size() / 2);
        std::nth_element(lee.begin(), middle, lee.end());
        shape.lee = *middle;
    }
    shape.stoss = stoss / stoss_cells;
    return shape;
}

struct Barchan {
    Shape shape;
    double speed = 0.0;  ///< m/yr, over the last third
};

/// What becomes of a Gaussian heap of standard deviation `sigma`.
Barchan barchan(double from, double sigma, int side) {
    DunesParameters parameters;
    parameters.winds = {{from, 1.0, 1.0}};
    parameters.edges_x = DuneEdge::open;
    parameters.edges_y = DuneEdge::open;
    parameters.influx = 0.2;
    const double wind_x = -std::sin(from * degree);
    const double wind_y = -std::cos(from * degree);
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double dx = x - side * (0.5 - 0.25 * wind_x);
            const double dy = y - side * (0.5 - 0.25 * wind_y);
            const double height =
                0.36 * sigma * std::exp(-(dx * dx + dy * dy) / (2.0 * sigma * sigma));
            bed(x, y) = height < 0.02 ? 0.0 : height;
        }
    }
    WorkerPool pool;
    Dunes dunes(parameters, {std::move(bed), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    while (dunes.time() < 0.8) dunes.step();
    const Shape before = shape_of(dunes.bed(), wind_x, wind_y);
    const double then = dunes.time();
    while (dunes.time() < 1.2) dunes.step();
    Barchan result{shape_of(dunes.bed(), wind_x, wind_y)};
    result.speed = (result.shape.along - before.along) / (dunes.time() - then);
    std::printf("    from %3.0f: height %.2f m, width %.1f m, %.1f m/yr, lee %.1f, stoss %.1f\n",
                from, result.shape.height, result.shape.width, result.speed, result.shape.lee,
                result.shape.stoss);
    return result;
}

TEST(PublishedDunes, ABarchanHasNatureProportionsAlongTheGridAndAcross) {
    const Barchan along = barchan(270.0, 11.0, 192);
    const Barchan across = barchan(240.0, 11.0, 192);
    for (const Barchan& dune : {along, across}) {
        EXPECT_NEAR(dune.shape.lee, 33.0, 1.0);
        EXPECT_LE(dune.shape.stoss, 15.0);
        EXPECT_GT(dune.shape.height / dune.shape.width, 0.08);
        EXPECT_LT(dune.shape.height / dune.shape.width, 0.13);
    }
    EXPECT_NEAR(across.shape.height / along.shape.height, 1.0, 0.05);
    EXPECT_NEAR(across.shape.width / along.shape.width, 1.0, 0.05);
    EXPECT_NEAR(across.speed / along.speed, 1.0, 0.05);
}

TEST(PublishedDunes, ALargeConeIsRound) {
    constexpr int side = 260;
    WorkerPool pool;
    WholeGrid surface(side, side);
    const WholeGrid floor(side, side);
    SlopeRelaxation slopes({side, side, 1.0, 1.0, true, true}, {}, pool);
    for (int portion = 0; portion < 20; ++portion) {
        surface(side / 2, side / 2) += to_units(43'000.0);
        ASSERT_TRUE(slopes.relax(surface, floor, 1'000'000).at_rest);
    }
    double least = 1e9;
    double most = 0.0;
    double sum = 0.0;
    constexpr int directions = 360;
    for (int k = 0; k < directions; ++k) {  // where the cone ends, nearly
        const double angle = k * degree;
        const auto height = [&](double radius) {
            const double x = side / 2 + radius * std::cos(angle);
            const double y = side / 2 + radius * std::sin(angle);
            const int i = static_cast<int>(x);
            const int j = static_cast<int>(y);
            const double u = x - i;
            const double v = y - j;
            return (1 - v) *
                       ((1 - u) * to_metres(surface(i, j)) + u * to_metres(surface(i + 1, j))) +
                   v * ((1 - u) * to_metres(surface(i, j + 1)) +
                        u * to_metres(surface(i + 1, j + 1)));
        };
        double radius = 0.0;
        while (height(radius) > 3.5) radius += 0.02;
        least = std::min(least, radius);
        most = std::max(most, radius);
        sum += radius;
    }
    const double mean = sum / directions;
    std::printf("    radius %.1f cells, %.4f out of round\n", mean, (most - least) / mean);
    EXPECT_GE(mean, 100.0);
    EXPECT_LE((most - least) / mean, 0.02);
}

}  // namespace
}  // namespace fumon::test
