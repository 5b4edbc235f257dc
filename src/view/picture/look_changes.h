#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/snapshot.h"
#include "scene/scene.h"

namespace fumon {

/// Whether a key decides what a model computes: a key of "model" other than its name.
bool is_model_key(std::string_view path);

/// The scene of a viewer with the keys that its page may change: camera, sun, air, look, section,
/// streamers, image and the overlays that there are. Keys that name files are not among them.
class LookChanges {
  public:
    /// `base` is prepared. Where `trusted` is not set, pictures keep within trust_limits.
    LookChanges(const Scene& base, const Snapshot& first, bool trusted);

    /// The scene with "key.path=VALUE" settings. Throws InputError as read_scene(), placed as
    /// "--set N:column", and for keys that a page may not change.
    [[nodiscard]] Scene with(const std::vector<std::string>& settings) const;

    /// What the page must know of these keys, and of the model's: a list of what key_json() tells,
    /// with "section", and "value" as TOML; the default is that of a scene that says nothing. Keys
    /// of the model are "fixed" for the reason that is given, if any.
    [[nodiscard]] nlohmann::ordered_json keys(const std::string& why_model_is_fixed) const;

    /// The same of the keys that a further overlay has.
    [[nodiscard]] nlohmann::ordered_json keys_of_further_overlay() const;

    /// The looks of assets/looks: a list of {name, settings: {path: value}}, where every look sets
    /// the same keys.
    [[nodiscard]] nlohmann::ordered_json presets() const;

    /// The file of the scene with settings: every key, under a line that says which fumon wrote it.
    [[nodiscard]] std::string scene_file(const std::vector<std::string>& settings) const;

  private:
    Scene base_;
    Snapshot first_;
    bool trusted_;
    std::string text_;  ///< of the base, resolved
};

}  // namespace fumon
