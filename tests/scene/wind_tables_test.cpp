#include "scene/wind_tables.h"

#include <gtest/gtest.h>

#include <any>
#include <fstream>
#include <memory>

#include "base/error.h"
#include "models/dunes/dunes_parameters.h"
#include "scene/read.h"
#include "scene/write.h"
#include "support/temporary_folder.h"
#include "wind/crest_directions.h"
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
}

}  // namespace
}  // namespace fumon::test
