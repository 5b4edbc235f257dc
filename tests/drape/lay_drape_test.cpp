#include "drape/lay_drape.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "base/error.h"
#include "files/terrain/geotiff.h"
#include "picture/png.h"
#include "scene/read.h"
#include "support/program.h"

namespace fumon {
namespace {

using test::ScratchFolder;

constexpr const char* utm_13 = "EPSG:32613";

/// Every pixel of a colour of its own: red by columns from the left, green by rows from the top.
Image numbered(int width, int height) {
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.row(y)[3 * x] = static_cast<std::uint8_t>(10 + x);
            image.row(y)[3 * x + 1] = static_cast<std::uint8_t>(10 + y);
            image.row(y)[3 * x + 2] = 77;
        }
    }
    return image;
}

std::string bytes_of(const std::vector<std::uint8_t>& bytes) {
    return {bytes.begin(), bytes.end()};
}

Scene scene_in(const ScratchFolder& folder, const std::string& drape) {
    test::write_text(folder / "scene.toml",
                     "[model]\nname = \"static\"\n[look]\ndrape = \"" + drape + "\"\n");
    return read_scene(folder / "scene.toml");
}

InitialBed bed_at(std::optional<GeoReference> place, int nx = 20, int ny = 10) {
    InitialBed initial;
    initial.bed = Grid(nx, ny, 1.0);
    initial.scale.place = std::move(place);
    return initial;
}

std::array<int, 4> texel(const Drape& drape, int x, int y) {
    const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(drape.width) +
                         static_cast<std::size_t>(x));
    return {drape.texels[at], drape.texels[at + 1], drape.texels[at + 2], drape.texels[at + 3]};
}

std::string refusal(Scene scene, InitialBed initial) {
    try {
        lay_drape(scene, initial);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(LayDrape, FitsAPictureWithoutPlaceToTheBedPixelByPixel) {
    const ScratchFolder folder;
    test::write_text(folder / "map.png", bytes_of(encode_png(numbered(40, 30), 72.0, {})));
    Scene scene = scene_in(folder, "map.png");
    InitialBed initial = bed_at(std::nullopt);
    lay_drape(scene, initial);
    ASSERT_TRUE(scene.view.drape);
    const Drape& drape = *scene.view.drape;
    ASSERT_EQ(drape.width, 40);
    ASSERT_EQ(drape.height, 30);
    EXPECT_EQ(texel(drape, 0, 0), (std::array{10, 39, 77, 255}));  // south-west: the last row
    EXPECT_EQ(texel(drape, 39, 29), (std::array{49, 10, 77, 255}));
    EXPECT_EQ(initial.note, "look.drape: map.png has no georeference: fitted to the bed's extent");
    ASSERT_EQ(initial.inputs.size(), 1U);
    EXPECT_TRUE(test::contains(initial.inputs.front().path, "map.png"));
}

TEST(LayDrape, PlacesAPictureByItsWorldFile) {
    const ScratchFolder folder;
    test::write_text(folder / "map.png", bytes_of(encode_png(numbered(40, 30), 72.0, {})));
    // Pixels of 5 m; the upper left pixel's middle at (1002.5, 2147.5): 1000 … 1200, 2000 … 2150.
    test::write_text(folder / "map.pgw", "5\n0\n0\n-5\n1002.5\n2147.5\n");
    Scene scene = scene_in(folder, "map.png");
    // A bed of 100 m × 50 m within it, whose north-western corner is at (1050, 2100).
    InitialBed initial = bed_at(GeoReference{1050.0, 2050.0, 5.0, 5.0});
    lay_drape(scene, initial);
    const Drape& drape = *scene.view.drape;
    ASSERT_EQ(drape.width, 20);
    ASSERT_EQ(drape.height, 10);
    EXPECT_EQ(texel(drape, 0, 9), (std::array{10 + 10, 10 + 10, 77, 255}));
    EXPECT_EQ(texel(drape, 19, 0), (std::array{10 + 29, 10 + 19, 77, 255}));
    EXPECT_EQ(initial.note, "");
    // A place that changes is another picture.
    test::write_text(folder / "map.pgw", "5\n0\n0\n-5\n1007.5\n2147.5\n");
    InitialBed moved = bed_at(GeoReference{1050.0, 2050.0, 5.0, 5.0});
    lay_drape(scene, moved);
    EXPECT_NE(moved.inputs.at(0).hash, initial.inputs.at(0).hash);
}

TEST(LayDrape, LeavesTheGroundBesideThePicture) {
    const ScratchFolder folder;
    test::write_text(folder / "map.png", bytes_of(encode_png(numbered(10, 10), 72.0, {})));
    test::write_text(folder / "map.pgw", "5\n0\n0\n-5\n2.5\n47.5\n");
    Scene scene = scene_in(folder, "map.png");
    InitialBed initial = bed_at(GeoReference{25.0, 0.0, 5.0, 5.0});
    lay_drape(scene, initial);
    const Drape& drape = *scene.view.drape;
    EXPECT_EQ(texel(drape, 4, 0)[3], 255);
    EXPECT_EQ(texel(drape, 5, 0)[3], 0);
    initial = bed_at(GeoReference{60.0, 0.0, 5.0, 5.0});
    EXPECT_TRUE(test::contains(refusal(scene, initial), "scene.toml:4:"));
    EXPECT_TRUE(test::contains(refusal(scene, initial), "map.png: lies beside the bed"));
}

/// A picture in degrees over a bed in metres: its middle is where PROJ has it.
TEST(LayDrape, BringsAPictureToTheBedsReferenceSystem) {
    const ScratchFolder folder;
    const double step = 0.001;
    const GeoReference degrees{-105.02, 39.99, step, step, true, "EPSG:4326"};
    test::write_text(folder / "map.tif", geotiff_picture(numbered(40, 20), degrees));
    Scene scene = scene_in(folder, "map.tif");
    // 105° W is the middle of zone 13: easting 500 km; 40° N there is northing 4 427 757.2186 m.
    InitialBed initial = bed_at(GeoReference{499500.0, 4427257.2186, 50.0, 100.0, false, utm_13});
    lay_drape(scene, initial);
    const Drape& drape = *scene.view.drape;
    // The bed's middle is the corner of four pixels: columns 19 and 20, rows 9 and 10.
    const auto middle = texel(drape, drape.width / 2, drape.height / 2);
    EXPECT_NEAR(middle[0], 10 + 19.5, 0.6);
    EXPECT_NEAR(middle[1], 10 + 9.5, 0.6);
    EXPECT_EQ(middle[3], 255);
    // 500 m are 0.005855° of longitude, 5.9 pixels, and 0.004503° of latitude.
    const auto east = texel(drape, drape.width - 1, drape.height / 2);
    EXPECT_NEAR(east[0], 10 + 19.5 + 5.86 * (drape.width - 1.0) / drape.width, 1.0);
}

TEST(LayDrape, RefusesWhatIsNoPictureInOneLineAtItsKey) {
    const ScratchFolder folder;
    const InitialBed initial = bed_at(std::nullopt);
    EXPECT_TRUE(test::contains(refusal(scene_in(folder, "none.png"), initial),
                               "scene.toml:4:9: look.drape \"none.png\" does not exist"));
    test::write_text(folder / "text.tif", "no picture");
    EXPECT_TRUE(test::contains(refusal(scene_in(folder, "text.tif"), initial),
                               "text.tif: cannot be read as a picture"));
    const std::string whole = bytes_of(encode_png(numbered(40, 30), 72.0, {}));
    test::write_text(folder / "cut.png", whole.substr(0, whole.size() - 40));
    EXPECT_TRUE(test::contains(refusal(scene_in(folder, "cut.png"), initial), "scene.toml:4:9: "));
    test::write_text(folder / "map.png", bytes_of(encode_png(numbered(4, 3), 72.0, {})));
    test::write_text(folder / "map.pgw", "5\n0\nnone\n");
    EXPECT_TRUE(
        test::contains(refusal(scene_in(folder, "map.png"), initial), "is not a world file"));
    Scene other = scene_in(folder, "map.png");
    other.trusted = false;
    EXPECT_TRUE(test::contains(refusal(other, initial), "is not one of the files"));
}

TEST(LayDrape, AStillOfAMissingDrapeWritesNothing) {
    const ScratchFolder folder;
    scene_in(folder, "none.png");
    const test::Ended ended =
        test::fumon({"still", "scene.toml", "-o", "still.png"}, folder.path());
    EXPECT_EQ(ended.status, 2);
    EXPECT_TRUE(test::contains(ended.errors, "scene.toml:4:9: look.drape")) << ended.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "still.png"));
}

}  // namespace
}  // namespace fumon
