#include "picture/environment.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace fumon {
namespace {

RenderingEnvironment pinned() {
    return opengl_environment("osmesa", "llvmpipe (LLVM 15.0.6, 128 bits)",
                              "4.5 (Core Profile) Mesa 22.3.6", true);
}

TEST(RenderingEnvironment, TakesVersionsFromOpenGlsNames) {
    EXPECT_EQ(pinned().mesa_version, "22.3.6");
    EXPECT_EQ(pinned().llvm_version, "15.0.6");
    const auto newer = opengl_environment("egl", "llvmpipe (LLVM 19.1.7, 256 bits)",
                                          "4.5 (Core Profile) Mesa 25.0.0-devel (git-ab12)", false);
    EXPECT_EQ(newer.mesa_version, "25.0.0-devel");
    EXPECT_EQ(newer.llvm_version, "19.1.7");
    const auto card =
        opengl_environment("egl", "NVIDIA H200/PCIe/SSE2", "4.6.0 NVIDIA 550.54", false);
    EXPECT_EQ(card.mesa_version, "");
    EXPECT_EQ(card.llvm_version, "");
}

TEST(RenderingEnvironment, DifferencesAreTold) {
    EXPECT_EQ(difference(pinned(), pinned()), "");
    auto newer = pinned();
    newer.mesa_version = "24.0.1";
    newer.gl_version = "4.5 (Core Profile) Mesa 24.0.1";
    EXPECT_EQ(difference(pinned(), newer), "Mesa 22.3.6 there, 24.0.1 here");
    newer.llvm_version = "17.0.6";
    newer.pinned = false;
    EXPECT_EQ(
        difference(pinned(), newer),
        "Mesa 22.3.6 there, 24.0.1 here, LLVM 15.0.6 there, 17.0.6 here, pinned there, not here");
    auto other = pinned();
    other.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    EXPECT_EQ(
        difference(pinned(), other),
        "renderer llvmpipe (LLVM 15.0.6, 128 bits) there, llvmpipe (LLVM 15.0.6, 256 bits) here");
    EXPECT_EQ(difference(pinned(), {}).substr(0, 35), "backend osmesa there, unknown here,");
    auto driver = pinned();
    driver.backend = "egl";
    EXPECT_EQ(difference(pinned(), driver), "backend osmesa there, egl here");
}

TEST(RenderingEnvironment, PixelsMustBeEqualInOnePinnedEnvironmentOnly) {
    EXPECT_EQ(why_pixels_may_differ(pinned(), pinned()), "");
    auto egl = pinned();
    egl.backend = "egl";
    EXPECT_EQ(why_pixels_may_differ(pinned(), egl), "") << "the same llvmpipe";
    auto unpinned = pinned();
    unpinned.pinned = false;
    EXPECT_EQ(why_pixels_may_differ(unpinned, pinned()), "pinned here, not there");
    EXPECT_EQ(why_pixels_may_differ(unpinned, unpinned),
              "neither is pinned, so that pixels depend on the processor");
    egl.mesa_version = "24.0.1";
    EXPECT_EQ(why_pixels_may_differ(pinned(), egl), "Mesa 22.3.6 there, 24.0.1 here");
    const RenderingEnvironment figure{"cairo", "Cairo 1.16.0", "", "", "", false};
    EXPECT_NE(why_pixels_may_differ(figure, figure), "") << "text in the system's fonts";
    EXPECT_EQ(why_pixels_may_differ(figure, pinned()).substr(0, 32),
              "backend cairo there, osmesa here");
}

TEST(RenderingEnvironment, IsReadBackFromItsText) {
    EXPECT_EQ(parse_environment(environment_text(pinned())), pinned());
    EXPECT_EQ(parse_environment("{}"), RenderingEnvironment{});
    EXPECT_EQ(parse_environment(R"({"mesa_version": "22.3.6", "later": 1})").mesa_version,
              "22.3.6");
    for (const char* damaged : {"", "{", "[]", "3", R"({"pinned": "yes"})", R"({"backend": 4})"})
        EXPECT_THROW(parse_environment(damaged), InputError) << damaged;
}

}  // namespace
}  // namespace fumon
