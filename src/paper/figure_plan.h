#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "figure/words/words.h"
#include "files/csv_table.h"
#include "paper/store/figure_runs.h"
#include "paper/store/figure_sources.h"
#include "scene/scene.h"
#include "sweep/sweep_plan.h"

namespace fumon {

/// The settings of a curve and the runs or the table that it is drawn from.
struct CurvePlan {
    CurveSettings settings;
    std::string path;                ///< of its keys: "figure.panel.0.curve.1"
    std::optional<SweepPlan> sweep;  ///< none where it is drawn from a file or a formula
    std::vector<std::size_t> runs;   ///< among the figures' runs, in the order of sweep->runs
    Scene scene;                     ///< of the first run, made ready
    std::int64_t step = 0;           ///< of profile, section and flights
    Table table;  ///< of a file: its rows; else the columns alone, with their units
};

/// What a picture shows: steps of a run.
struct PicturePlan {
    Scene scene;  ///< made ready
    std::size_t run = 0;
    std::vector<std::int64_t> steps;  ///< in the order in which they are shown
};

struct PanelPlan {
    PanelSettings settings;
    std::string path;  ///< of its keys: "figure.panel.0"
    std::vector<CurvePlan> curves;
    std::optional<PicturePlan> picture;
    std::optional<PicturePlan> minus;  ///< of a difference: what is taken away, one step or as many
};

/// A figure with all that it is made from.
struct FigurePlan {
    std::string name;  ///< of its files, without their ends
    std::string file;  ///< the scene's
    Scene scene;
    std::shared_ptr<const WordTable> words{};  ///< in which it is written; null: English
    std::vector<std::string> settings;         ///< of --set
    std::vector<PanelPlan> panels;
    std::vector<InputFile> inputs;   ///< terrain files, and figure.icc_profile
    std::string cmyk_profile;        ///< the bytes of figure.icc_profile
    std::vector<std::string> notes;  ///< what the user should hear before the start
};

/// Reads a figure's scene and the other scenes and tables that it names, builds the bed and model
/// of every combination once, and adds the runs that it needs to `runs`. Of runs that `store` holds
/// (nullptr: there is none) no model is built. `settings` are of --set and change the figure's
/// scene. Throws InputError, located, for the first fault that can be known
/// before any run: also unknown columns, fields, steps and placeholders. Nothing when interrupted.
std::optional<FigurePlan> plan_figure(const std::string& file,
                                      const std::vector<std::string>& settings,
                                      FigureSources& sources, FigureRuns& runs,
                                      const RunStore* store);

/// The numbers of all runs that a figure needs.
std::vector<std::size_t> runs_of(const FigurePlan& plan);

/// How many panels of the page it takes: one for each of its steps, or one alone.
std::size_t panels_of(const PanelPlan& panel);

}  // namespace fumon
