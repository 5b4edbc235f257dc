#include "keys/earlier_defaults.h"

#include <gtest/gtest.h>

#include <any>
#include <string>

#include "keys/override.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "scene/read.h"
#include "scene/scene_keys.h"

namespace fumon {
namespace {

TEST(EarlierDefaultsTest, VersionsCompareByTheirNumbers) {
    EXPECT_TRUE(is_earlier_version("0.1.0", "0.2.0"));
    EXPECT_TRUE(is_earlier_version("0.9.0", "0.10.0"));
    EXPECT_TRUE(is_earlier_version("1.2.3", "1.2.4"));
    EXPECT_FALSE(is_earlier_version("0.2.0", "0.2.0"));
    EXPECT_FALSE(is_earlier_version("1.0.0", "0.2.0"));
    for (const char* none : {"", "0.1", "0.x.1", "new"}) {
        EXPECT_FALSE(is_earlier_version(none, "0.2.0")) << none;
        EXPECT_FALSE(is_earlier_version("0.1.0", none)) << none;
    }
}

/// A table of one key that was 3 before 0.2.0 and is 5 since.
class OneKey {
  public:
    OneKey() {
        table_.integer("look.layers", layers_, {.earlier = {"0.2.0", "3"}});
        table_.text("look.name", name_, {});
    }
    std::int64_t layers_of(std::string_view version) {
        layers_ = 5;
        take_earlier_defaults(table_, version);
        EXPECT_EQ(name_, "sand");
        return layers_;
    }

  private:
    std::int64_t layers_ = 5;
    std::string name_ = "sand";
    KeyTable table_;
};

TEST(EarlierDefaultsTest, AKeyHasTheDefaultOfItsSceneVersion) {
    OneKey key;
    EXPECT_EQ(key.layers_of("0.1.0"), 3);
    EXPECT_EQ(key.layers_of("0.2.0"), 5);
    EXPECT_EQ(key.layers_of(""), 5);
}

TEST(EarlierDefaultsTest, ADefaultMayHaveChangedTwice) {
    KeyTable table;
    std::int64_t layers = 7;
    table.integer("look.layers", layers, {.earlier = {"0.3.0", "5"}, .earliest = {"0.2.0", "3"}});
    take_earlier_defaults(table, "0.3.0");
    EXPECT_EQ(layers, 7);
    take_earlier_defaults(table, "0.2.0");
    EXPECT_EQ(layers, 5);
    take_earlier_defaults(table, "0.1.0");
    EXPECT_EQ(layers, 3);
}

TEST(EarlierDefaultsTest, BlocksOfOlderScenesStandInTheSun) {
    const auto look_of = [](const char* version) {
        Scene scene = default_scene("sand");
        take_earlier_defaults(scene_keys(scene), version);
        return scene.view.look;
    };
    EXPECT_EQ(look_of("").light, LightKind::automatic);
    EXPECT_EQ(look_of("").sides, BlockSides::plain);
    EXPECT_FALSE(look_of("").strata);
    EXPECT_EQ(look_of("0.2.0").light, LightKind::sun);
    EXPECT_EQ(look_of("0.2.0").sides, BlockSides::soil);
    EXPECT_TRUE(look_of("0.2.0").strata);
    EXPECT_EQ(look_of("0.1.0").sides, BlockSides::layers);
}

TEST(EarlierDefaultsTest, AllOfThemCanBeRead) {
    Scene scene = default_scene("sand");
    EXPECT_NO_THROW(take_earlier_defaults(scene_keys(scene), "0.0.0"));
}

TEST(EarlierDefaultsTest, WhatASceneSaysIsKept) {
    const std::string text = "[model]\nname = \"sand\"\n[run]\nsteps = 1\n";
    const auto ground_of = [](const std::string& said) {
        return parse_scene(SceneText{said, "old.toml", "", true, nullptr, "0.1.0"}, {})
            .view.look.ground;
    };
    EXPECT_EQ(ground_of(text), Ground::table);
    EXPECT_EQ(ground_of(text + "[look]\nground = \"endless\"\n"), Ground::endless);
}

/// As scenes that this version kept before it had the key.
TEST(EarlierDefaultsTest, AKeyThatAResolvedSceneLacksMeansWhatItsAbsenceMeant) {
    const std::string text =
        "[model]\nname = \"dunes\"\nhop_length = 2.0\n[grid]\nnx = 20\nny = 20\ncell_size = 1.0\n"
        "[run]\nsteps = 1\n";
    const auto saturation_of = [&](const std::string& said, bool resolved) {
        SceneText kept{text + said, "kept.toml", "", true, nullptr, FUMON_VERSION, resolved};
        return std::any_cast<const DunesParameters&>(parse_scene(kept, {}).model.parameters)
            .saturation_length.word;
    };
    EXPECT_EQ(saturation_of("", true), "hops");
    EXPECT_EQ(saturation_of("", false), "auto");
}

TEST(EarlierDefaultsTest, AnItemThatASettingAddsToAResolvedSceneIsNotOfThen) {
    const std::string text =
        "[model]\nname = \"sand\"\n[grid]\nnx = 20\nny = 20\ncell_size = 1.0\n"
        "[run]\nsteps = 1\n[[person]]\nat = [1.0, 2.0]\n";
    const SceneText kept{text, "kept.toml", "", true, nullptr, FUMON_VERSION, true};
    const Scene scene = parse_scene(kept, read_settings({"person.1.at=[3, 4]"}));
    EXPECT_EQ(scene.view.persons.at(0).facing.value, 180.0) << "kept without the key";
    EXPECT_FALSE(scene.view.persons.at(0).facing.is_word());
    EXPECT_EQ(scene.view.persons.at(1).facing.word, "auto");
}

}  // namespace
}  // namespace fumon
