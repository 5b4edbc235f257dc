#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "keys/keys.h"

namespace fumon {

/// What there is to know of a key, as lines to read: path, type, unit, range, default (its present
/// value), role, help and words. Numbers of items in its path read "N".
std::string describe_key(const Key& key);

/// The same as JSON: {key, type, unit, default, required, minimum, minimum_excluded, maximum,
/// values, role, help}, those that the key has.
nlohmann::ordered_json key_json(const Key& key);

/// A key and the words that it takes, for what completes them: those of a choice, true and false.
struct KeyWords {
    std::string path;  ///< numbers of items as in the key's own: "overlay.0.corner"
    std::string help;
    std::vector<std::string> words;
};
KeyWords key_words(const Key& key);

/// What each role means, a line each.
std::string describe_roles();

}  // namespace fumon
