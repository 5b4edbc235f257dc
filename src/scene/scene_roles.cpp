#include "scene/scene_roles.h"

#include <algorithm>

#include "keys/key_value.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

bool among(KeyRole role, std::span<const KeyRole> roles) {
    return std::find(roles.begin(), roles.end(), role) != roles.end();
}

}  // namespace

Scene only_roles(Scene scene, std::span<const KeyRole> kept) {
    const KeyTable full = scene_keys(scene);
    for (auto list = full.lists().rbegin(); list != full.lists().rend(); ++list) {
        if (!among(list->role, kept)) list->resize(0);  // lists within its items come before it
    }
    Scene usual = default_scene(scene.model.name);
    const KeyTable defaults = scene_keys(usual);
    const KeyTable table = scene_keys(scene);
    for (const Key& key : table.keys()) {
        if (!among(key.role, kept)) copy_value(*defaults.find(key.path), key);
    }
    return scene;
}

}  // namespace fumon
