#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "keys/keys.h"

namespace fumon {

/// What a kind of overlay shows besides the frame.
enum class OverlayShows {
    nothing,
    keys,          ///< the values of overlay.keys
    measurements,  ///< the columns overlay.x and overlay.y
};

/// The kinds of overlays, a line each: KIND(name, word in a scene, what it shows, help). An overlay
/// of a kind is made by make_name_overlay, defined in figure/overlays; without one, fumon does not
/// link (see figure/overlays/overlay.h).
#define FUMON_OVERLAY_KINDS(KIND)                                                     \
    KIND(title, "title", nothing, "the scene's title")                                \
    KIND(time, "time", nothing, "time and step, with unit")                           \
    KIND(scale_bar, "scale-bar", nothing, "a round length")                           \
    KIND(arrow, "arrow", nothing, "the wind's direction, or the water's, with north") \
    KIND(colour_bar, "colour-bar", nothing, "what the colours mean")                  \
    KIND(parameters, "parameters", keys, "a line of keys and their values")           \
    KIND(plot, "plot", measurements, "a measurement over time, up to the frame")

#define FUMON_ENUMERATOR(name, word, shows, help) name,
enum class OverlayKind { FUMON_OVERLAY_KINDS(FUMON_ENUMERATOR) };
#undef FUMON_ENUMERATOR

constexpr OverlayShows shown_by(OverlayKind kind) {
#define FUMON_SHOWS(name, word, shows, help) OverlayShows::shows,
    constexpr std::array shows{FUMON_OVERLAY_KINDS(FUMON_SHOWS)};
#undef FUMON_SHOWS
    return shows[static_cast<std::size_t>(kind)];
}

/// The words of the kinds, in their order.
inline std::vector<ChoiceName> overlay_kind_words() {
#define FUMON_WORD(name, word, shows, help) {word, help},
    return {FUMON_OVERLAY_KINDS(FUMON_WORD)};
#undef FUMON_WORD
}

}  // namespace fumon
