#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "keys/keys.h"

namespace fumon {

/// A line of a list of kinds: its word in a scene with its help, and what the kind shows.
template <class Shows>
struct KindLine {
    ChoiceName choice;
    Shows shows;
};

/// The words of the kinds, in their order.
template <class Shows, std::size_t count>
std::vector<ChoiceName> words_of(const std::array<KindLine<Shows>, count>& kinds) {
    std::vector<ChoiceName> words;
    for (const KindLine<Shows>& kind : kinds) words.push_back(kind.choice);
    return words;
}

}  // namespace fumon
