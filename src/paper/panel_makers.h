#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/worker_pool.h"
#include "figure/canvas/panel.h"
#include "figure/panels/colour_bar.h"
#include "gl/context.h"
#include "paper/figure_plan.h"
#include "scene/figure/panel_kinds.h"

namespace fumon {

/// Data behind something that a figure shows.
struct FigureData {
    std::string name;  ///< the end of its file's name: "a-1.csv"
    std::string text;
};

/// The colours of a panel, which may be shared with others; they live as long as its content.
struct PanelColours {
    using Values = std::optional<std::pair<double, double>>;
    ColourScale* colours = nullptr;  ///< null: it has none, or shares none
    BarPosition* bar = nullptr;
    Values values{};  ///< the least and the greatest shown
};

/// The axes of a panel, which neighbours may share; they live as long as its content.
struct PanelAxes {
    bool* x = nullptr;  ///< whether its numbers show; null: it shares none
    bool* y = nullptr;
    std::string x_range{};  ///< what says that two axes are the same
    std::string y_range{};
};

/// A panel ready to be placed on its page.
struct MadePanel {
    std::unique_ptr<const PanelContent> content;
    std::string title;
    std::vector<std::string> remarks;   ///< for the caption: ranges, intervals, exaggeration
    std::vector<std::string> warnings;  ///< what the user should hear
    PanelColours
        shared{};      ///< where the panel shares its colours; then no remark tells their range
    PanelAxes axes{};  ///< where the panel shares its axes
    std::vector<FigureData> data;  ///< named by what follows the panel's letter: ".asc", "-1.csv"
};

/// What 3-D views are drawn with.
struct FigureDrawing {
    gl::Backend backend = gl::Backend::automatic;
    int threads = 0;  ///< of the renderer's own loops; 0: one per processor
};

/// What the panels of one figure share while they are made, on one thread.
struct PanelTools {
    const FigurePlan& plan;
    const FigureRuns& runs;
    const RunStore& store;
    gl::Backend backend;
    WorkerPool pool;
    std::unique_ptr<gl::Context> context;  ///< of all 3-D views; made by the first one
};

/// A panel of the plan and the fields of its run; no fields where it shows curves.
struct PanelSubject {
    const PanelPlan& panel;
    const Snapshot& first;                   ///< of the run
    const std::vector<Snapshot>& snapshots;  ///< at panel.picture->steps
    double width = 0.0;                      ///< the room for a frame on the page, points
};

/// How panels of one kind are made.
struct PanelMaker {
    /// Throws KeyError, whose key is one of the panel ("section"), where a scene whose run starts
    /// with `first` cannot have it. Null: every scene can.
    void (*check)(const PanelSettings& settings, const Scene& scene, const Snapshot& first);
    /// The panels that panels_of() counts, without their titles. Throws InputError where the look
    /// does not fit the bed or no row is left for a curve, Error where a fit or OpenGL fails.
    std::vector<MadePanel> (*make)(const PanelSubject& subject, PanelTools& tools);
};

/// One for each line of FUMON_PANEL_KINDS (scene/figure/panel_kinds.h), each in a file of its own:
/// panels::map in draw_maps.cpp.
namespace panels {
#define FUMON_MAKER(name, word, shows, help) extern const PanelMaker name;
FUMON_PANEL_KINDS(FUMON_MAKER)
#undef FUMON_MAKER
}  // namespace panels

inline const PanelMaker& maker_of(PanelKind kind) {
#define FUMON_MAKER(name, word, shows, help) &panels::name,
    static constexpr std::array makers{FUMON_PANEL_KINDS(FUMON_MAKER)};
#undef FUMON_MAKER
    return *makers.at(static_cast<std::size_t>(kind));
}

}  // namespace fumon
