// The bed where the plane ends: walls, open edges, cells without data.

#include "models/water/sediment.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

WaterDomain walled(Mask nodata = {}) {
    WaterDomain domain;
    domain.dx = 1.0;
    domain.dy = 2.0;
    domain.edges_x = EdgeKind::wall;
    domain.edges_y = EdgeKind::open;
    domain.nodata = std::move(nodata);
    return domain;
}

/// A hole in the middle and a corner cut off.
Mask holes(int nx, int ny) {
    Mask nodata(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const bool hole = std::abs(x - nx / 2) <= 1 && std::abs(y - ny / 2) <= 2;
            nodata(x, y) = hole || x + y < 4 ? 1 : 0;
        }
    }
    return nodata;
}

Water streaming(int nx, int ny) {
    Water water{Grid(nx, ny, 0.02), Grid(nx, ny), Grid(nx, ny)};
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (x < 5) {
                water.depth(x, y) = 0.0;  // dry, at rest
                continue;
            }
            water.velocity_x(x, y) = 0.2 + 0.01 * ((7 * x + 3 * y) % 11);
            water.velocity_y(x, y) = -0.4 - 0.02 * ((5 * x + 2 * y) % 13);
        }
    }
    return water;
}

double volume(const Grid& bed, const Mask& nodata) {
    double sum = 0.0;
    for (std::size_t i = 0; i < bed.size(); ++i)
        if (nodata.empty() || nodata.values()[i] == 0) sum += bed.values()[i];
    return 2.0 * sum;
}

TEST(SedimentEdges, DiffusionKeepsTheVolumeAndLevelsTheBed) {
    for (const Mask& nodata : {Mask{}, holes(20, 17)}) {
        GullyParameters gully;
        gully.transport = SedimentTransport::none;
        gully.bed_diffusion = 5.0;
        WorkerPool pool(2);
        Sediment sediment(gully, walled(nodata), 20, 17, pool);
        Grid bed = noise(20, 17, 1.0);
        const Grid start = bed;
        const double before = volume(bed, nodata);
        const Water still{Grid(20, 17), Grid(20, 17), Grid(20, 17)};
        for (int step = 0; step < 400; ++step) sediment.advance(bed, still, 1.0);
        EXPECT_NEAR(volume(bed, nodata), before, 1e-11 * before);
        double low = 1.0;
        double high = 0.0;
        for (std::size_t i = 0; i < bed.size(); ++i) {
            if (!nodata.empty() && nodata.values()[i] != 0) {
                EXPECT_EQ(bed.values()[i], start.values()[i]) << "a cell without data moved";
                continue;
            }
            low = std::min(low, bed.values()[i]);
            high = std::max(high, bed.values()[i]);
        }
        EXPECT_LT(high - low, 1e-3) << "walls let nothing through, so the bed becomes level";
    }
}

TEST(SedimentEdges, ALongStepOfAMaskedBedIsCutIntoTurns) {
    GullyParameters gully;
    gully.transport = SedimentTransport::none;
    gully.bed_diffusion = 3.0;
    WorkerPool pool(1);
    Sediment sediment(gully, walled(holes(16, 16)), 16, 16, pool);
    Grid bed = noise(16, 16, 1.0);
    const Water still{Grid(16, 16), Grid(16, 16), Grid(16, 16)};
    sediment.advance(bed, still, 200.0);
    for (const double z : bed.values()) {
        EXPECT_GE(z, 0.0);
        EXPECT_LE(z, 1.0);
    }
}

TEST(SedimentEdges, TransportIsCountedAndLeavesDryGroundAlone) {
    for (const SedimentTransport transport :
         {SedimentTransport::incision, SedimentTransport::conservative}) {
        for (const Mask& nodata : {Mask{}, holes(24, 18)}) {
            GullyParameters gully;
            gully.transport = transport;
            gully.bed_diffusion = 0.0;
            gully.slope = {"", 0.05};
            WaterDomain domain = walled(nodata);
            domain.slope = 0.05;
            WorkerPool pool(2);
            Sediment sediment(gully, domain, 24, 18, pool);
            Grid bed = noise(24, 18, 0.05);
            const Grid start = bed;
            const Water water = streaming(24, 18);
            for (int step = 0; step < 10; ++step) sediment.advance(bed, water, 0.1);
            EXPECT_NEAR(volume(start, nodata) - volume(bed, nodata), sediment.removed(), 1e-12);
            for (int y = 0; y < 18; ++y) {
                for (int x = 0; x < 4; ++x) EXPECT_EQ(bed(x, y), start(x, y));
                if (transport != SedimentTransport::incision) continue;
                for (int x = 5; x < 24; ++x) {
                    if (!nodata.empty() && nodata(x, y) != 0) continue;
                    EXPECT_LT(bed(x, y), start(x, y)) << x << ", " << y;
                }
            }
        }
    }
}

TEST(SedimentEdges, WallsKeepConservedSedimentIn) {
    GullyParameters gully;
    gully.transport = SedimentTransport::conservative;
    gully.bed_diffusion = 0.0;
    WaterDomain domain = walled();
    domain.edges_y = EdgeKind::wall;
    WorkerPool pool(2);
    Sediment sediment(gully, domain, 24, 18, pool);
    Grid bed = noise(24, 18, 0.05);
    const double before = volume(bed, {});
    for (int step = 0; step < 10; ++step) sediment.advance(bed, streaming(24, 18), 0.1);
    EXPECT_NEAR(volume(bed, {}), before, 1e-12 * before);
}

TEST(SedimentEdges, BytesDoNotDependOnThreads) {
    const auto bed_after = [](int threads) {
        GullyParameters gully;
        gully.bed_diffusion = 0.3;
        WorkerPool pool(threads);
        Sediment sediment(gully, walled(holes(33, 21)), 33, 21, pool);
        Grid bed = noise(33, 21, 0.05);
        for (int step = 0; step < 5; ++step) sediment.advance(bed, streaming(33, 21), 0.7);
        return bed;
    };
    const Grid one = bed_after(1);
    EXPECT_EQ(one, bed_after(2));
    EXPECT_EQ(one, bed_after(5));
}

TEST(SedimentEdges, DiffusionBeyondAllTurnsIsRefused) {
    GullyParameters gully;
    gully.bed_diffusion = 1e6;
    gully.time_step = 100.0;
    WorkerPool pool(1);
    try {
        const Sediment sediment(gully, walled(holes(16, 16)), 16, 16, pool);
        FAIL() << "accepted";
    } catch (const KeyError& refusal) {
        EXPECT_EQ(refusal.key(), "model.bed_diffusion");
    }
}

}  // namespace
}  // namespace fumon::test
