#include "scene/wind_tables.h"

#include <gtest/gtest.h>

#include <any>
#include <fstream>
#include <memory>

#include "base/error.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_strength.h"
#include "scene/read.h"
#include "scene/write.h"
#include "support/temporary_folder.h"
#include "wind/crest_directions.h"
#include "wind/run_drift.h"
#include "wind/sand_flux.h"

namespace fumon::test {
namespace {

Scene with_winds(const TemporaryFolder& folder, const std::string& winds) {
    return parse_scene("[run]\nsteps = 1\n[model]\nname = \"dunes\"\n" + winds, "scene.toml",
                       folder.path());
}

const DunesParameters& dunes(const Scene& scene) {
    return std::any_cast<const DunesParameters&>(scene.model.parameters);
}

std::string refusal(const TemporaryFolder& folder, const std::string& winds) {
    Scene scene = with_winds(folder, winds);
    return message_of<InputError>([&] { read_wind_tables(scene); });
}

TEST(WindTables, ARoseMovesAsMuchSandAsItsWinds) {
    const TemporaryFolder folder;
    std::ofstream(folder / "rose.csv")
        << "direction,speed,percent\n270,9,20\n270,12,5\n0,8,10\n90,2,30\n";
    Scene scene = with_winds(folder,
                             "[[wind]]\nfrom = 10\nduration = 0.5\n"
                             "[[wind]]\ntable = \"rose.csv\"\nduration = 2\ngust_angle = 5\n"
                             "[[wind]]\nfrom = 20\n");
    read_wind_tables(scene);
    const std::vector<DuneWind>& winds = dunes(scene).winds;
    ASSERT_EQ(winds.size(), 4U);
    EXPECT_EQ(winds[0].from, 10.0);
    EXPECT_EQ(winds[0].duration, 0.5);
    EXPECT_EQ(winds[1].from, 270.0);
    EXPECT_EQ(winds[2].from, 0.0);
    EXPECT_EQ(winds[3].from, 20.0);
    EXPECT_NEAR(winds[1].duration, 2.0 * 25.0 / 35.0, 1e-12);
    EXPECT_NEAR(winds[2].duration, 2.0 * 10.0 / 35.0, 1e-12);
    for (const DuneWind& wind : winds) EXPECT_TRUE(wind.table.empty());
    EXPECT_EQ(winds[2].gust_angle, 5.0);
    const auto sand = [](const WindRose& rose) {
        return drift_of(saturated_fluxes(rose, SandAndAir{})).potential;
    };
    const double flux = dunes(scene).flux;
    EXPECT_NEAR(flux * winds[1].strength * winds[1].duration / 2.0,
                sand({{270.0, 9.0, 0.2}, {270.0, 12.0, 0.05}}), 1e-9);
    EXPECT_NEAR(flux * winds[2].strength * winds[2].duration / 2.0, sand({{0.0, 8.0, 0.1}}), 1e-9);
    const Scene again = parse_scene(to_toml(scene), "again.toml", folder.path());
    EXPECT_EQ(dunes(again).winds, winds) << "a resolved scene needs no table";
}

/// Rows that count alike, each of its own direction, are winds that blow in turn.
TEST(WindTables, ATableIsASceneOfTheSameWinds) {
    const TemporaryFolder folder;
    std::ofstream(folder / "rose.csv") << "direction,speed\n270,8\n200,11\n";
    Scene table = with_winds(folder, "[[wind]]\ntable = \"rose.csv\"\nduration = 0.5\n");
    read_wind_tables(table);
    const Scene winds = with_winds(folder,
                                   "[[wind]]\nfrom = 270\nspeed = 8\nduration = 0.25\n"
                                   "[[wind]]\nfrom = 200\nspeed = 11\nduration = 0.25\n");
    const std::vector<DuneWind> of_table = with_wind_strengths(dunes(table)).winds;
    const std::vector<DuneWind> of_scene = with_wind_strengths(dunes(winds)).winds;
    ASSERT_EQ(of_table.size(), 2U);
    for (std::size_t n = 0; n < 2; ++n) {
        EXPECT_EQ(of_table[n].from, of_scene[n].from);
        EXPECT_EQ(of_table[n].duration, of_scene[n].duration);
        EXPECT_EQ(of_table[n].strength, of_scene[n].strength);
        EXPECT_NEAR(of_table[n].threshold_ratio.value, of_scene[n].threshold_ratio.value, 1e-9);
    }
}

TEST(WindTables, OfOneDirectionReliefCountsAsOverAllItsSpeeds) {
    const TemporaryFolder folder;
    std::ofstream(folder / "rose.csv") << "direction,speed,percent\n270,6,30\n270,10,10\n90,3,60\n";
    Scene scene = with_winds(folder, "[[wind]]\ntable = \"rose.csv\"\n");
    read_wind_tables(scene);
    ASSERT_EQ(dunes(scene).winds.size(), 1U);
    // Fluxes 60.7145 and 363.2305 m²/yr at u*/u*t = 1.286517 and 2.144194: relief counts 2.526427
    // and 1.277966 times.
    const double six = 0.3 * 60.7145;
    const double ten = 0.1 * 363.2305;
    const double counts = (six * 2.526427 + ten * 1.277966) / (six + ten);
    const double ratio = dunes(scene).winds[0].threshold_ratio.value;
    EXPECT_NEAR(1.0 / (1.0 - 1.0 / (ratio * ratio)), counts, 1e-4);
    EXPECT_NEAR(dunes(scene).flux * dunes(scene).winds[0].strength, six + ten, 1e-3);

    Scene earlier =
        with_winds(folder, "[[wind]]\ntable = \"rose.csv\"\nthreshold_ratio = \"none\"\n");
    read_wind_tables(earlier);
    EXPECT_EQ(dunes(earlier).winds[0].threshold_ratio.word, "none");
    Scene even = with_winds(folder, "speed_up = \"none\"\n[[wind]]\ntable = \"rose.csv\"\n");
    read_wind_tables(even);
    EXPECT_TRUE(dunes(even).winds[0].threshold_ratio.is_word()) << "which knows no threshold";
}

/// u* = 0.434294 m/s is a speed of 10 m/s at 10 m and of 8.252574 m/s at 2 m.
TEST(WindTables, MayGiveSpeedsAtAnyHeightAndFrictionVelocities) {
    const TemporaryFolder folder;
    std::ofstream(folder / "low.csv") << "direction,speed\n270,8.252574\n";
    std::ofstream(folder / "friction.csv") << "direction,friction_velocity\n270,0.4342945\n";
    for (const char* table :
         {"table = \"low.csv\"\nspeed_height = 2\n", "table = \"friction.csv\"\n"}) {
        Scene scene = with_winds(folder, std::string("[[wind]]\n") + table);
        read_wind_tables(scene);
        EXPECT_NEAR(dunes(scene).winds.at(0).strength * dunes(scene).flux, 363.2305, 1e-3) << table;
    }
}

/// DP and RDP of a run are those of the table that drives it.
TEST(WindTables, TheRunMovesWhatTheTableMoves) {
    const TemporaryFolder folder;
    const std::string rose =
        "direction,speed,percent\n0,7,10\n0,9,5\n45,7,3\n225,8,4\n240,10,6\n250,13,2\n90,4,20\n";
    std::ofstream(folder / "rose.csv") << rose;
    Scene scene = with_winds(folder, "[[wind]]\ntable = \"rose.csv\"\nduration = 0.5\n");
    read_wind_tables(scene);
    const WindSchedule schedule(dunes(scene).winds, [](double) { return 0.001; });
    const Drift run = drift_of(fluxes_of(schedule.drifts(dunes(scene).flux)));
    const Drift table =
        drift_of(saturated_fluxes(read_wind_table({"rose.csv", rose}).rose, SandAndAir{}));
    EXPECT_GT(table.potential, 40.0);
    EXPECT_NEAR(run.potential / table.potential, 1.0, 1e-12);
    EXPECT_NEAR(run.resultant / table.resultant, 1.0, 1e-12);
    EXPECT_NEAR(run.toward, table.toward, 1e-9);
}

TEST(WindTables, OfFluxesEachBlowsForItsShare) {
    const TemporaryFolder folder;
    std::ofstream(folder / "fluxes.csv") << "direction,flux\n200,1\n300,3\n";
    Scene scene =
        with_winds(folder, "[[wind]]\ntable = \"fluxes.csv\"\nduration = 0.2\nstrength = 0.7\n");
    read_wind_tables(scene);
    ASSERT_EQ(dunes(scene).winds.size(), 2U);
    EXPECT_EQ(dunes(scene).winds[1].from, 300.0);
    EXPECT_NEAR(dunes(scene).winds[1].duration, 0.15, 1e-12);
    EXPECT_EQ(dunes(scene).winds[1].strength, 0.7);
}

TEST(WindTables, WhatIsWrongIsSaidAtTheKey) {
    const TemporaryFolder folder;
    EXPECT_NE(refusal(folder, "[[wind]]\ntable = \"none.csv\"\n").find("scene.toml:6:9: "),
              std::string::npos);
    std::ofstream(folder / "calm.csv") << "direction,speed\n270,3\n";
    EXPECT_NE(refusal(folder, "[[wind]]\ntable = \"calm.csv\"\n").find("strong enough"),
              std::string::npos);
    std::ofstream(folder / "still.csv") << "direction,speed\n270,0\n";
    EXPECT_NE(refusal(folder, "[[wind]]\ntable = \"still.csv\"\n").find("no wind blows"),
              std::string::npos);
    EXPECT_NE(
        refusal(folder, "[[wind]]\nspeed = 7\ntable = \"calm.csv\"\n").find("leave speed out"),
        std::string::npos);
    EXPECT_NE(
        refusal(folder, "roughness = 0.5\n[[wind]]\nspeed_height = 0.4\ntable = \"calm.csv\"\n")
            .find("lie within model.roughness"),
        std::string::npos);
    std::ofstream(folder / "storm.csv") << "direction,speed\n270,12\n";
    EXPECT_NE(
        refusal(folder, "flux = 0.5\n[[wind]]\ntable = \"storm.csv\"\n").find("raise model.flux"),
        std::string::npos);
    Scene of_others = with_winds(folder, "[[wind]]\ntable = \"storm.csv\"\n");
    of_others.trusted = false;
    EXPECT_NE(
        message_of<InputError>([&] { read_wind_tables(of_others); }).find("may not read a table"),
        std::string::npos);
}

TEST(WindTables, ARunSaysWhatItsWindsMove) {
    Snapshot first;
    EXPECT_EQ(winds_line(first), "");
    first.winds = {{1.0, 0.0, 30.0}, {0.0, 1.0, 40.0}};
    EXPECT_EQ(winds_line(first),
              "winds move 70 m2 of sand a year, on balance 50 toward 36.9 degrees (RDP/DP 0.714)");
    first.winds = {{1.0, 0.0, 30.0}, {-1.0, 0.0, 30.0}};
    EXPECT_EQ(winds_line(first), "winds move 60 m2 of sand a year, and none on balance");
    first.winds = {{1.0, 0.0, 0.0}};
    EXPECT_EQ(winds_line(first), "winds move no sand: none is above the threshold of transport");
}

}  // namespace
}  // namespace fumon::test
