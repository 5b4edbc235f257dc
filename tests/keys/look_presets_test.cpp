#include "keys/look_presets.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "scene/read.h"
#include "scene/write.h"

namespace fumon {
namespace {

const std::string least = "[model]\nname = \"sand\"\n[run]\nsteps = 1\n";

TEST(LookPresets, StandForTheDefaultsOfWhatASceneLeavesOut) {
    const Scene usual = parse_scene(least, "scene.toml", "");
    const Scene paper = parse_scene(least + "[look]\npreset = \"paper\"\n", "scene.toml", "");
    EXPECT_EQ(usual.view.look.mode, ViewMode::scenic);
    EXPECT_EQ(paper.view.look.mode, ViewMode::figure);
    EXPECT_EQ(paper.view.sun.elevation, 40.0);
    const Scene own = parse_scene(least + "[sun]\nelevation = 7\n[look]\npreset = \"paper\"\n",
                                  "scene.toml", "", {"sun.azimuth=10"});
    EXPECT_EQ(own.view.sun.elevation, 7.0) << "wherever it stands";
    EXPECT_EQ(own.view.sun.azimuth, 10.0);
    EXPECT_EQ(own.view.look.mode, ViewMode::figure);
    const Scene set = parse_scene(least, "scene.toml", "", {"look.preset=paper"});
    EXPECT_EQ(to_toml(set), to_toml(paper));
}

TEST(LookPresets, AreGoneFromTheResolvedScene) {
    const Scene scene = parse_scene(least + "[look]\npreset = \"overcast\"\n", "scene.toml", "");
    const std::string written = to_toml(scene);
    EXPECT_NE(written.find("preset = \"\""), std::string::npos);
    EXPECT_EQ(to_toml(parse_scene(written, "resolved.toml", "")), written);
}

TEST(LookPresets, AreAllSound) {
    const std::vector<std::string> names = look_preset_names();
    EXPECT_TRUE(std::ranges::find(names, "golden-hour") != names.end());
    for (const std::string& name : names)
        EXPECT_NO_THROW(parse_scene(least, "scene.toml", "", {"look.preset=" + name})) << name;
}

TEST(LookPresets, ThatAreNotThereAreRefused) {
    const auto message = [](const std::string& text) -> std::string {
        try {
            parse_scene(least + text, "scene.toml", "");
        } catch (const InputError& fault) {
            return fault.what();
        }
        return "";
    };
    EXPECT_EQ(message("[look]\npreset = \"papre\"\n"),
              "scene.toml:6:10: unknown look \"papre\"; did you mean \"paper\"?");
    EXPECT_EQ(message("[look]\npreset = \"../paper\"\n").substr(0, 42),
              "scene.toml:6:10: unknown look \"../paper\"; ");
}

}  // namespace
}  // namespace fumon
