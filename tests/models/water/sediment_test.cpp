// The bed where the plane ends: walls, open edges, cells without data.

#include "models/water/sediment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

// ---- cells that are not square ----

/// The share of a wave along one axis that is left after 40 s of D = 0.5 m²/s, on cells of 1 by 2
/// m.
double share_left(bool along_y, bool with_hole) {
    constexpr int n = 32;
    WaterDomain domain;
    domain.dx = 1.0;
    domain.dy = 2.0;
    if (with_hole) {  // far from where the wave is measured: explicit turns
        domain.nodata = Mask(n, n);
        (along_y ? domain.nodata(0, 8) : domain.nodata(8, 0)) = 1;
    }
    GullyParameters gully;
    gully.bed_diffusion = 0.5;
    WorkerPool pool(1);
    Sediment sediment(gully, domain, n, n, pool);
    Grid bed(n, n);
    const auto wave = [&](int at) { return std::cos(2.0 * std::numbers::pi * at / n); };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) bed(x, y) = wave(along_y ? y : x);
    }
    const Water still{Grid(n, n), Grid(n, n), Grid(n, n)};
    for (int step = 0; step < 40; ++step) sediment.advance(bed, still, 1.0);
    return bed(n / 2, n / 2) / wave(n / 2);
}

TEST(SedimentCells, DiffusionKnowsTheirTwoSides) {
    for (const bool with_hole : {false, true}) {
        for (const bool along_y : {false, true}) {
            const double k = 2.0 * std::numbers::pi / (32 * (along_y ? 2.0 : 1.0));
            EXPECT_NEAR(share_left(along_y, with_hole), std::exp(-0.5 * k * k * 40.0), 2e-3)
                << (along_y ? "along y" : "along x") << (with_hole ? ", explicit" : "");
        }
    }
}

TEST(SedimentCells, IncisionKnowsTheirTwoSides) {
    for (const Relief relief : {Relief::gentle, Relief::steep}) {
        for (const bool along_y : {false, true}) {
            GullyParameters gully;
            gully.relief = relief;
            gully.bed_diffusion = 0.0;
            WaterDomain domain = walled();
            domain.edges_x = domain.edges_y = EdgeKind::open;
            WorkerPool pool(1);
            Sediment sediment(gully, domain, 9, 9, pool);
            Grid bed(9, 9);
            for (int y = 0; y < 9; ++y) {
                for (int x = 0; x < 9; ++x) bed(x, y) = 0.1 * (along_y ? 2.0 * y : 1.0 * x);
            }
            const double before = bed(4, 4);
            const Water water{Grid(9, 9, 0.1), Grid(9, 9, -0.5), Grid(9, 9, 0.0)};
            sediment.advance(bed, water, 1e-3);
            EXPECT_NEAR((before - bed(4, 4)) / 1e-3, std::pow(0.5, 1.8) * std::pow(0.1, 2.1), 1e-6);
        }
    }
}

// ---- what is fixed, and what is steep ----

TEST(SedimentSteep, ABedWithoutTransportStaysAsItIs) {
    GullyParameters gully;
    gully.transport = SedimentTransport::none;
    gully.bed_diffusion = 1.0;
    for (const Mask& nodata : {Mask{}, holes(20, 17)}) {
        WorkerPool pool(1);
        Sediment sediment(gully, walled(nodata), 20, 17, pool);
        Grid bed = noise(20, 17, 1.0);
        const Grid start = bed;
        for (int step = 0; step < 3; ++step) sediment.advance(bed, streaming(20, 17), 1.0);
        EXPECT_EQ(bed, start);
    }
}

/// Lowest and highest of a cell and its neighbours inside.
std::pair<double, double> around(const Grid& bed, const Mask& nodata, int x, int y) {
    std::pair range{bed(x, y), bed(x, y)};
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        const int i = x + dx;
        const int j = y + dy;
        if (i < 0 || i >= bed.nx() || j < 0 || j >= bed.ny()) continue;
        if (!nodata.empty() && nodata(i, j) != 0) continue;
        range = {std::min(range.first, bed(i, j)), std::max(range.second, bed(i, j))};
    }
    return range;
}

TEST(SedimentSteep, NoSubStepCarriesACellBeyondItsNeighbours) {
    for (const SedimentTransport transport :
         {SedimentTransport::incision, SedimentTransport::conservative,
          SedimentTransport::as_printed}) {
        for (const Mask& nodata : {Mask{}, holes(24, 18)}) {
            GullyParameters gully;
            gully.relief = Relief::steep;
            gully.transport = transport;
            gully.transport_factor = 100.0;
            gully.bed_diffusion = 0.0;
            WorkerPool pool(2);
            Sediment sediment(gully, walled(nodata), 24, 18, pool);
            Grid bed = noise(24, 18, 30.0);
            for (int step = 0; step < 20; ++step) {
                const Grid before = bed;
                sediment.advance(bed, streaming(24, 18), 10.0);
                for (int y = 0; y < 18; ++y) {
                    for (int x = 0; x < 24; ++x) {
                        if (!nodata.empty() && nodata(x, y) != 0) continue;
                        const auto [low, high] = around(before, nodata, x, y);
                        ASSERT_GE(bed(x, y), low - 1e-12) << x << ", " << y;
                        ASSERT_LE(bed(x, y), high + 1e-12) << x << ", " << y;
                    }
                }
            }
        }
    }
}

TEST(SedimentSteep, ConservedSedimentStaysBetweenWallsAndIsCountedElsewhere) {
    for (const EdgeKind edge : {EdgeKind::wall, EdgeKind::periodic, EdgeKind::open}) {
        GullyParameters gully;
        gully.relief = Relief::steep;
        gully.transport = SedimentTransport::conservative;
        gully.bed_diffusion = 0.0;
        WaterDomain domain = walled();
        domain.edges_x = domain.edges_y = edge;
        domain.slope = 0.05;
        WorkerPool pool(2);
        Sediment sediment(gully, domain, 24, 18, pool);
        Grid bed = noise(24, 18, 0.5);
        const Grid start = bed;
        for (int step = 0; step < 50; ++step) sediment.advance(bed, streaming(24, 18), 1.0);
        EXPECT_NE(bed, start);
        EXPECT_NEAR(volume(start, {}) - volume(bed, {}), sediment.removed(), 1e-11);
        if (edge == EdgeKind::open) {
            EXPECT_GT(sediment.removed(), 0.01);
        } else {
            EXPECT_NEAR(sediment.removed(), 0.0, 1e-11);
        }
    }
}

TEST(SedimentSteep, BytesDoNotDependOnThreads) {
    for (const SedimentTransport transport :
         {SedimentTransport::incision, SedimentTransport::conservative}) {
        const auto bed_after = [&](int threads) {
            GullyParameters gully;
            gully.relief = Relief::steep;
            gully.transport = transport;
            WorkerPool pool(threads);
            Sediment sediment(gully, walled(holes(33, 21)), 33, 21, pool);
            Grid bed = noise(33, 21, 5.0);
            for (int step = 0; step < 5; ++step) sediment.advance(bed, streaming(33, 21), 0.7);
            return bed;
        };
        EXPECT_EQ(bed_after(1), bed_after(5));
    }
}

}  // namespace
}  // namespace fumon::test
