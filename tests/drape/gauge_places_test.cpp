#include "drape/gauge_places.h"

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "drape/lay_layers.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon {
namespace {

Scene gauged_scene(const test::ScratchFolder& folder, const std::string& more) {
    test::write_text(folder / "scene.toml", "[model]\nname = \"gully\"\n[run]\nsteps = 1\n" + more);
    return read_scene(folder / "scene.toml");
}

InitialBed gauged_bed() {
    InitialBed initial;
    initial.bed = Grid(20, 10, 1.0);
    initial.scale.in_metres = true;
    initial.scale.dx = initial.scale.dy = 5.0;
    initial.scale.place = GeoReference{499500.0, 4427000.0, 5.0, 5.0, false, "EPSG:32613"};
    return initial;
}

TEST(GaugePlaces, PointsAndLinesLieWhereTheModelReadsThemAndSidesAreLeftOut) {
    const test::ScratchFolder folder;
    Scene scene = gauged_scene(folder,
                               "[[gauge]]\nname = \"mouth\"\nat = [50, 20]\n"
                               "[[gauge]]\nat = [499525, 4427010]\nto = [499575, 4427010]\n"
                               "coordinates = \"map\"\n"
                               "[[gauge]]\nside = \"south\"\n"
                               "[[layer]]\ndata = \"gauges\"\nlabel = \"name\"\n");
    InitialBed initial = gauged_bed();
    lay_layers(scene, initial);
    ASSERT_TRUE(scene.view.placed_layers);
    const auto& features = scene.view.placed_layers->layers.at(0).features;
    ASSERT_EQ(features.size(), 2U);
    EXPECT_EQ(features[0].shape, LayerShape::points);
    EXPECT_EQ(features[0].label, "mouth");
    EXPECT_NEAR(features[0].lines[0][0][0], 0.5, 1e-9);
    EXPECT_NEAR(features[0].lines[0][0][1], 0.4, 1e-9);
    EXPECT_EQ(features[1].shape, LayerShape::lines);
    EXPECT_EQ(features[1].label, "gauge_2");
    EXPECT_NEAR(features[1].lines[0].front()[0], 0.25, 1e-9);
    EXPECT_NEAR(features[1].lines[0].back()[0], 0.75, 1e-9);
    EXPECT_NEAR(features[1].lines[0].back()[1], 0.2, 1e-9);
    EXPECT_TRUE(initial.inputs.empty());
}

TEST(GaugePlaces, KeysThatBelongToFilesAreRefusedInOtherLayers) {
    const test::ScratchFolder folder;
    const auto refusal = [&](const std::string& layer) -> std::string {
        try {
            gauged_scene(folder, "[[layer]]\n" + layer);
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    };
    const auto says = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(says(refusal("data = \"streams\"\nfile = \"a.geojson\"\n"),
                     "layer.0.file belongs to layer.0.data = \"file\""));
    EXPECT_TRUE(says(refusal("data = \"contours\"\nlabel = \"order\"\n"),
                     "this layer has the label \"height\" alone"));
    EXPECT_TRUE(says(refusal("colour = \"#102030\"\n"), "layer.0.file is missing"));
    EXPECT_EQ(refusal("data = \"streams\"\nlabel = \"order\"\n"), "none");
}

}  // namespace
}  // namespace fumon
