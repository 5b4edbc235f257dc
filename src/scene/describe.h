#pragma once

#include <string>
#include <vector>

#include "keys/describe_key.h"

namespace fumon {

/// Keys as a text to read: of every scene ("scene"), of a topic ("figure", "overlay"), of one model
/// (its name), of a section ("camera"), one key ("camera.azimuth", "overlay.corner"), or all ("all"
/// or ""). Throws InputError for another name, with the nearest known one.
std::string describe_text(const std::string& what);

/// The same as JSON: a list of what key_json() tells, with the model or null.
std::string describe_json(const std::string& what);

/// One page: the sections with the names of their keys, the models, and what to ask further.
std::string describe_summary();

/// Every name that describe_text takes.
std::vector<std::string> described_names();

/// The keys that a scene of a model may have, with the words that they take; of all models where
/// `model` is empty.
std::vector<KeyWords> scene_key_words(const std::string& model);

/// One line a model: name and what it is.
std::string models_text();

/// The same as JSON: a list of {name, help}.
std::string models_json();

}  // namespace fumon
