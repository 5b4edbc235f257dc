#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <optional>

#include "base/error.h"
#include "base/tell.h"
#include "cli/command.h"
#include "cli/scene_argument.h"
#include "cli/shared_options.h"
#include "film/film_read.h"
#include "film/timeline.h"
#include "paper/figure_plan.h"
#include "run/prepared_run.h"
#include "scene/read.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

struct CheckOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> settings;
};

void declare(CLI::App& command, CheckOptions& options) {
    command.add_option("SCENE", options.scenes, "scene files, and film files")->required();
    add_settings(command, options.settings, "override a scene key");
}

/// What is said of a fine film; nothing of what is no film.
std::optional<std::string> checked_film(const std::string& file,
                                        const std::vector<std::string>& settings) {
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file, fault)) return std::nullopt;
    const SceneText text = read_scene_text(file);
    if (!is_film(text.text, text.source)) return std::nullopt;
    const Timeline timeline(parse_film(text.text, text.source, settings));
    return fmt::format("{}: fine (a film of {} frames, {:.4g} s)\n", file, timeline.frames(),
                       static_cast<double>(timeline.frames()) / timeline.rate());
}

int perform(const CheckOptions& options) {
    int status = 0;
    FigureRuns runs;
    for (const std::string& given : options.scenes) {
        try {
            const std::string file = scene_argument(given);
            if (const auto film = checked_film(file, options.settings)) {
                std::fputs(film->c_str(), stdout);
                continue;
            }
            const PreparedRun prepared = prepare_run(read_scene(file, options.settings), 1);
            if (!prepared.scene.figure.panels.empty()) {
                FigureSources sources;
                plan_figure(file, options.settings, sources, runs, nullptr);
            }
            const std::string line = fmt::format(
                "{}: fine ({}, {} x {} cells, {} steps, {} frames)\n", file,
                prepared.scene.model.name, prepared.initial.bed.nx(), prepared.initial.bed.ny(),
                prepared.scene.run.steps, frame_schedule(prepared.scene).count());
            std::fputs(line.c_str(), stdout);
        } catch (const InputError& fault) {
            std::fflush(stdout);
            tell(std::string(fault.what()) + "\n");
            status = fault.exit_status();
        }
    }
    return status;
}

}  // namespace

Command check_command() {
    return make_command<CheckOptions>(
        "check", "check scenes and films, and say where they are wrong", declare, perform);
}

}  // namespace fumon
