#include "render/samples/block_rasteriser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/worker_pool.h"
#include "vectors/target.h"

namespace fumon {
namespace {

constexpr int width = 120;
constexpr int height = 90;

Camera slanting_camera() {
    Camera camera;
    camera.right = {0.8, -0.6, 0.0};
    camera.forward = {0.48, 0.64, -0.6};
    camera.up = {0.36, 0.48, 0.8};
    camera.eye = -3.0 * camera.forward;
    camera.half = {0.34, 0.255};
    camera.near_depth = 1.5;
    camera.far_depth = 5.0;
    return camera;
}

/// A flat square of one unit, grey, with a wall of the same height under its southern border.
struct Table {
    std::vector<float> positions{0, 0, 1, 0, 1, 1, 0, 1};
    std::vector<float> heights{0, 0, 0, 0};
    std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3};
    std::vector<float> wall_places{0, 0, 1, 0, 1, 0, 0, 0};
    std::vector<float> wall_heights{-0.1F, -0.1F, 0, 0};

    [[nodiscard]] BlockMesh shape() const {
        BlockMesh shape;
        shape.surface = {positions, heights};
        shape.sides = {wall_places, wall_heights};
        shape.surface_triangles = triangles;
        shape.side_triangles[2] = triangles;  // south
        shape.extent = {1.0, 1.0};
        shape.double_sided = false;
        return shape;
    }
};

/// Drawn in tiles, the wall red, the surface a chequered grey, what is behind both blue.
/// `coloured`: of the wall's pixels every so many.
Image drawn(const std::vector<Tile>& tiles, int threads, bool open = false,
            std::size_t coloured = 1) {
    const Table table;
    const Camera camera = slanting_camera();
    WorkerPool pool(threads);
    BlockRasteriser samples(0.0F);
    BlockTexture colours{8, 8, {}};
    for (int i = 0; i < 64; ++i)
        colours.texels.push_back((i + i / 8) % 2 == 0 ? 0xFF505050U : 0xFFB0B0B0U);
    samples.set_texture({1.0F, 1.0F}, colours);
    Image image(width, height);
    if (open) image.alpha.resize(std::size_t{width} * height, 7);
    for (const Tile& tile : tiles) {
        samples.rasterise(table.shape(), camera, tile, pool, image);
        std::vector<ColourPlanes> behind;
        for (int y = 0; y < tile.height; ++y) {
            behind.emplace_back(tile.width);
            std::fill(behind.back().blue.begin(), behind.back().blue.end(), std::uint8_t{200});
        }
        for (int side = 0; side < 4; ++side) {
            const Tile& part = samples.side_rectangle(side);
            if (side != 2) {
                EXPECT_EQ(part.width, 0);
            }
            std::vector<std::uint32_t>& colours_there = samples.side_colours(side);
            colours_there.assign(
                static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height), 0U);
            for (std::size_t i = 0; i < colours_there.size(); i += coloured)
                colours_there[i] = 0xFF0000C8U;
        }
        samples.finish(behind, pool, image);
    }
    return image;
}

TEST(BlockRasteriser, PixelsAreTheSameInTilesOnThreadsAndTargets) {
    const std::vector<Tile> whole{{0, 0, width, height}};
    const Image expected = drawn(whole, 1);
    EXPECT_EQ(drawn(whole, 3), expected);
    EXPECT_EQ(drawn({{0, 0, 50, 41}, {50, 0, 70, 41}, {50, 41, 70, 49}, {0, 41, 50, 49}}, 2),
              expected);
    for (const std::string& target : vectors::targets()) {
        vectors::use_target(target);
        EXPECT_EQ(drawn(whole, 2), expected) << target;
    }
    vectors::use_target(vectors::targets().front());
}

TEST(BlockRasteriser, EdgesAreMixedFromWhatMeetsThere) {
    const Image image = drawn({{0, 0, width, height}}, 1);
    std::array<int, 4> seen{};  // surface, wall, behind, edges
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const std::array<int, 3> pixel{image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
        if (pixel == std::array{200, 0, 0}) {
            ++seen[1];
        } else if (pixel == std::array{0, 0, 200}) {
            ++seen[2];
        } else if (pixel[0] == pixel[1] && pixel[1] == pixel[2]) {
            EXPECT_GE(pixel[0], 0x50);
            EXPECT_LE(pixel[0], 0xB0);
            ++seen[0];
        } else {
            // Two or three things, whose squares are averaged: n fourths of each.
            EXPECT_LE(pixel[1], 0xB0);
            EXPECT_TRUE(pixel[0] >= 0x28 || pixel[2] >= 100);
            ++seen[3];
        }
    }
    EXPECT_GT(seen[0], 2000);
    EXPECT_GT(seen[1], 150);
    EXPECT_GT(seen[2], 2000);
    EXPECT_GT(seen[3], 100);
    EXPECT_LT(seen[3], 400);
}

TEST(BlockRasteriser, ASideTakesTheNearestColourWhereItHasNone) {
    const std::vector<Tile> whole{{0, 0, width, height}};
    EXPECT_EQ(drawn(whole, 1, false, 5), drawn(whole, 1));
}

TEST(BlockRasteriser, AnOpenPictureHasOpacities) {
    const Image closed = drawn({{0, 0, width, height}}, 1);
    const Image open = drawn({{0, 0, width, height}}, 1, true);
    std::array<int, 256> shares{};
    for (std::size_t i = 0; i < open.alpha.size(); ++i) {
        ++shares[open.alpha[i]];
        if (open.alpha[i] != 255) continue;
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(open.rgb[3 * i + c], closed.rgb[3 * i + c]);
    }
    EXPECT_GT(shares[0], 2000);
    EXPECT_GT(shares[255], 2000);
    EXPECT_GT(shares[64] * shares[128] * shares[191], 0);
    EXPECT_EQ(shares[0] + shares[64] + shares[128] + shares[191] + shares[255], width * height);
}

TEST(BlockRasteriser, SurroundingsAreWantedWhereTheyAreSeen) {
    const Table table;
    WorkerPool pool(2);
    BlockRasteriser samples(0.0F);
    BlockTexture colours{1, 1, {0xFF808080U}};
    samples.set_texture({1.0F, 1.0F}, colours);
    Image image(width, height);
    samples.rasterise(table.shape(), slanting_camera(), {0, 0, width, height}, pool, image);
    std::vector<int> wanted(std::size_t{width} * height);
    int pixels = 0;
    for (const Tile& part : samples.background_rectangles()) {
        for (int y = part.y; y < part.y + part.height; ++y)
            for (int x = part.x; x < part.x + part.width; ++x)
                ++wanted[static_cast<std::size_t>(y * width + x)];
        pixels += part.width * part.height;
    }
    const Image shown = drawn({{0, 0, width, height}}, 1);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_LE(wanted[i], 1) << "twice";
        if (shown.rgb[3 * i + 2] == 200 && shown.rgb[3 * i] == 0) {
            EXPECT_EQ(wanted[i], 1);
        }
    }
    EXPECT_LT(pixels, width * height) << "the middle of the block hides them";
}

TEST(BlockRasteriser, ABlockBehindTheCameraIsNotItsOwn) {
    const Camera camera = slanting_camera();
    const glm::dvec3 low(-0.5, -0.5, -0.1);
    const glm::dvec3 high(0.5, 0.5, 0.0);
    EXPECT_TRUE(needs_no_clipping(camera, low, high));
    Camera within = camera;
    within.eye = {0.0, 0.0, 0.05};
    EXPECT_FALSE(needs_no_clipping(within, low, high));
    Camera narrow = camera;
    narrow.half *= 1e-4;
    EXPECT_FALSE(needs_no_clipping(narrow, low, high)) << "places in such a picture are too large";
}

}  // namespace
}  // namespace fumon
