// Barchans whose hops come down slopes across the wind, against those of the field and what is
// known of their collisions. The figures barchan-proportions and barchan-collisions have more of
// both.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "base/units.h"
#include "base/worker_pool.h"
#include "measure/bed/isolated_dunes.h"
#include "models/dunes/dunes.h"

namespace fumon::test {
namespace {

/// Heaps of sand on bare rock between open edges north and south.
DunesParameters deflected(std::vector<DuneFeature> heaps) {
    DunesParameters dunes;
    dunes.saturation_length = 1.3;
    dunes.slope_deflection = 0.2;
    dunes.edges_y = DuneEdge::open;
    dunes.influx = 0.2;
    dunes.features = std::move(heaps);
    return dunes;
}

DuneFeature heap(double x, double y, double length, double height) {
    return {FeatureKind::sand, FeatureShape::hill, x, y, length, length, height, 90.0};
}

IsolatedDunes dunes_of(const Dunes& model, bool periodic) {
    const FixedPointGrid& surface = model.bed().surface;
    Grid sand(surface.nx(), surface.ny());
    std::ranges::transform(surface.values(), sand.values().begin(), to_metres);
    return isolated_dunes(sand, periodic, {});
}

/// Widths of W = 8.6 H + 8.8 m (Andreotti et al. 2002, quoted), a height of about a tenth of them
/// (Hesp & Hastings 1998), and speeds of one law Q / (H + H0), H0 = 1.58 m by nine barchans.
TEST(PublishedDunes, BarchansHaveFieldWidthsAndSpeedsThatFallAsOneOverTheirHeight) {
    struct Size {
        double length, height;  ///< m, of the heap
        double cell;            ///< m
        int nx, ny, steps;
    };
    for (const Size& size :
         {Size{40.0, 4.0, 1.0, 110, 60, 1600}, Size{92.0, 11.5, 2.0, 95, 58, 3600}}) {
        WorkerPool pool(1);
        DunesParameters dunes = deflected(
            {heap(0.75 * size.length, 0.5 * size.cell * size.ny, size.length, size.height)});
        dunes.edges_x = DuneEdge::open;
        Dunes model(dunes,
                    {Grid(size.nx, size.ny), {}, {size.cell, size.cell, 1.0, true}, 1, pool});
        for (int step = 0; step < size.steps - 300; ++step) model.step();
        const double place = dunes_of(model, false).place;
        const double then = model.time();
        for (int step = 0; step < 300; ++step) model.step();
        const IsolatedDunes barchan = dunes_of(model, false);
        ASSERT_EQ(barchan.count, 1);
        const double width = size.cell * barchan.width;
        const double speed = size.cell * (barchan.place - place) / (model.time() - then);
        const double predicted_speed = 326.0 / (barchan.height + 1.58);
        std::printf("    height %.2f m, width %.0f m, %.1f m/yr (%.1f by the law)\n",
                    barchan.height, width, speed, predicted_speed);
        EXPECT_NEAR(width / (8.6 * barchan.height + 8.8), 1.0, 0.15);
        EXPECT_NEAR(barchan.height / width, 0.1, 0.02);
        EXPECT_NEAR(speed / predicted_speed, 1.0, 0.05);
    }
}

/// The barchans 1.8 years after a heap of 24 m and so much height began to follow one of 42 m and
/// 2,000 m³ in line with it.
IsolatedDunes after_collision(double height) {
    WorkerPool pool(1);
    Dunes model(deflected({heap(16.0, 38.0, 24.0, height), heap(56.0, 38.0, 42.0, 5.0)}),
                {Grid(95, 38), {}, {2.0, 2.0, 1.0, true}, 1, pool});
    while (model.time() < 1.8) model.step();
    return dunes_of(model, true);
}

/// A small one is taken in; of one half as large a dune leaves in front, larger beside the other
/// than the one that came was when they touched (.35). Both are known of models and of dunes under
/// water (Katsuki et al. 2005; Durán et al. 2005).
TEST(PublishedDunes, ASmallBarchanMergesAndOneHalfAsLargeIsExchanged) {
    const IsolatedDunes merged = after_collision(1.9);
    const IsolatedDunes exchanged = after_collision(7.5);
    std::printf(
        "    ratio of 1/8: %lld dune, %.2f m high; of 1/2: %lld dunes, ratio %.2f after it\n",
        static_cast<long long>(merged.count), merged.height,
        static_cast<long long>(exchanged.count), exchanged.volume_ratio);
    EXPECT_EQ(merged.count, 1);
    EXPECT_EQ(exchanged.count, 2);
    EXPECT_NEAR(exchanged.volume_ratio, 0.45, 0.15);
}

}  // namespace
}  // namespace fumon::test
