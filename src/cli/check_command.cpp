#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "base/standard_error.h"
#include "base/worker_pool.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "film/beds/film_runs.h"
#include "film/film_read.h"
#include "film/joined_film.h"
#include "film/script/film_looks.h"
#include "film/timeline.h"
#include "paper/figure_plan.h"
#include "run/forecast/run_forecast.h"
#include "run/inputs/scene_argument.h"
#include "run/inputs/standard_input.h"
#include "run/prepared_run.h"
#include "scene/json.h"
#include "scene/read.h"
#include "scene/schedule.h"
#include "scene/wind_tables.h"
#include "wind/drift_json.h"

namespace fumon {

namespace {

struct CheckOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> settings;
    std::vector<std::string> runs;  ///< that a film is checked against
    bool as_json = false;
};

void declare(CLI::App& command, CheckOptions& options) {
    command
        .add_option("SCENE", options.scenes,
                    "scene files, and film files; - is a scene on standard input")
        ->required();
    command
        .add_option("--run", options.runs,
                    "the folder of a run that a film is to be cut from: whether the film fits it")
        ->type_name("RUN")
        ->expected(1)
        ->take_all();
    command.add_flag("--json", options.as_json, "as JSON");
    add_settings(command, options.settings, "override a scene key");
    add_examples(
        command,
        {{"fumon check my.toml", "all faults at once, each with its line"},
         {"fumon check film.toml --run out/run", "a film with the run that it is to show"},
         {"fumon check terada-barchans --set model.creep_rate=0.3", "with a number changed"},
         {"fumon check my.toml film.toml --json", "for a program"}},
        "Exit status: 0 all are fine, 2 something is wrong.");
}

using Json = nlohmann::ordered_json;

/// What is said of a fine scene or film, in words and for a program.
struct Fine {
    std::string words;
    Json facts;
    std::vector<std::string> notes{};  ///< lines for the user
};

/// Of a film; nothing of what is no film.
std::optional<Fine> checked_film(const std::string& file, const std::vector<std::string>& settings,
                                 const std::vector<std::string>& folders) {
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) return std::nullopt;
    const SceneText text = read_scene_text(file);
    if (!is_film(text.text, text.source)) return std::nullopt;
    const Film film = parse_film(text.text, text.source, settings);
    const Timeline timeline(film);
    const double seconds = static_cast<double>(timeline.frames()) / timeline.rate();
    Fine fine{fmt::format("a film of {} frames, {:.4g} s", timeline.frames(), seconds),
              {{"kind", "film"}, {"frames", timeline.frames()}, {"seconds", seconds}}};
    if (folders.empty()) return fine;
    ForeignQuery query;
    query.scalars = coloured_fields(film);
    const FilmRuns runs(folders, 1, arrangement_of(film), query);
    WorkerPool pool(1, "fumon-check");
    // All that a film needs is looked at before its first frame.
    const auto frames = film_frames(
        film, runs,
        {film.settings.title.empty() ? runs.first().scene().title : film.settings.title, ""},
        gl::Backend::automatic, pool);
    fine.words += fmt::format(", which fits {}", fmt::join(folders, ", "));
    fine.facts["runs"] = folders;
    fine.facts["notes"] = frames->notes();
    fine.notes = frames->notes();
    return fine;
}

/// Of standard input.
Scene given_scene(const std::vector<std::string>& settings) {
    const StandardInput input;
    if (!input.is_scene())
        throw InputError("-: standard input is terrain; `fumon check` takes scenes");
    return parse_scene(input.scene(), read_settings(settings));
}

/// Tells what a run of the scene will take, from some of its steps.
void tell_forecast(const PreparedRun& run, Fine& fine) {
    constexpr double most_seconds = 1.5;
    const auto forecast = forecast_run(run, most_seconds);
    if (!forecast) return;
    fine.facts["forecast"] = {{"seconds_of_steps", forecast->seconds},
                              {"threads", forecast->threads},
                              {"most_bytes_of_fields", forecast->fields_bytes},
                              {"most_bytes_of_frames", forecast->frames_bytes}};
    if (const std::string text = forecast_text(*forecast); !text.empty()) fine.words += "; " + text;
}

Fine checked(const std::string& file, const CheckOptions& options, FigureRuns& runs) {
    const std::vector<std::string>& settings = options.settings;
    const bool given = is_standard_input(file);
    if (!given) {
        if (auto film = checked_film(file, settings, options.runs)) return *std::move(film);
        if (!options.runs.empty())
            throw InputError(fmt::format("{}: is not a film; --run is for films", file));
    }
    const PreparedRun prepared =
        prepare_run(given ? given_scene(settings) : read_scene(file, settings), 0);
    const Scene& scene = prepared.scene;
    const bool has_figure = !scene.figure.panels.empty();
    if (has_figure && given)
        throw InputError(
            "-: is a figure's scene; name its file, since its runs are stored beside it");
    if (has_figure) {
        FigureSources sources;
        plan_figure(file, settings, sources, runs, nullptr);
    }
    const auto frames = frame_schedule(scene).count();
    Fine fine{
        fmt::format("{}, {} x {} cells, {} steps, {} frames", scene.model.name,
                    prepared.initial.bed.nx(), prepared.initial.bed.ny(), scene.run.steps, frames),
        {{"kind", has_figure ? "figure" : "scene"},
         {"model", scene.model.name},
         {"nx", prepared.initial.bed.nx()},
         {"ny", prepared.initial.bed.ny()},
         {"steps", scene.run.steps},
         {"frames", frames}}};
    const Snapshot first = prepared.model->snapshot();
    if (!first.winds.empty()) {
        fine.words += "; " + winds_line(first);
        fine.facts["drift"] = drift_json(first.winds);
    }
    if (!has_figure) tell_forecast(prepared, fine);
    return fine;
}

int perform(const CheckOptions& options) {
    int status = 0;
    FigureRuns runs;
    Json all = Json::array();
    for (const std::string& given : options.scenes) {
        Json one{{"file", given}};
        try {
            const std::string file = is_standard_input(given) ? given
                                     : options.runs.empty()   ? scene_argument(given)
                                                              : film_file(given).string();
            one["file"] = file;
            const Fine fine = checked(file, options, runs);
            one["fine"] = true;
            one.update(fine.facts);
            if (!options.as_json && !makes_no_remarks()) {
                fmt::print("{}: fine ({})\n", file, fine.words);
                for (const std::string& note : fine.notes) fmt::print("{}: {}\n", file, note);
            }
        } catch (const InputError& fault) {
            one["fine"] = false;
            one["faults"] = fault.lines();
            status = fault.exit_status();
            std::fflush(stdout);
            if (!options.as_json) print_to_stderr(std::string(fault.what()) + "\n");
        }
        all.push_back(std::move(one));
    }
    if (options.as_json) std::fputs((json_text(all, 2) + "\n").c_str(), stdout);
    return status;
}

}  // namespace

Command check_command() {
    return make_command<CheckOptions>(
        "check", "check scenes and films, and say where they are wrong", declare, perform);
}

}  // namespace fumon
