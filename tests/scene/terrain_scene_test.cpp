// A terrain file as a run: what it computes with which settings.

#include "scene/terrain_scene.h"

#include <gtest/gtest.h>

#include <any>

#include "base/error.h"
#include "models/water/gully_parameters.h"

namespace fumon::test {
namespace {

TEST(TerrainRun, IsTheTerrainItselfInOneFrame) {
    const Scene scene = terrain_run("dem.asc", {"camera.azimuth=10"});
    EXPECT_EQ(scene.model.name, "static");
    EXPECT_EQ(scene.run.steps, 0);
    EXPECT_FALSE(scene.output.movie);
    EXPECT_EQ(scene.bed.file, "dem.asc");
    EXPECT_EQ(scene.view.camera.azimuth, 10.0);
}

TEST(TerrainRun, IsAnHourOfWaterWhereASettingSaysSomethingOfIt) {
    for (const char* setting : {"model.rain=30", "gauge.0.at=[1,2]", "water.0.depth=1",
                                "edge.0.side=west", "model.name=water"}) {
        const Scene scene = terrain_run("dem.asc", {setting});
        ASSERT_EQ(scene.model.name, "water") << setting;
        const auto& water = std::any_cast<const WaterParameters&>(scene.model.parameters);
        EXPECT_EQ(water.time_step * static_cast<double>(scene.run.steps), 3600.0);
        EXPECT_EQ(water.friction, FrictionLaw::manning);
        EXPECT_EQ(water.initial_water, InitialWater::dry);
    }
    EXPECT_EQ(terrain_run("dem.asc", {"model.rain=30", "run.steps=7"}).run.steps, 7);
    EXPECT_EQ(terrain_run("dem.asc", {"model.name=gully"}).model.name, "gully");
}

TEST(TerrainRun, ItsFramesGiveWayToThoseOfASetting) {
    EXPECT_EQ(terrain_run("dem.asc", {"model.rain=30"}).frames.every, 4);
    for (const char* name : {"model.rain=30", "model.name=gully"}) {
        const FrameSettings at = terrain_run("dem.asc", {name, "frames.at=[60]"}).frames;
        EXPECT_EQ(at.every, 0);
        EXPECT_EQ(at.at, (std::vector<std::int64_t>{60}));
        EXPECT_EQ(terrain_run("dem.asc", {name, "frames.logarithmic=9"}).frames.logarithmic, 9);
    }
}

TEST(TerrainRun, LeavesOtherModelsToThemselves) {
    const Scene scene = terrain_run("dem.asc", {"model.name=sand", "run.steps=5"});
    EXPECT_EQ(scene.model.name, "sand");
    EXPECT_TRUE(scene.view.overlays.empty());
    EXPECT_THROW(terrain_run("dem.asc", {"model.name=sand"}), InputError) << "run.steps";
    EXPECT_THROW(terrain_run("dem.asc", {"model.nothing=1"}), InputError);
}

TEST(TerrainRun, TerrainHasAnEndingThatIsNoScenes) {
    EXPECT_TRUE(is_terrain_name("folder/dem.tif"));
    EXPECT_FALSE(is_terrain_name("scene.toml"));
    EXPECT_FALSE(is_terrain_name("barchans"));
    EXPECT_FALSE(is_terrain_name("folder.d/barchans"));
    EXPECT_FALSE(is_terrain_name("picture.png"));
    EXPECT_TRUE(is_terrain_name("heights.png", {"bed.heights=[0,850]"}));
}

}  // namespace
}  // namespace fumon::test
