#include "models/water/gully.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "base/error.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

double largest_difference(const Grid& a, const Grid& b) {
    double largest = 0.0;
    for (std::size_t cell = 0; cell < a.size(); ++cell)
        largest = std::max(largest, std::fabs(a.values()[cell] - b.values()[cell]));
    return largest;
}

// ---- what is kept ----

TEST(Gully, KeepsWaterAndCountsSediment) {
    for (const SedimentTransport transport :
         {SedimentTransport::incision, SedimentTransport::as_printed,
          SedimentTransport::conservative, SedimentTransport::none}) {
        GullyParameters gully = as_printed();
        gully.transport = transport;
        gully.rain = 50.0;
        GullyRun run(gully, noise(37, 29, 0.01), 2, 1.0, 1.5);
        run.to(60.0);
        EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
        EXPECT_LT(std::fabs(run.number("sediment_budget_error")), 1e-12);
        EXPECT_NEAR(run.number("rain_volume"), 60.0 * 50.0 / 3.6e6 * 37 * 29 * 1.5, 1e-9);
        EXPECT_GE(run.lowest_depth(), 0.0);
    }
}

TEST(Gully, ConservativeTransportKeepsSediment) {
    GullyParameters gully = as_printed();
    gully.transport = SedimentTransport::conservative;
    GullyRun run(gully, noise(32, 32, 0.01));
    const double before = 32 * 32 * 0.005;
    run.to(50.0);
    EXPECT_LT(std::fabs(run.number("sediment_volume")), 1e-12 * before);
}

TEST(Gully, IncisionLowersAUniformBedByItsFlux) {
    GullyParameters gully;  // the default transport, slope and flow
    GullyRun run(gully, Grid(8, 8));
    run.to(10.0);
    const double speed = std::sqrt(9.8 * 0.01 * 0.04 / 0.01);
    const double flux = std::pow(speed, 1.8) * std::pow(0.04, 2.1);
    EXPECT_NEAR(run.gully.snapshot().bed(3, 4), -10.0 * flux, 1e-9 * flux);
    EXPECT_NEAR(run.number("sediment_removed"), 64 * 10.0 * flux, 1e-9);
}

TEST(Gully, UniformFlowStaysUniform) {
    for (const WaterScheme scheme : {WaterScheme::cip, WaterScheme::cip_as_published}) {
        GullyParameters gully;
        gully.scheme = scheme;
        gully.friction = FrictionLaw::half;
        GullyRun run(gully, Grid(6, 5));
        run.to(20.0);
        const double speed = std::sqrt(2.0 * 9.8 * 0.01 * 0.04 / 0.01);
        EXPECT_NEAR(run.field("velocity_y")(2, 2), -speed, 1e-12);
        EXPECT_NEAR(run.field("velocity_x")(2, 2), 0.0, 1e-12);
        EXPECT_NEAR(run.field("water_depth")(2, 2), 0.01, 1e-14);
    }
}

TEST(Gully, AFilmFromRestReachesItsUniformSpeed) {
    GullyParameters gully;
    gully.initial_flow = InitialFlow::rest;
    gully.transport = SedimentTransport::none;
    GullyRun run(gully, Grid(4, 4));
    run.to(2.0);
    const double terminal = std::sqrt(9.8 * 0.01 * 0.04 / 0.01);
    // v' = g S − C_f v² / h, so v = V tanh(g S t / V)
    const double expected = terminal * std::tanh(9.8 * 0.04 * 2.0 / terminal);
    EXPECT_NEAR(-run.field("velocity_y")(1, 1), expected, 0.03 * expected);
    run.to(60.0);
    EXPECT_NEAR(-run.field("velocity_y")(1, 1), terminal, 1e-9);
}

TEST(Gully, LevelWaterOverATroughStaysAtRest) {
    GullyParameters gully;
    gully.slope = {"", 0.0};
    gully.initial_water = InitialWater::level;
    gully.depth = 0.05;
    gully.channel_depth = 0.1;
    gully.transport = SedimentTransport::none;
    gully.bed_diffusion = 0.0;
    GullyRun run(gully, noise(40, 7, 0.002));
    const Grid before = run.field("water_depth");
    EXPECT_NEAR(before(20, 3) - before(0, 3), 0.1, 0.002) << "deeper in the trough";
    EXPECT_NEAR(run.number("water_volume"), 0.05 * 40 * 7, 1e-12) << "the stated mean depth";
    run.to(20.0);
    EXPECT_LT(largest_difference(run.field("velocity_x"), Grid(40, 7)), 1e-13);
    EXPECT_LT(largest_difference(run.field("water_depth"), before), 1e-13);
}

TEST(Gully, DryGroundGetsWetByRainAndStaysPositive) {
    GullyParameters gully;
    gully.initial_water = InitialWater::dry;
    gully.rain = 100.0;
    gully.rain_until = 30.05;
    gully.channel_depth = 0.3;
    GullyRun run(gully, noise(48, 24, 0.02));
    run.to(100.0);
    EXPECT_GE(run.lowest_depth(), 0.0);
    EXPECT_NEAR(run.number("water_volume"), 30.05 * 100.0 / 3.6e6 * 48 * 24, 1e-9);
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
}

TEST(Gully, WaterThatFallsOffAPlateauLeavesItDryNotNegative) {
    GullyParameters gully;
    gully.slope = {"", 0.001};
    gully.depth = 0.05;
    gully.transport = SedimentTransport::none;
    gully.bed_diffusion = 0.0;
    Grid bed(64, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 32; x < 64; ++x) bed(x, y) = 1.0;
    }
    GullyRun run(gully, bed);
    for (int k = 0; k < 200; ++k) {
        run.gully.step();
        ASSERT_GE(run.lowest_depth(), 0.0);
    }
    EXPECT_LT(run.field("water_depth")(32, 1), 0.01) << "the plateau's edge has drained";
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
}

TEST(Gully, AsPublishedLosesALittleWaterAtTheSlopeOfTheFigures) {
    GullyParameters gully = as_printed();
    gully.scheme = WaterScheme::cip_as_published;
    GullyRun run(gully, noise(100, 100, 0.01));
    run.to(100.0);
    const double lost = -run.number("water_budget_error");
    EXPECT_GT(lost, 2e-5);
    EXPECT_LT(lost, 4e-4);
}

// ---- symmetry and bytes ----

TEST(Gully, IncisionIsSymmetricAcrossTheSlope) {
    Grid bed = noise(30, 20, 0.01);
    Grid mirrored(30, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 30; ++x) mirrored(x, y) = bed(29 - x, y);
    }
    GullyRun a({}, bed);
    GullyRun b({}, mirrored);
    a.to(20.0);
    b.to(20.0);
    const Grid after = a.gully.snapshot().bed;
    const Grid other = b.gully.snapshot().bed;
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 30; ++x) ASSERT_NEAR(after(x, y), other(29 - x, y), 1e-14);
    }
}

TEST(Gully, SameBytesForAnyNumberOfThreads) {
    for (const WaterScheme scheme : {WaterScheme::cip, WaterScheme::cip_as_published}) {
        for (const SedimentTransport transport :
             {SedimentTransport::incision, SedimentTransport::as_printed}) {
            GullyParameters gully = as_printed(0.1);
            gully.scheme = scheme;
            gully.transport = transport;
            GullyRun one(gully, noise(41, 23, 0.01), 1);
            one.to(15.0);
            for (const int threads : {2, 3}) {
                GullyRun more(gully, noise(41, 23, 0.01), threads);
                more.to(15.0);
                const auto a = one.gully.state();
                const auto b = more.gully.state();
                ASSERT_EQ(a.size(), b.size());
                for (std::size_t k = 0; k < a.size(); ++k) {
                    EXPECT_TRUE(std::equal(a[k].values.begin(), a[k].values.end(),
                                           b[k].values.begin(), b[k].values.end()))
                        << a[k].name << " with " << threads << " threads";
                }
            }
        }
    }
}

TEST(Gully, GridsOfAnySizeRun) {
    for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 2}, {2, 5}}) {
        for (const WaterScheme scheme : {WaterScheme::cip, WaterScheme::cip_as_published}) {
            GullyParameters gully = as_printed();
            gully.scheme = scheme;
            GullyRun run(gully, noise(nx, ny, 0.001), 3);
            run.to(3.0);
            EXPECT_NEAR(run.number("water_volume"), 0.01 * nx * ny, 1e-4 * nx * ny);
        }
    }
}

TEST(Gully, SubStepsFollowTheFlow) {
    GullyParameters gully;
    GullyRun slow(gully, Grid(8, 8));
    slow.to(0.1);
    EXPECT_EQ(slow.number("substeps"), 1.0);
    gully.time_step = 2.0;
    GullyRun fast(gully, Grid(8, 8));
    fast.to(2.0);
    // (|v| + 2 c) dt = 0.626 + 2 · 0.313 over 0.4
    EXPECT_EQ(fast.number("substeps"), 7.0);
    EXPECT_DOUBLE_EQ(fast.gully.time(), 2.0);
}

// ---- faults ----

std::string gully_refusal(const GullyParameters& parameters, const std::string& key,
                          Mask nodata = {}, bool from_file = false) {
    try {
        const GullyRun run(parameters, Grid(8, 8), 1, 1.0, 1.0, std::move(nodata), from_file);
    } catch (const KeyError& error) {
        EXPECT_EQ(error.key(), key);
        const std::string line = error.what();
        EXPECT_EQ(line.find('\n'), std::string::npos);
        return line;
    }
    ADD_FAILURE() << "was not refused: " << key;
    return {};
}

TEST(Gully, RefusesWhatDoesNotGoTogetherInOneLine) {
    const auto with = [](const std::function<void(GullyParameters&)>& change) {
        GullyParameters gully;
        change(gully);
        return gully;
    };
    EXPECT_NE(gully_refusal(with([](auto& p) {
                                p.substeps = Substeps::fixed;
                                p.time_step = 1.0;
                            }),
                            "model.time_step")
                  .find("Courant number 1.25 at the start; take at most 0.799 s"),
              std::string::npos);
    gully_refusal(with([](auto& p) { p.slope = {"", 0.0}; }), "model.slope");
    gully_refusal(with([](auto& p) { p.initial_water = InitialWater::dry; }),
                  "model.initial_water");
    gully_refusal(with([](auto& p) { p.depth = 0.0; }), "model.depth");
    gully_refusal(with([](auto& p) {
                      p.friction_coefficient = 0.0;
                      p.initial_flow = InitialFlow::uniform;
                  }),
                  "model.initial_flow");
    const std::string edges = gully_refusal(with([](auto& p) {
                                                p.scheme = WaterScheme::cip;
                                                p.edges_x = EdgeKind::wall;
                                            }),
                                            "model.scheme");
    EXPECT_NE(edges.find("take model.scheme = \"finite-volume\""), std::string::npos);
    Mask hole(8, 8);
    hole(3, 3) = 1;
    const std::string holes = gully_refusal(with([](auto& p) {
                                                p.scheme = WaterScheme::cip_as_published;
                                                p.edges_x = p.edges_y = EdgeKind::periodic;
                                            }),
                                            "model.scheme", hole, true);
    EXPECT_NE(holes.find("bed.nodata = \"fill\""), std::string::npos);
}

TEST(Gully, ATerrainFileIsItsOwnSlope) {
    GullyParameters gully;
    gully.edges_x = gully.edges_y = EdgeKind::periodic;
    const GullyRun run(gully, noise(8, 8, 1.0), 1, 1.0, 1.0, {}, true);
    EXPECT_EQ(run.number("mean_slope"), 0.0);
    EXPECT_EQ(run.field("velocity_y")(4, 4), 0.0);
    EXPECT_EQ(GullyRun({}, noise(8, 8, 1.0)).number("mean_slope"), 0.04);
}

TEST(Gully, SaysWhereAndWhenAValueStoppedBeingOne) {
    GullyParameters gully = as_printed();
    gully.transport_factor = 1e9;  // digs a hole without end
    gully.slope_exponent = 4.0;
    gully.bed_diffusion = 0.0;
    GullyRun run(gully, noise(12, 12, 0.1));
    try {
        run.to(1000.0);
        FAIL() << "went on";
    } catch (const Error& error) {
        const std::string line = error.what();
        EXPECT_NE(line.find(" at cell ("), std::string::npos) << line;
        EXPECT_NE(line.find("t = "), std::string::npos) << line;
        EXPECT_NE(line.find("try a smaller"), std::string::npos) << line;
        EXPECT_EQ(error.exit_status(), 3);
    }
}

}  // namespace
}  // namespace fumon::test
