#pragma once

#include <array>
#include <cstddef>

#include "scene/figure/kind_line.h"

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
#define FUMON_OVERLAY_KINDS(KIND)                                                          \
    KIND(title, "title", nothing, "the scene's title")                                     \
    KIND(time, "time", nothing, "time and step, with unit")                                \
    KIND(scale_bar, "scale-bar", nothing, "a round length")                                \
    KIND(arrow, "arrow", nothing, "the wind's direction, or the water's, with north")      \
    KIND(colour_bar, "colour-bar", nothing, "quantity shown by the colours")               \
    KIND(parameters, "parameters", keys, "a line of keys and their values")                \
    KIND(plot, "plot", measurements, "a measurement over time, up to the frame")           \
    KIND(inset_map, "inset-map", nothing,                                                  \
         "a small map of the bed, with where the camera stands and what it sees")          \
    KIND(coordinates, "coordinates", nothing,                                              \
         "coordinates of the terrain's file along a map's frame or a block's lower edges") \
    KIND(legend, "legend", nothing, "the layers with a legend, each with its sign")

#define FUMON_ENUMERATOR(name, word, shows, help) name,
enum class OverlayKind { FUMON_OVERLAY_KINDS(FUMON_ENUMERATOR) };
#undef FUMON_ENUMERATOR

#define FUMON_LINE(name, word, shows, help) \
    KindLine<OverlayKind, OverlayShows>{{OverlayKind::name, word, help}, OverlayShows::shows},
inline constexpr std::array overlay_kinds{FUMON_OVERLAY_KINDS(FUMON_LINE)};
#undef FUMON_LINE

constexpr OverlayShows shown_by(OverlayKind kind) {
    return overlay_kinds[static_cast<std::size_t>(kind)].shows;
}

}  // namespace fumon
