#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "gl/context.h"
#include "support/shader_values.h"

namespace fumon {
namespace {

/// What the tone curves of shaders/common/colour.glsl make of a linear colour.
std::array<float, 3> toned(int tone, glm::vec3 colour, float contrast = 1.0F, float toe = 0.0F) {
    const glm::vec4 found =
        shader_values("light/toned.frag.glsl", 1, 1, {}, [&](const gl::Program& program) {
            program.set("tone", tone);
            program.set("punch", 0.0F);
            program.set("exposure", 1.0F);
            program.set("contrast", contrast);
            program.set("toe", toe);
            program.set("given", colour);
        }).front();
    return {found.r, found.g, found.b};
}

/// Computed from the published formulas in double precision.
TEST(ToneCurve, MeetsTheReferenceVectors) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    struct Case {
        int tone;
        glm::vec3 given;
        glm::vec3 expected;
    };
    const std::vector<Case> cases{
        {1, {0.18F, 0.18F, 0.18F}, {0.21450F, 0.21450F, 0.21450F}},
        {1, {1, 1, 1}, {0.5901F, 0.5901F, 0.5901F}},
        {1, {4, 2, 1}, {0.883379F, 0.744936F, 0.632765F}},
        {1, {0.5F, 0.3F, 0.1F}, {0.433909F, 0.304003F, 0.159845F}},
        {2, {0.18F, 0.18F, 0.18F}, {0.14F, 0.14F, 0.14F}},
        {2, {1, 1, 1}, {0.869091F, 0.869091F, 0.869091F}},
        {2, {4, 2, 1}, {0.983256F, 0.639951F, 0.468299F}},
        {2, {0.5F, 0.3F, 0.1F}, {0.46F, 0.26F, 0.06F}},
    };
    for (const Case& one : cases) {
        const auto found = toned(one.tone, one.given);
        for (int band = 0; band < 3; ++band) {
            EXPECT_NEAR(found[static_cast<std::size_t>(band)], one.expected[band], 2e-4)
                << one.tone << ' ' << one.given.r << ' ' << band;
        }
    }
}

TEST(ToneCurve, LeavesShadeItsShareOfTheLight) {
    const auto context = gl::Context::create(gl::Backend::automatic);
    const auto grey = [](int tone, float light, float contrast, float toe) {
        return toned(tone, glm::vec3(light), contrast, toe)[1];
    };
    constexpr float low_sun = 1.8F;
    for (const int tone : {0, 1, 2}) {
        const float shade = grey(tone, 0.04F, 1.0F, 0.0F);
        EXPECT_NEAR(grey(tone, 0.04F, low_sun, 1.0F), shade, 0.01F * shade) << tone;
        EXPECT_LT(grey(tone, 0.04F, low_sun, 0.0F), 0.5F * shade) << tone;
        const float bright = grey(tone, 0.6F, low_sun, 0.0F);
        EXPECT_NEAR(grey(tone, 0.6F, low_sun, 1.0F), bright, 1e-4F) << tone;
        float darker = 0.0F;
        for (const float light : {0.01F, 0.03F, 0.05F, 0.09F, 0.15F, 0.18F, 0.2F}) {
            const float brighter = grey(tone, light, low_sun, 1.0F);
            EXPECT_GT(brighter, darker) << tone << ' ' << light;
            darker = brighter;
        }
    }
}

}  // namespace
}  // namespace fumon
