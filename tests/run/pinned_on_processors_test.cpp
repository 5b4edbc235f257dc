// What pinning does not override: the processor. Each is emulated, which takes a minute or two a
// picture, so that it is done where FUMON_EMULATOR names the emulator (Debian's qemu-user has
// /usr/bin/qemu-x86_64).

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/error.h"
#include "picture/png.h"
#include "run/picture_text.h"
#include "support/program.h"

namespace fumon::test {
namespace {

constexpr const char* needed =
    "pinned pictures need SSE4.1 (processors from 2008 on), which this processor lacks\n";

class PinnedOnProcessors : public ::testing::Test {
  protected:
    /// Sand of which pixels are known to differ where they are not pinned.
    void SetUp() override {
#if !defined(__x86_64__) || defined(FUMON_SANITIZED)
        GTEST_SKIP() << "the emulator runs fumon for x86-64, without sanitizers";
#endif
        const char* emulator = std::getenv("FUMON_EMULATOR");
        if (emulator == nullptr) GTEST_SKIP() << "FUMON_EMULATOR names no emulator";
        emulator_ = emulator;
        write_text(folder_ / "scene.toml",
                   "seed = 5\n[model]\nname = \"sand\"\n[grid]\nnx = 48\nny = 40\n[run]\nsteps = "
                   "8\n[image]\nwidth = 200\nheight = 120\n");
        write_text(folder_ / "b.toml",
                   "scene = \"scene.toml\"\n[cases]\nsand = {step = 8, picture = true, "
                   "thumbnail_difference = 2}\n");
    }

    Ended run(std::vector<std::string> arguments, const std::string& processor = "") {
        if (processor.empty()) return fumon(arguments, folder_.path());
        arguments.insert(arguments.begin(), {"-cpu", processor, FUMON_PROGRAM});
        return fumon(arguments, folder_.path(), {}, emulator_);
    }

    PictureOrigin still(const std::string& name, const std::string& processor = "") {
        ended_ = run({"still", "scene.toml", "--step", "8", "--pinned", "-o", name}, processor);
        if (ended_.status != 0) throw Error(ended_.errors);
        return read_origin(folder_ / name);
    }

    ScratchFolder folder_;
    std::string emulator_;
    Ended ended_;
};

TEST_F(PinnedOnProcessors, WithSse41PixelsAreTheSame) {
    const PictureOrigin here = still("here.png");
    EXPECT_TRUE(here.environment->pinned);
    const PictureOrigin there = still("there.png", "Penryn");
    EXPECT_EQ(there.pixels_hash, here.pixels_hash);
    EXPECT_EQ(*there.environment, *here.environment);
}

TEST_F(PinnedOnProcessors, WithoutSse41ThatIsSaidAndRecorded) {
    const PictureOrigin there = still("there.png", "qemu64");
    EXPECT_NE(ended_.errors.find(std::string("not pinned, and recorded so: ") + needed),
              std::string::npos)
        << ended_.errors;
    EXPECT_FALSE(there.environment->pinned);
}

TEST_F(PinnedOnProcessors, WithoutSse41ThePortableTierCompares) {
    ASSERT_EQ(run({"verify", "--update", "--pinned", "b.toml"}).status, 0);
    const Ended strict = run({"verify", "b.toml"});
    EXPECT_EQ(strict.output,
              "ok       b sand: strict: state and pixels as recorded\n"
              "1 of 1 as recorded\n");
    const Ended portable = run({"verify", "b.toml"}, "qemu64");
    EXPECT_EQ(portable.status, 0) << portable.output;
    EXPECT_NE(portable.errors.find(std::string("the portable tier compares: ") + needed),
              std::string::npos)
        << portable.errors;
    EXPECT_NE(portable.output.find("portable (pinned there, not here): "), std::string::npos)
        << portable.output;
}

}  // namespace
}  // namespace fumon::test
