#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace fumon {

/// What a name in braces stands for; nothing where it is not known.
using PlaceholderValues = std::function<std::optional<std::string>(const std::string& name)>;

/// A text with every {name} replaced by its value; "{{" and "}}" are braces,
/// and ^{…} and _{…} are left as they are, since they raise and lower letters. Throws InputError
/// without a place for an unknown name and a brace without its other one; `hint` says which names
/// are known.
std::string fill_placeholders(
    const std::string& text, const PlaceholderValues& values,
    const std::string& hint = "a key such as {model.creep_rate} has a value");

/// The value of a scene's key as one would write it, texts without their quotes; nothing where
/// there is no such key.
std::optional<std::string> key_text(const Scene& scene, const std::string& key);

}  // namespace fumon
