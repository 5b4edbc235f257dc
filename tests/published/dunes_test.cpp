// Dunes against what is known of real ones: slip faces, proportions, speeds. A single heap of sand
// on bare rock becomes a barchan, under a wind along the grid or across it.

#include "models/dunes/dunes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "measure/bed/bed_statistics.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/dunes.h"
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
    const Barchan along = barchan(270.0, 11.0, 160);
    const Barchan across = barchan(240.0, 11.0, 160);
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

/// Growth by the linear theory at a wave number, 1/yr; see DuneSaturation.
double linear_growth(const DunesParameters& of, double length, double k) {
    const double lag = k * length;
    return of.flux * k * k *
           ((of.shear_ahead - of.shear_in_phase * lag) / (1.0 + lag * lag) - of.slope_drift);
}

/// Of a flat bed with noise of a millimetre, in which all waves are, those grow that theory says.
TEST(PublishedDunes, AFlatBedTakesTheWavelengthOfTheLinearTheory) {
    constexpr int nx = 1024;
    constexpr double length = 1.3;
    DunesParameters parameters;
    parameters.saturation_length = length;
    Grid bed(nx, 4);
    for (int x = 0; x < nx; ++x) {
        RandomStream stream(1, static_cast<std::uint32_t>(x), 0, Purpose::initial_bed);
        const double height = 1.0 + 0.001 * stream.uniform();
        for (int y = 0; y < 4; ++y) bed(x, y) = height;
    }
    WorkerPool pool;
    Dunes dunes(parameters, {std::move(bed), {}, {1.0, 1.0, 1.0, true}, 1, pool});
    while (dunes.time() < 1.6) dunes.step();
    double power_sum = 0.0;
    double k_sum = 0.0;
    for (int m = 5; m < nx / 6; ++m) {
        const double k = 2.0 * std::acos(-1.0) * m / nx;
        double real = 0.0;
        double imaginary = 0.0;
        for (int x = 0; x < nx; ++x) {
            real += to_metres(dunes.bed().surface(x, 1)) * std::cos(k * x);
            imaginary += to_metres(dunes.bed().surface(x, 1)) * std::sin(k * x);
        }
        power_sum += real * real + imaginary * imaginary;
        k_sum += k * (real * real + imaginary * imaginary);
    }
    double fastest = 0.1;
    for (double k = 0.1; k < 0.5; k += 1e-4) {
        if (linear_growth(parameters, length, k) > linear_growth(parameters, length, fastest))
            fastest = k;
    }
    const double measured = 2.0 * std::acos(-1.0) * power_sum / k_sum;
    const double theory = 2.0 * std::acos(-1.0) / fastest;
    std::printf("    wavelength %.2f m, by linear theory %.2f m\n", measured, theory);
    EXPECT_NEAR(measured / theory, 1.0, 0.05);
}

TEST(PublishedDunes, ALargeConeIsRound) {
    constexpr int side = 260;
    WorkerPool pool;
    FixedPointGrid surface(side, side);
    const FixedPointGrid floor(side, side);
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

Grid noisy_bed(int side, double low, double high) {
    Grid bed(side, side);
    for (int y = 0; y < side; ++y) {
        RandomStream stream(1, static_cast<std::uint32_t>(y), 0, Purpose::initial_bed);
        for (double& height : bed.row(y)) height = low + (high - low) * stream.uniform();
    }
    return bed;
}

Grid heights_of(const DuneBed& bed) {
    Grid grid(bed.surface.nx(), bed.surface.ny());
    std::ranges::transform(bed.surface.values(), grid.values().begin(), to_metres);
    return grid;
}

DunesParameters slabs(SlabOrder order) {
    DunesParameters parameters;
    parameters.transport = DuneTransport::slabs;
    parameters.speed_up = DuneSpeedUp::none;
    parameters.hop_length = 5.0;
    parameters.order = order;
    return parameters;
}

/// Little sand gathers into barchans, much into ridges, whether slabs hop all at once or one by
/// one.
TEST(PublishedDunes, SlabsMakeBarchansOfLittleSandAndRidgesOfMuch) {
    constexpr double slab = 1.0 / 3.0;
    for (const SlabOrder order : {SlabOrder::parallel, SlabOrder::sequential}) {
        WorkerPool pool;
        Dunes little(slabs(order),
                     {noisy_bed(96, 0.0, 4.0 * slab), {}, {1.0, 1.0, 1.0, true}, 1, pool});
        double downwind = 0.0;
        double with_horns = 0.0;
        for (int step = 1; step <= 200; ++step) {
            little.step();
            if (step < 140 || step % 20 != 0) continue;
            for (const Dune& dune : separate_dunes(heights_of(little.bed()), true).dunes) {
                if (std::isnan(dune.horn_lag)) continue;
                with_horns += 1.0;
                downwind += dune.horn_lag > 0.0 ? 1.0 : 0.0;
            }
        }
        Dunes much(slabs(order),
                   {noisy_bed(64, 11.5 * slab, 12.5 * slab), {}, {1.0, 1.0, 1.0, true}, 1, pool});
        const double sd = bed_statistics(heights_of(much.bed()), {}).standard_deviation;
        for (int step = 0; step < 120; ++step) much.step();
        const Grid ridges = heights_of(much.bed());
        const CrestOrientation crests = crest_orientation(ridges, true);
        const double grown = bed_statistics(ridges, {}).standard_deviation;
        std::printf(
            "    %s: horns downwind %.2f of %.0f; ridges %.0f degrees, coherence %.2f, "
            "deviation %.2f from %.2f m\n",
            order == SlabOrder::parallel ? "parallel" : "one by one", downwind / with_horns,
            with_horns, crests.degrees, crests.coherence, grown, sd);
        EXPECT_GE(downwind, 0.9 * with_horns);
        EXPECT_GE(with_horns, 5.0);
        EXPECT_GT(crests.coherence, 0.25);
        EXPECT_TRUE(separate_dunes(ridges, true).dunes.empty());
        EXPECT_LT(std::abs(crests.degrees), 15.0);
        EXPECT_GT(grown, 5.0 * sd);
    }
}

/// Harmonics 0 … 10 of the contour of a third of the height, about its middle, in parts of its mean
/// radius.
std::vector<double> contour_harmonics(const Grid& bed) {
    const double level = *std::ranges::max_element(bed.values()) / 3.0;
    double x0 = 0.0;
    double y0 = 0.0;
    double cells = 0.0;
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            if (bed(x, y) <= level) continue;
            x0 += x;
            y0 += y;
            cells += 1.0;
        }
    }
    constexpr int directions = 720;
    std::vector<double> real(11);
    std::vector<double> imaginary(11);
    for (int k = 0; k < directions; ++k) {
        const double angle = 2.0 * k * std::acos(-1.0) / directions;
        const auto height = [&](double radius) {
            const double x = x0 / cells + radius * std::cos(angle);
            const double y = y0 / cells + radius * std::sin(angle);
            const int i = static_cast<int>(x);
            const int j = static_cast<int>(y);
            const double u = x - i;
            const double v = y - j;
            return (1 - v) * ((1 - u) * bed(i, j) + u * bed(i + 1, j)) +
                   v * ((1 - u) * bed(i, j + 1) + u * bed(i + 1, j + 1));
        };
        double radius = 0.0;
        while (height(radius) > level) radius += 0.02;
        for (std::size_t n = 0; n < real.size(); ++n) {
            real[n] += radius * std::cos(static_cast<double>(n) * angle);
            imaginary[n] += radius * std::sin(static_cast<double>(n) * angle);
        }
    }
    std::vector<double> harmonics;
    for (std::size_t n = 0; n < real.size(); ++n)
        harmonics.push_back(2.0 * std::hypot(real[n], imaginary[n]) / real[0]);
    return harmonics;
}

/// Five winds at 72 degrees, in turn, make a star with as many corners of a round heap, and leave
/// it where it is.
TEST(PublishedDunes, FiveWindsMakeAStar) {
    constexpr int side = 64;
    constexpr double cell = 2.0;
    DunesParameters parameters;
    parameters.slope_drift = 0.2;
    parameters.time_step = 0.001;
    for (const double from : {270.0, 342.0, 54.0, 126.0, 198.0})
        parameters.winds.push_back({from, 1.0, 0.02});
    Grid heap(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const double radius = cell * std::hypot(x - 0.5 * (side - 1), y - 0.5 * (side - 1));
            if (radius < 44.0)
                heap(x, y) = 8.0 * std::pow(std::cos(radius / 88.0 * std::acos(-1.0)), 2);
        }
    }
    WorkerPool pool;
    Dunes dunes(parameters, {std::move(heap), {}, {cell, cell, 1.0, true}, 1, pool});
    for (int step = 0; step < 2000; ++step) dunes.step();
    const Grid star = heights_of(dunes.bed());
    const std::vector<double> harmonics = contour_harmonics(star);
    double x0 = 0.0;
    double y0 = 0.0;
    double sand = 0.0;
    double other = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            x0 += x * star(x, y);
            y0 += y * star(x, y);
            sand += star(x, y);
        }
    }
    for (std::size_t n = 1; n < harmonics.size(); ++n) {
        if (n != 5) other = std::max(other, harmonics[n]);
    }
    std::printf("    star: harmonic 5 %.3f, largest other %.3f; middle at %.2f, %.2f\n",
                harmonics[5], other, x0 / sand, y0 / sand);
    EXPECT_GT(harmonics[5], 0.02);
    EXPECT_GT(harmonics[5], 2.0 * other);
    EXPECT_NEAR(x0 / sand, 0.5 * (side - 1), 0.25) << "no drift";
    EXPECT_NEAR(y0 / sand, 0.5 * (side - 1), 0.25);
}

}  // namespace
}  // namespace fumon::test
