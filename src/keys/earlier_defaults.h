#pragma once

#include <string_view>

#include "keys/keys.h"

namespace fumon {

/// Whether version `one` ("1.2.3") came before `other`. False where one of them is no version, as
/// the empty text, which stands for this fumon's.
bool is_earlier_version(std::string_view one, std::string_view other);

/// Gives every key whose default has changed since `version` the default that it had then, so that
/// a scene kept by that version means what it meant. The table's keys have their defaults before.
void take_earlier_defaults(const KeyTable& table, std::string_view version);

/// Gives a key that its scene was kept without, since fumon did not have it yet, what its absence
/// meant then, where the key has such an earlier default.
void take_default_of_absence(const Key& key);

}  // namespace fumon
