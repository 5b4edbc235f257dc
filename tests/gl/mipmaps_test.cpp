#include "gl/mipmaps.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gl/context.h"

namespace fumon {
namespace {

const gl::TextureLayout layout{
    GL_R16, GL_RED, GL_UNSIGNED_SHORT, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT};

/// The texels of one of its mipmaps.
std::vector<std::uint16_t> mipmap(const gl::Texture2D& texture, int level) {
    const gl::Framebuffer framebuffer;
    const gl::Functions& gl = gl::functions();
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(),
                            level);
    const glm::ivec2 size = texture.size(level);
    std::vector<std::uint16_t> texels(static_cast<std::size_t>(size.x * size.y));
    gl.ReadPixels(0, 0, size.x, size.y, GL_RED, GL_UNSIGNED_SHORT, texels.data());
    return texels;
}

TEST(MipmapMaker, EachLevelIsTheMeanOfFourTexels) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    const gl::MipmapMaker mipmaps;
    constexpr int width = 8;
    constexpr int height = 4;
    std::vector<std::uint16_t> texels;
    texels.reserve(std::size_t{width} * std::size_t{height});
    for (int i = 0; i < width * height; ++i)
        texels.push_back(static_cast<std::uint16_t>(1000 * (i * 37 % 61)));
    const gl::Texture2D texture(width, height, layout, texels.data());
    ASSERT_EQ(texture.coarsest_mip_level(), 3);
    for (int turn = 0; turn < 2; ++turn) {  // other texels again
        mipmaps.make(texture);
        std::vector<std::uint16_t> finer = texels;
        for (int level = 1; level <= 2; ++level) {
            const std::size_t across = width >> level;
            const std::vector<std::uint16_t> coarser = mipmap(texture, level);
            ASSERT_EQ(coarser.size(), finer.size() / 4);
            for (std::size_t i = 0; i < coarser.size(); ++i) {
                const std::size_t south = 4 * (i / across) * across + 2 * (i % across);
                const std::size_t north = south + 2 * across;
                const int sum = finer[south] + finer[south + 1] + finer[north] + finer[north + 1];
                EXPECT_NEAR(coarser[i], 0.25 * sum, 1.0) << level << ' ' << i;
            }
            finer = coarser;
        }
        EXPECT_NEAR(mipmap(texture, 3)[0], 0.5 * (finer[0] + finer[1]), 1.0);
        for (std::uint16_t& texel : texels) texel = static_cast<std::uint16_t>(65535 - texel);
        texture.upload(texels.data());
    }
    EXPECT_NO_THROW(gl::check_errors("mipmaps"));
}

TEST(MipmapMaker, StopsAtTheCoarsestOfTheLayout) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    gl::TextureLayout shallow = layout;
    shallow.coarsest_mip_level = 2;
    EXPECT_EQ(gl::Texture2D(64, 64, shallow).coarsest_mip_level(), 2);
    EXPECT_EQ(gl::Texture2D(5, 3, layout).coarsest_mip_level(), 2);
    EXPECT_EQ(gl::Texture2D(5, 3, layout).size(2), glm::ivec2(1, 1));
}

TEST(MipmapMaker, OddSidesKeepTheirMean) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    const gl::MipmapMaker mipmaps;
    const std::vector<std::uint16_t> texels = {1000, 2000, 3000, 4000, 5000, 1000, 2000, 3000,
                                               4000, 5000, 1000, 2000, 3000, 4000, 5000};
    const gl::Texture2D texture(5, 3, layout, texels.data());
    mipmaps.make(texture);
    const std::vector<std::uint16_t> half = mipmap(texture, 1);
    ASSERT_EQ(half.size(), 2U);
    EXPECT_NEAR(half[0], 1750.0, 1.0) << "a quarter of the way, between 1000 and 2000";
    EXPECT_NEAR(half[1], 4250.0, 1.0);
    EXPECT_NEAR(mipmap(texture, 2)[0], 3000.0, 1.0);
}

}  // namespace
}  // namespace fumon
