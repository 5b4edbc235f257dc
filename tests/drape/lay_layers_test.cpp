#include "drape/lay_layers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "drape/area_drape.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::ScratchFolder;

constexpr const char* zone_13 = "EPSG:32613";

std::string feature_text(const std::string& type, const std::string& coordinates,
                         const std::string& name = "one") {
    return R"({"type": "Feature", "properties": {"name": ")" + name +
           R"("}, "geometry": {"type": ")" + type + R"(", "coordinates": )" + coordinates + "}}";
}

std::string collection_text(const std::string& features) {
    return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}

Scene layer_scene(const ScratchFolder& folder, const std::string& keys) {
    test::write_text(folder / "scene.toml",
                     "[model]\nname = \"static\"\n[[layer]]\n" + keys + "\n");
    return read_scene(folder / "scene.toml");
}

InitialBed layered_bed(std::optional<GeoReference> place, int nx = 20, int ny = 10) {
    InitialBed initial;
    initial.bed = Grid(nx, ny, 1.0);
    initial.scale.in_metres = true;
    initial.scale.dx = initial.scale.dy = 5.0;
    initial.scale.place = std::move(place);
    return initial;
}

std::string refused_layer(Scene scene, InitialBed initial) {
    try {
        lay_layers(scene, initial);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

/// A bed of 100 m × 50 m without a place: coordinates are metres from its corner.
TEST(LayLayers, ClipsALineToTheBedWithPointsACellApart) {
    const ScratchFolder folder;
    test::write_text(folder / "line.geojson",
                     collection_text(feature_text("LineString", "[[-50, 25], [150, 25]]")));
    Scene scene = layer_scene(folder, "file = \"line.geojson\"\nlabel = \"name\"");
    InitialBed initial = layered_bed(std::nullopt);
    lay_layers(scene, initial);
    ASSERT_TRUE(scene.view.placed_layers);
    const LayerFeature& line = scene.view.placed_layers->layers.at(0).features.at(0);
    EXPECT_EQ(line.shape, LayerShape::lines);
    EXPECT_EQ(line.label, "one");
    ASSERT_EQ(line.lines.size(), 1U);
    ASSERT_EQ(line.lines[0].size(), 21U);  // 20 cells
    for (std::size_t i = 0; i < 21; ++i) {
        EXPECT_NEAR(line.lines[0][i][0], static_cast<double>(i) / 20.0, 1e-12);
        EXPECT_NEAR(line.lines[0][i][1], 0.5, 1e-12);
    }
    ASSERT_TRUE(line.anchor);
    EXPECT_NEAR((*line.anchor)[0], 0.5, 1e-9);
    EXPECT_EQ(scene.view.placed_layers->areas, nullptr);
    EXPECT_EQ(initial.note,
              "[[layer]]: the bed has no place: coordinates of layers are taken for lengths from "
              "its south-western corner");
    ASSERT_EQ(initial.inputs.size(), 1U);
    const std::string hash = initial.inputs[0].hash;
    EXPECT_EQ(hash.size(), 64U);
    test::write_text(folder / "line.geojson",
                     collection_text(feature_text("LineString", "[[-50, 24], [150, 25]]")));
    InitialBed again = layered_bed(std::nullopt);
    lay_layers(scene, again);
    EXPECT_NE(again.inputs.at(0).hash, hash);
}

/// 105° W is the middle of zone 13, easting 500 km; 40° N there is northing 4 427 757.2186 m, as
/// LayDrape has it too; .01° of longitude east of it is easting 500 853.9 m (cos 40° · N · .01°).
TEST(LayLayers, BringsDegreesToTheBedsReferenceSystem) {
    const ScratchFolder folder;
    test::write_text(folder / "points.geojson",
                     collection_text(feature_text("Point", "[-105, 40]") + "," +
                                     feature_text("Point", "[-104.99, 40]") + "," +
                                     feature_text("Point", "[-100, 40]")));
    Scene scene = layer_scene(folder, "file = \"points.geojson\"");
    const double cell = 50.0;
    InitialBed initial =
        layered_bed(GeoReference{499500.0, 4427257.2186, cell, cell, false, zone_13}, 40, 20);
    lay_layers(scene, initial);
    const auto& features = scene.view.placed_layers->layers.at(0).features;
    ASSERT_EQ(features.size(), 2U);  // the third lies beside the bed
    EXPECT_NEAR(features[0].lines[0][0][0] * 40.0, 500.0 / cell, 0.01);
    EXPECT_NEAR(features[0].lines[0][0][1] * 20.0, 500.0 / cell, 0.01);
    EXPECT_NEAR(features[1].lines[0][0][0] * 40.0, 1353.9 / cell, 0.02);
    EXPECT_NEAR(features[1].lines[0][0][1] * 20.0, 500.0 / cell, 0.01);
    EXPECT_EQ(initial.note, "");
}

TEST(LayLayers, FillsAreasWithTheirHoles) {
    const ScratchFolder folder;
    test::write_text(
        folder / "area.geojson",
        collection_text(feature_text("Polygon",
                                     "[[[10, 10], [60, 10], [60, 40], [10, 40], [10, 10]],"
                                     " [[20, 20], [40, 20], [40, 30], [20, 30], [20, 20]]]")));
    Scene scene = layer_scene(
        folder,
        "file = \"area.geojson\"\nfill = \"#ff0000\"\nfill_opacity = 0.4\nlabel = \"name\"");
    InitialBed initial = layered_bed(std::nullopt);
    lay_layers(scene, initial);
    const Drape* drape = scene.view.laid();
    ASSERT_NE(drape, nullptr);
    EXPECT_FALSE(drape->strength_counts);
    ASSERT_EQ(drape->width, 80);
    ASSERT_EQ(drape->height, 40);
    const auto texel = [&](double x, double y) {
        const auto column = static_cast<std::size_t>(x / 100.0 * 80);
        const auto row = static_cast<std::size_t>(y / 50.0 * 40);
        const std::size_t at = 4 * (row * 80 + column);
        return std::array<int, 4>{drape->texels[at], drape->texels[at + 1], drape->texels[at + 2],
                                  drape->texels[at + 3]};
    };
    EXPECT_EQ(texel(15, 15), (std::array{255, 0, 0, 102}));
    EXPECT_EQ(texel(50, 25), (std::array{255, 0, 0, 102}));
    EXPECT_EQ(texel(30, 25)[3], 0);  // in the hole
    EXPECT_EQ(texel(5, 25)[3], 0);
    EXPECT_EQ(texel(70, 25)[3], 0);
    double covered = 0.0;
    for (std::size_t at = 3; at < drape->texels.size(); at += 4) covered += drape->texels[at];
    EXPECT_NEAR(covered / 102.0 / (80 * 40), (50.0 * 30.0 - 20.0 * 10.0) / 5000.0, 0.002);
    // The label stands within the area, beside its hole.
    const BedPlace anchor = *scene.view.placed_layers->layers[0].features[0].anchor;
    EXPECT_NEAR(anchor[0], 0.5, 1e-9);
    EXPECT_NEAR(anchor[1], 0.5, 1e-9);
}

TEST(LayLayers, LaysAreasOverADrapeOfItsStrength) {
    auto under = std::make_shared<Drape>();
    under->width = under->height = 2;
    under->texels.assign(16, 200);
    PlacedLayer layer;
    LayerFeature half;
    half.shape = LayerShape::areas;
    half.rings = {{{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {0.0, 1.0}}};
    layer.features = {half};
    const std::array<FilledAreas, 1> areas{{{&layer, {0.0, 0.0, 1.0}, 1.0}}};
    const auto drape = with_areas(under, 0.5, areas, {20, 20, std::nullopt});
    ASSERT_TRUE(drape);
    EXPECT_EQ(drape->texels[2], 255);
    EXPECT_EQ(drape->texels[3], 255);
    EXPECT_EQ(drape->texels[4], 200);
    EXPECT_EQ(drape->texels[7], 100);
    EXPECT_EQ(with_areas(under, 0.5, std::array<FilledAreas, 1>{{{&layer, {}, 0.0}}}, {}), nullptr);
}

TEST(LayLayers, RefusesWhatItCannotShowInOneLineAtItsKey) {
    const ScratchFolder folder;
    const InitialBed initial = layered_bed(std::nullopt);
    const auto says = [&](const std::string& keys, const std::string& what) {
        const std::string line = refused_layer(layer_scene(folder, keys), initial);
        EXPECT_TRUE(test::contains(line, what)) << line;
        EXPECT_FALSE(test::contains(line, "\n")) << line;
    };
    says("file = \"none.geojson\"", "scene.toml:4:8: layer.0.file \"none.geojson\" does not exist");
    test::write_text(folder / "broken.geojson", "{\"type\": \"FeatureCollection\", \"feat");
    says("file = \"broken.geojson\"", "broken.geojson: cannot be read as lines, points or areas: ");
    test::write_text(folder / "line.geojson",
                     collection_text(feature_text("LineString", "[[0, 25], [50, 25]]")));
    says("file = \"line.geojson\"\nname = \"streets\"",
         "scene.toml:5:8: " + (folder / "line.geojson").string() + ": has no layer \"streets\"; ");
    says("file = \"line.geojson\"\nlabel = \"nam\"",
         "has no field \"nam\"; did you mean \"name\"?");
    test::write_text(
        folder / "mixed.geojson",
        collection_text(R"({"type": "Feature", "properties": {}, "geometry": {"type": )"
                        R"("GeometryCollection", "geometries": [{"type": "Point", )"
                        R"("coordinates": [1, 1]}]}})"));
    says("file = \"mixed.geojson\"", "mixed.geojson: feature 1 is a geometry collection; split it");
    test::write_text(folder / "beside.geojson",
                     collection_text(feature_text("Point", "[500, 25]")));
    says("file = \"beside.geojson\"", "beside.geojson: lies beside the bed; ");
    test::write_text(folder / "empty.geojson", collection_text(""));
    says("file = \"empty.geojson\"", "empty.geojson: holds no lines, points or areas");
    EXPECT_THROW(layer_scene(folder, "file = \"line.geojson\"\ncolour = \"red\""), InputError);
    EXPECT_THROW(layer_scene(folder, "colour = \"#ff0000\""), InputError);
}

/// Of others' scenes no message tells what a file holds, and formats of several files stay shut.
TEST(LayLayers, TellsOthersNothingOfFiles) {
    const ScratchFolder folder;
    test::write_text(folder / "line.geojson",
                     collection_text(feature_text("LineString", "[[0, 25], [50, 25]]")));
    Scene scene = layer_scene(folder, "file = \"line.geojson\"\nlabel = \"secret\"");
    scene.trusted = false;
    const InitialBed initial = layered_bed(std::nullopt);
    EXPECT_TRUE(
        test::contains(refused_layer(scene, initial), "is not one of the files whose SHA-256"));
    InitialBed known = layered_bed(std::nullopt);
    Scene plain = layer_scene(folder, "file = \"line.geojson\"");
    lay_layers(plain, known);
    scene.bed_hashes = std::make_shared<const std::vector<std::string>>(
        std::vector<std::string>{known.inputs.at(0).hash});
    EXPECT_TRUE(
        test::contains(refused_layer(scene, initial), "line.geojson is not a readable layer"));
    scene.view.layers[0].label.clear();
    EXPECT_EQ(refused_layer(scene, initial), "none");
}

}  // namespace
}  // namespace fumon
