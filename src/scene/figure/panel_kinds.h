#pragma once

#include <array>
#include <cstddef>

#include "scene/figure/kind_line.h"

namespace fumon {

/// What a kind of panel shows.
enum class PanelShows {
    curves,     ///< tables of numbers; the others show the fields of a run
    each_step,  ///< a step: several steps are several panels
    all_steps,  ///< all its steps in one panel
    whole_run,  ///< a run from start to end in one panel
};

/// The kinds of panels that a figure may have, a line each: KIND(name, word in a scene, what it
/// shows, help). A kind's panels are made by panels::name, defined in a file of src/paper of its
/// own; without one, fumon does not link (see paper/panel_makers.h).
#define FUMON_PANEL_KINDS(KIND)                                                    \
    KIND(plot, "plot", curves, "curves over linear or logarithmic axes")           \
    KIND(map, "map", each_step, "a field from above, with axes and a colour bar")  \
    KIND(view, "view", each_step, "a shaded 3-D view")                             \
    KIND(profile, "profile", all_steps,                                            \
         "height along a row, one above the other for several steps")              \
    KIND(time_space, "time-space", whole_run, "a row's heights over time")         \
    KIND(section, "section", each_step, "the air over a profile")                  \
    KIND(heat_map, "heat-map", curves,                                             \
         "z over x and y as coloured cells, such as the phase diagram of a sweep") \
    KIND(scatter, "scatter", curves, "points coloured by z")                       \
    KIND(histogram, "histogram", curves, "how often values of y come")             \
    KIND(box_plot, "box-plot", curves,                                             \
         "quartiles or densities of the values of y at each x, as of seeds")       \
    KIND(difference, "difference", each_step, "one map minus another, in colours that part at 0")

#define FUMON_ENUMERATOR(name, word, shows, help) name,
enum class PanelKind { FUMON_PANEL_KINDS(FUMON_ENUMERATOR) };
#undef FUMON_ENUMERATOR

#define FUMON_LINE(name, word, shows, help) \
    KindLine<PanelKind, PanelShows>{{PanelKind::name, word, help}, PanelShows::shows},
inline constexpr std::array panel_kinds{FUMON_PANEL_KINDS(FUMON_LINE)};
#undef FUMON_LINE

constexpr PanelShows shown_by(PanelKind kind) {
    return panel_kinds[static_cast<std::size_t>(kind)].shows;
}

}  // namespace fumon
