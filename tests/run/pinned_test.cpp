#include "gl/pinned.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "files/atomic_file.h"
#include "gl/context.h"
#include "picture/png.h"
#include "run/picture_text.h"
#include "support/missing_library.h"
#include "support/program.h"

namespace fumon::test {
namespace {

/// The processors that Mesa can be told to draw for.
const std::vector<std::string> processors = {"sse2", "sse3", "ssse3", "sse4.1", "avx"};

/// What a user may bring along.
const std::vector<std::string> odd_settings = {
    "GALLIUM_OVERRIDE_CPU_CAPS=avx", "LP_NUM_THREADS=1", "GALLIVM_PERF=brilinear,nopt",
    "LP_PERF=no_tex,no_mipmap", "LP_NATIVE_VECTOR_WIDTH=256"};

std::vector<std::string> drawn_for(const std::string& processor) {
    return {"GALLIUM_OVERRIDE_CPU_CAPS=" + processor};
}

class PinnedTest : public ::testing::Test {
  protected:
    /// Sand of which pixels are known to differ between processors.
    void SetUp() override {
#if !defined(__x86_64__)
        GTEST_SKIP() << "pixels are pinned on x86-64 only";
#endif
        write_text(folder_ / "scene.toml",
                   "seed = 5\n[model]\nname = \"sand\"\n[grid]\nnx = 96\nny = 80\n[run]\nsteps = "
                   "60\n[frames]\nevery = 60\n[image]\nwidth = 640\nheight = 400\n");
    }

    PictureOrigin still(const std::string& name, std::vector<std::string> more,
                        const std::vector<std::string>& environment = {}) {
        std::vector<std::string> arguments{"still", "scene.toml", "-o", name};
        arguments.insert(arguments.end(), more.begin(), more.end());
        ended_ = fumon(arguments, folder_.path(), environment);
        if (ended_.status != 0) throw Error(ended_.errors);
        return read_origin(folder_ / name);
    }

    ScratchFolder folder_;
    Ended ended_;
};

// Whether pixels that are not pinned differ depends on this processor.
TEST_F(PinnedTest, PixelsAreTheSameWhateverTheProcessorAndTheSettings) {
    const PictureOrigin plain = still("plain.png", {"--quiet"});
    EXPECT_FALSE(plain.environment->pinned);

    const PictureOrigin pinned = still("pinned.png", {"--quiet", "--pinned"});
    EXPECT_TRUE(pinned.environment->pinned);
    for (const std::string& processor : processors) {
        const PictureOrigin other =
            still("other.png", {"--quiet", "--pinned"}, drawn_for(processor));
        EXPECT_EQ(other.pixels_hash, pinned.pixels_hash) << processor;
        EXPECT_EQ(*other.environment, *pinned.environment) << processor;
    }
    const PictureOrigin odd = still("odd.png", {"--verbose", "--pinned"}, odd_settings);
    EXPECT_EQ(odd.pixels_hash, pinned.pixels_hash);
    for (const std::string line : {"--pinned: GALLIUM_OVERRIDE_CPU_CAPS=avx is overridden: sse4.1",
                                   "--pinned: LP_NUM_THREADS=1 is overridden: 4",
                                   "--pinned: LP_PERF=no_tex,no_mipmap is "
                                   "overridden: unset"}) {
        EXPECT_NE(ended_.errors.find(line), std::string::npos) << ended_.errors;
    }
}

TEST_F(PinnedTest, OSMesaAndEglDrawTheSamePixels) {
    try {
        const PictureOrigin osmesa =
            still("osmesa.png", {"--quiet", "--pinned", "--gl", "osmesa"}, odd_settings);
        const PictureOrigin egl =
            still("egl.png", {"--quiet", "--pinned", "--gl", "egl"}, odd_settings);
        EXPECT_EQ(osmesa.pixels_hash, egl.pixels_hash);
        EXPECT_EQ(why_pixels_may_differ(*osmesa.environment, *egl.environment), "");
        EXPECT_TRUE(egl.environment->pinned);
    } catch (const Error& error) {
        if (!library_is_missing(error.what())) throw;
        GTEST_SKIP() << error.what();
    }
}

TEST_F(PinnedTest, TheManifestSaysWhatDrew) {
    ASSERT_EQ(fumon({"run", "scene.toml", "-o", "out", "--quiet", "--pinned", "--set",
                     "output.movie=false"},
                    folder_.path())
                  .status,
              0);
    const auto drawing = read_manifest(folder_ / "out")["drawing"];
    EXPECT_EQ(drawing["pinned"], true);
    EXPECT_FALSE(drawing["mesa_version"].get<std::string>().empty());
    EXPECT_FALSE(drawing["llvm_version"].get<std::string>().empty());
    const PictureOrigin frame = read_origin(folder_ / "out/frames/frame_000001.png");
    EXPECT_EQ(parse_environment(drawing.dump()), *frame.environment);
    EXPECT_EQ(still("still.png", {"--quiet", "--pinned"}).pixels_hash, frame.pixels_hash);
}

TEST_F(PinnedTest, APinnedPictureIsMadeAgainPinned) {
    still("pinned.png", {"--quiet", "--pinned"});
    for (const std::string& processor : processors) {
        const Ended again = fumon({"again", "pinned.png"}, folder_.path(), drawn_for(processor));
        EXPECT_EQ(again.errors, "pinned-again.png: the same pixels as pinned.png\n") << processor;
    }
}

TEST_F(PinnedTest, OtherPixelsOfAPictureThatIsNotPinnedAreExplained) {
    still("plain.png", {"--quiet"});
    PictureText texts = read_png_texts(folder_ / "plain.png");
    const auto recorded = std::find_if(texts.begin(), texts.end(), [](const auto& text) {
        return text.first == "fumon:pixels-sha256";
    });
    ASSERT_NE(recorded, texts.end());
    recorded->second.front() = recorded->second.front() == '0' ? '1' : '0';
    write_file(folder_ / "elsewhere.png",
               encode_png(read_png(folder_ / "plain.png"), screen_dots_per_inch, texts));
    const Ended again = fumon({"again", "elsewhere.png"}, folder_.path());
    EXPECT_NE(again.errors.find("neither is pinned, so that pixels depend on the processor"),
              std::string::npos)
        << again.errors;
}

TEST_F(PinnedTest, TextInTheSystemsFontsIsNotPinnedAndThatIsSaid) {
    write_text(folder_ / "air.toml",
               "[model]\nname = \"airflow\"\nnz = 20\n[grid]\nnx = 60\ncell_size = 5e-5\n[run]\n"
               "steps = 2\n[look]\nmode = \"figure\"\n[image]\nwidth = 640\nheight = 400\n");
    const Ended ended = fumon({"still", "air.toml", "-o", "air.png", "--pinned"}, folder_.path());
    ASSERT_EQ(ended.status, 0) << ended.errors;
    EXPECT_NE(
        ended.errors.find("not pinned, and recorded so: its text is set in the system's fonts"),
        std::string::npos)
        << ended.errors;
    EXPECT_FALSE(read_origin(folder_ / "air.png").environment->pinned);
}

TEST(Pinning, ComesBeforeTheFirstContext) {
    EXPECT_EQ(gl::pinning_obstacle("llvmpipe (LLVM 15.0.6, 128 bits)"), "");
    EXPECT_EQ(gl::pinning_obstacle("NVIDIA H200/PCIe/SSE2"),
              "NVIDIA H200/PCIe/SSE2 draws it, not Mesa's llvmpipe");
    const auto context = gl::Context::create(gl::Backend::automatic);
    EXPECT_THROW(gl::pin_rendering(), Error);
    EXPECT_FALSE(gl::rendering_is_pinned());
}

}  // namespace
}  // namespace fumon::test
