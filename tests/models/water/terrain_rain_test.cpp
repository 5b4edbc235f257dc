// Rain on surveyed ground: an hour in every scheme, on cells of any size, by default and beyond.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "files/terrain/resample_terrain.h"
#include "files/terrain/terrain_file.h"
#include "support/gully_run.h"

namespace fumon::test {
namespace {

/// A bed in metres and its cells.
struct Ground {
    Grid heights;
    Mask nodata;
    double dx;
    double dy;
};

/// The surveyed gully on cells of some metres.
Ground surveyed(double cell) {
    const Terrain terrain =
        read_terrain(std::filesystem::path(FUMON_TERRAIN_FOLDER) / "west_bijou_gully.asc", {});
    const Terrain coarse =
        resampled(terrain, terrain.dx, terrain.dy, cell, Resampling::average, "the test");
    return {coarse.heights, coarse.nodata, cell, cell};
}

/// Peaks and hollows of 600 m on cells of 71 by 92 m, a cliff across them.
Ground mountains() {
    Ground ground{Grid(24, 18), {}, 71.0, 92.0};
    const Grid rough = noise(24, 18, 60.0);
    for (int y = 0; y < 18; ++y) {
        for (int x = 0; x < 24; ++x) {
            ground.heights(x, y) = 2000.0 + 300.0 * std::sin(0.5 * x) * std::cos(0.4 * y) +
                                   (x + y > 20 ? 250.0 : 0.0) + rough(x, y);
        }
    }
    return ground;
}

/// An hour of 60 mm/h. CIP takes the terrain without holes, as a periodic one.
void rain_an_hour(Ground ground, GullyParameters gully, bool plausible) {
    gully.rain = 60.0;
    gully.time_step = 20.0;
    if (gully.scheme == WaterScheme::cip) {
        if (!ground.nodata.empty()) ground.heights = fill_nodata(ground.heights, ground.nodata);
        ground.nodata = {};
        gully.edges_x = gully.edges_y = EdgeKind::periodic;
    }
    double low = 1e9;
    double high = -1e9;
    const auto inside = [&](std::size_t i) {
        return ground.nodata.empty() || ground.nodata.values()[i] == 0;
    };
    for (std::size_t i = 0; i < ground.heights.size(); ++i) {
        if (!inside(i)) continue;
        low = std::min(low, ground.heights.values()[i]);
        high = std::max(high, ground.heights.values()[i]);
    }
    GullyRun run(gully, ground.heights, 1, ground.dx, ground.dy, ground.nodata, true);
    run.to(3600.0);
    EXPECT_LT(std::fabs(run.number("water_budget_error")), 1e-12);
    EXPECT_LT(std::fabs(run.number("sediment_budget_error")), 1e-12);
    const Grid bed = run.gully.snapshot().bed;
    const Grid u = run.field("velocity_x");
    const Grid v = run.field("velocity_y");
    for (std::size_t i = 0; i < bed.size(); ++i) {
        if (!inside(i)) continue;
        ASSERT_GE(bed.values()[i], low - 1e-6);
        ASSERT_LE(bed.values()[i], high + 1e-6);
        ASSERT_LT(std::hypot(u.values()[i], v.values()[i]), 20.0) << "faster than water falls";
    }
    if (plausible) {
        EXPECT_EQ(run.gully.plausibility_warning(), "");
    }
}

TEST(RainOnTerrain, LastsAnHourInEverySchemeByDefault) {
    for (const Ground& ground : {surveyed(15.0), mountains()}) {
        for (const WaterScheme scheme : {WaterScheme::automatic, WaterScheme::cip}) {
            for (const SedimentTransport transport :
                 {SedimentTransport::incision, SedimentTransport::conservative,
                  SedimentTransport::as_printed}) {
                GullyParameters gully;
                gully.scheme = scheme;
                gully.transport = transport;
                const bool plausible = scheme == WaterScheme::automatic && ground.dx < 20.0;
                rain_an_hour(ground, gully, plausible);
            }
        }
    }
}

TEST(RainOnTerrain, LastsAnHourWhereTheBedIsSwept) {
    for (const WaterScheme scheme : {WaterScheme::automatic, WaterScheme::cip}) {
        for (const SedimentTransport transport :
             {SedimentTransport::incision, SedimentTransport::conservative}) {
            GullyParameters gully;
            gully.scheme = scheme;
            gully.transport = transport;
            gully.transport_factor = 1.0;  // of the paper's plane
            rain_an_hour(surveyed(20.0), gully, false);
        }
    }
}

TEST(RainOnTerrain, SaysWhatErosionIsImplausibleAndWhatToSet) {
    GullyParameters gully;
    gully.rain = 60.0;
    gully.time_step = 10.0;
    gully.transport_factor = 0.1;
    const Ground ground = surveyed(15.0);
    GullyRun run(gully, ground.heights, 1, 15.0, 15.0, ground.nodata, true);
    EXPECT_EQ(run.gully.plausibility_warning(), "") << "nothing has happened yet";
    run.to(1200.0);
    const std::string plausibility_warning = run.gully.plausibility_warning();
    EXPECT_NE(plausibility_warning.find("the bed sank by "), std::string::npos)
        << plausibility_warning;
    EXPECT_NE(plausibility_warning.find(" m at cell ("), std::string::npos) << plausibility_warning;
    EXPECT_NE(plausibility_warning.find("in the first 1200 s"), std::string::npos)
        << plausibility_warning;
    EXPECT_NE(plausibility_warning.find("a smaller model.transport_factor, about "),
              std::string::npos)
        << plausibility_warning;
    EXPECT_NE(plausibility_warning.find("instead of 0.1"), std::string::npos)
        << plausibility_warning;
    EXPECT_EQ(plausibility_warning.find('\n'), std::string::npos);
    gully.transport_factor = 1e-5;
    GullyRun gentle(gully, ground.heights, 1, 15.0, 15.0, ground.nodata, true);
    gentle.to(1200.0);
    EXPECT_EQ(gentle.gully.plausibility_warning(), "");
}

TEST(RainOnTerrain, WarnsOfFurrowsOfTwoCells) {
    Grid slope(24, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) slope(x, y) = 0.15 * y + (x % 2 == 0 ? 0.0 : 0.004);
    GullyParameters gully;
    gully.rain = 60.0;
    gully.time_step = 1.0;
    gully.transport_factor = 0.02;
    gully.bed_diffusion = 1e-5;
    GullyRun furrowed(gully, slope, 1, 1.5, 1.5, {}, true);
    furrowed.to(600.0);
    const std::string warning = furrowed.gully.plausibility_warning();
    EXPECT_NE(warning.find("furrows of two cells"), std::string::npos) << warning;
    EXPECT_NE(warning.find("more model.bed_diffusion"), std::string::npos) << warning;
    gully.bed_diffusion = 0.05;
    GullyRun smooth(gully, slope, 1, 1.5, 1.5, {}, true);
    smooth.to(600.0);
    EXPECT_EQ(smooth.gully.plausibility_warning(), "");
}

TEST(RainOnTerrain, AutomaticValuesAreThePapersElsewhere) {
    const auto changed = [](GullyParameters gully, bool from_file) {
        gully.time_step = 0.1;
        GullyRun run(gully, noise(16, 16, 0.01), 1, 1.0, 1.0, {}, from_file);
        run.to(2.0);
        return run.gully.snapshot().bed;
    };
    GullyParameters paper;
    paper.transport_factor = 1.0;
    paper.bed_diffusion = 1.0;
    paper.relief = Relief::gentle;
    EXPECT_EQ(changed({}, false), changed(paper, false));
    GullyParameters terrain;
    terrain.transport_factor = 1e-5;
    terrain.bed_diffusion = 0.0;
    terrain.relief = Relief::steep;
    EXPECT_EQ(changed({}, true), changed(terrain, true));
}

TEST(RainOnTerrain, ABankDoesNotPressOnThePondBelowIt) {
    Grid bed(24, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 24; ++x) bed(x, y) = std::max(0.0, 4.0 * std::abs(x - 12) - 20.0);
    }
    const auto fastest = [&](Relief relief) {
        GullyParameters gully;
        gully.scheme = WaterScheme::cip;
        gully.slope = 0.0;
        gully.relief = relief;
        gully.initial_water = InitialWater::level;
        gully.depth = 1.0;  // in the mean: a pond between the banks
        gully.transport = SedimentTransport::none;
        GullyRun run(gully, bed);
        run.to(5.0);
        const Grid velocity = run.field("velocity_x");
        double speed = 0.0;
        for (const double u : velocity.values()) speed = std::max(speed, std::fabs(u));
        return speed;
    };
    EXPECT_LT(fastest(Relief::steep), 0.01);
    EXPECT_GT(fastest(Relief::gentle), 0.3) << "what the key is for";
}

TEST(RainOnTerrain, RefusesKeysThatWouldDoNothing) {
    const auto refusal = [](const GullyParameters& gully) -> std::string {
        try {
            const GullyRun run(gully, Grid(8, 8), 1);
        } catch (const KeyError& error) {
            return error.key();
        }
        return {};
    };
    GullyParameters gully;
    gully.transport = SedimentTransport::none;
    EXPECT_EQ(refusal(gully), "");
    gully.bed_diffusion = 0.5;
    EXPECT_EQ(refusal(gully), "model.bed_diffusion");
    gully = {};
    gully.scheme = WaterScheme::cip_as_published;
    gully.relief = Relief::steep;
    EXPECT_EQ(refusal(gully), "model.relief");
}

}  // namespace
}  // namespace fumon::test
