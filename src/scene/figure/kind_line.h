#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "keys/keys.h"

namespace fumon {

/// A line of a list of kinds: the kind with its word and help, and what it shows.
template <class Kind, class Shows>
struct KindLine {
    Choice<Kind> choice;
    Shows shows;
};

/// The kinds as a key offers them.
template <class Kind, class Shows, std::size_t count>
std::vector<Choice<Kind>> choices_of(const std::array<KindLine<Kind, Shows>, count>& kinds) {
    std::vector<Choice<Kind>> choices;
    choices.reserve(count);
    for (const KindLine<Kind, Shows>& kind : kinds) choices.push_back(kind.choice);
    return choices;
}

}  // namespace fumon
