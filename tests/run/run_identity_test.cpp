#include "run/run_identity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "models/registry.h"
#include "paper/store/run_store.h"
#include "support/changed_key.h"

namespace fumon {
namespace {

using test::change_value;
using test::scene_with_all_keys;

/// The scene with its key of that number changed.
Scene with_another(Scene scene, std::size_t number) {
    const KeyTable table = scene_keys(scene);
    change_value(table.keys()[number]);
    return scene;
}

/// Changes every key of a scene, one after the other: `identity` of the scene must become another
/// one where `decides` says so of the key, and stay the same elsewhere.
template <class Identity, class Decides>
void expect_decided(const Scene& scene, const Identity& identity, const Decides& decides) {
    Scene copy = scene;
    const KeyTable table = scene_keys(copy);
    const Sha256 before = identity(scene);
    for (std::size_t number = 0; number < table.keys().size(); ++number) {
        const Key& key = table.keys()[number];
        const bool another = identity(with_another(scene, number)) != before;
        EXPECT_EQ(another, decides(key)) << scene.model.name << " " << key.path;
    }
}

TEST(RunIdentity, EveryKeyThatDecidesWhatIsRecordedAndNoOtherOneMakesAnotherRun) {
    const auto identity = [](const Scene& scene) { return run_id(scene, {}); };
    const auto decides = [](const Key& key) {
        return key.role != KeyRole::look && key.role != KeyRole::file &&
               key.role != KeyRole::sweep && key.role != KeyRole::figure;
    };
    for (const ModelEntry& entry : models())
        expect_decided(scene_with_all_keys(std::string(entry.name)), identity, decides);
}

TEST(RunIdentity, AStoredRunIsDecidedByWhatItMeasures) {
    const auto identity = [](const Scene& scene) { return stored_run(scene, {}).id; };
    const auto measured = [](const Key& key) {
        return key.role == KeyRole::run || key.role == KeyRole::parameter ||
               key.role == KeyRole::sampling;
    };
    Scene scene = scene_with_all_keys("sand");
    expect_decided(scene, identity, measured);
    scene.output.measure_every = 5;
    expect_decided(scene, identity, [&](const Key& key) {
        return measured(key) && !key.path.starts_with("frames.");
    });
}

TEST(RunIdentity, ABedFileCountsByItsContent) {
    Scene scene = default_scene("static");
    scene.bed.file = "one.asc";
    Scene moved = scene;
    moved.bed.file = "elsewhere/two.asc";
    InitialBed initial;
    initial.inputs = {{"one.asc", "abc"}};
    EXPECT_EQ(run_id(scene, initial), run_id(moved, initial));
    InitialBed other = initial;
    other.inputs[0].hash = "abd";
    EXPECT_NE(run_id(scene, initial), run_id(scene, other));
}

}  // namespace
}  // namespace fumon
