#include "gl/context.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "support/missing_library.h"

namespace fumon::gl {
namespace {

class EachBackend : public ::testing::TestWithParam<Backend> {
  protected:
    void SetUp() override {
        try {
            context_ = Context::create(GetParam());
        } catch (const Error& error) {
            if (!fumon::test::library_is_missing(error.what())) throw;
            GTEST_SKIP() << error.what();
        }
    }
    std::unique_ptr<Context> context_;
};

TEST_P(EachBackend, OffersACoreContext) {
    EXPECT_EQ(context_->backend_name(), GetParam() == Backend::egl ? "egl" : "osmesa");
    EXPECT_FALSE(context_->renderer_name().empty());
    GLint major = 0;
    GLint minor = 0;
    functions().GetIntegerv(GL_MAJOR_VERSION, &major);
    functions().GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 33) << context_->version();
}

TEST_P(EachBackend, ClearsATargetToItsColour) {
    const DepthBuffer depth(3, 2);
    const RenderTarget target(3, 2, TextureLayout{}, &depth);
    target.bind();
    functions().ClearColor(1.0F, 0.0F, 0.2F, 1.0F);
    functions().Clear(GL_COLOR_BUFFER_BIT);
    std::array<std::uint8_t, 24> pixels{};
    functions().ReadPixels(0, 0, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        EXPECT_EQ(pixels[i], 255);
        EXPECT_EQ(pixels[i + 1], 0);
        EXPECT_EQ(pixels[i + 2], 51);
    }
    check_errors("the test");
}

TEST_P(EachBackend, ReportsErrorsByPlace) {
    functions().Enable(0x1234);
    try {
        check_errors("the test");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "OpenGL failed in the test: invalid enumeration (0x0500)");
    }
    EXPECT_NO_THROW(check_errors("the test"));
}

TEST_P(EachBackend, RefusesATextureBeyondTheLimit) {
    EXPECT_THROW(Texture2D(1 << 20, 1, TextureLayout{}), Error);
}

TEST_P(EachBackend, RefusesAShaderThatDoesNotExist) {
    EXPECT_THROW(Program("none.vert.glsl", "none.frag.glsl"), Error);
}

INSTANTIATE_TEST_SUITE_P(Context, EachBackend, ::testing::Values(Backend::osmesa, Backend::egl),
                         [](const auto& tested) {
                             return tested.param == Backend::egl ? "egl" : "osmesa";
                         });

TEST(Context, NoneIsCurrentAfterTheLastIsGone) {
    { const auto context = Context::create(Backend::automatic); }
    EXPECT_THROW(functions(), Error);
}

TEST(Context, OneCanBeMadeCurrentAgainAfterAnother) {
    const auto first = Context::create(Backend::automatic);
    const auto second = Context::create(Backend::automatic);
    first->make_current();
    const Texture2D texture(1, 1, TextureLayout{});
    EXPECT_NO_THROW(check_errors("the test"));
}

}  // namespace
}  // namespace fumon::gl
