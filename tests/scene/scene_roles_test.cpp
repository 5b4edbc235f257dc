#include "scene/scene_roles.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "keys/key_value.h"
#include "models/registry.h"
#include "scene/json.h"
#include "scene/write.h"
#include "support/changed_key.h"

namespace fumon {
namespace {

using test::change_value;
using test::scene_with_all_keys;

std::set<std::string> paths_with(KeyRole role) {
    Scene scene = scene_with_all_keys("static");
    const KeyTable table = scene_keys(scene);
    std::set<std::string> paths;
    for (const Key& key : table.keys()) {
        if (key.role == role) paths.insert(key.path);
    }
    return paths;
}

TEST(SceneRoles, EachKeyDecidesWhatItSays) {
    using Paths = std::set<std::string>;
    EXPECT_EQ(paths_with(KeyRole::run), (Paths{"seed", "run.steps", "model.name", "bed.file"}));
    EXPECT_EQ(paths_with(KeyRole::label), (Paths{"title"}));
    EXPECT_EQ(paths_with(KeyRole::sampling),
              (Paths{"frames.every", "frames.at", "frames.logarithmic", "output.measure_every",
                     "output.channel_area"}));
    EXPECT_EQ(paths_with(KeyRole::record),
              (Paths{"output.measurements", "output.columns", "output.fields_every",
                     "output.fields_at", "output.avalanches"}));
    EXPECT_EQ(paths_with(KeyRole::file),
              (Paths{"output.frames", "output.movie", "output.bed_every", "output.bed_at",
                     "output.bed_format", "output.world_files", "output.geotiff_frames",
                     "output.exr_frames"}));
    EXPECT_EQ(paths_with(KeyRole::sweep), (Paths{"sweep.over", "sweep.seeds"}));
    const std::set<std::string> pictures{"air",     "camera", "sun",     "look",
                                         "section", "image",  "overlay", "streamers"};
    for (const std::string& path : paths_with(KeyRole::look)) {
        const bool of_file = path == "output.movie_rate" || path == "output.movie_quality" ||
                             path == "output.exr_layers";
        EXPECT_TRUE(of_file || pictures.contains(path.substr(0, path.find('.')))) << path;
    }
    for (const std::string& path : paths_with(KeyRole::figure))
        EXPECT_TRUE(path.starts_with("figure.")) << path;
    for (const std::string& path : paths_with(KeyRole::parameter))
        EXPECT_TRUE(path.starts_with("grid.") || path.starts_with("bed.")) << path;
}

TEST(SceneRoles, EveryKeyOfAModelIsAParameter) {
    for (const ModelEntry& entry : models()) {
        Scene scene = default_scene(std::string(entry.name));
        const KeyTable table = scene_keys(scene);
        for (const Key& key : table.keys()) {
            if (!key.path.starts_with("model.") || key.path == "model.name") continue;
            EXPECT_EQ(key.role, KeyRole::parameter) << entry.name << " " << key.path;
        }
    }
}

TEST(SceneRoles, OnlyTheKeysOfSomeRolesAreKept) {
    constexpr std::array kept{KeyRole::run, KeyRole::parameter};
    for (const ModelEntry& entry : models()) {
        const Scene usual = default_scene(std::string(entry.name));
        Scene scene = scene_with_all_keys(std::string(entry.name));
        const KeyTable table = scene_keys(scene);
        for (const Key& key : table.keys()) {
            if (key.path != "model.name") change_value(key);
        }
        Scene bare = only_roles(scene, kept);
        EXPECT_TRUE(bare.view.overlays.empty() && bare.figure.panels.empty());
        Scene defaults = usual;
        const KeyTable standard = scene_keys(defaults);
        const KeyTable left = scene_keys(bare);
        for (const Key& key : left.keys()) {
            const bool is_kept = key.role == KeyRole::run || key.role == KeyRole::parameter;
            const Key& same = is_kept ? *table.find(key.path) : *standard.find(key.path);
            EXPECT_EQ(value_text(key), value_text(same)) << entry.name << " " << key.path;
        }
    }
}

TEST(SceneRoles, AllListsOfKeptRolesStay) {
    constexpr std::array kept{KeyRole::figure};
    const Scene scene = only_roles(scene_with_all_keys("sand"), kept);
    EXPECT_TRUE(scene.view.overlays.empty());
    ASSERT_EQ(scene.figure.panels.size(), 1U);
    EXPECT_EQ(scene.figure.panels[0].curves.size(), 1U);
}

TEST(Choices, EachWordOfEverySceneSetsAnEnumeratorOfItsOwn) {
    for (const ModelEntry& entry : models()) {
        Scene scene = scene_with_all_keys(std::string(entry.name));
        const KeyTable table = scene_keys(scene);
        for (const Key& key : table.keys()) {
            const auto* choice = std::get_if<ChoiceTarget>(&key.target);
            if (choice == nullptr) continue;
            for (const KeyWord& known : choice->words) {
                EXPECT_TRUE(choice->choose(known.word));
                EXPECT_EQ(choice->word(), known.word) << key.path;
            }
        }
    }
}

}  // namespace
}  // namespace fumon
