#include <fmt/format.h>

#include <cstdio>

#include "base/error.h"
#include "base/tell.h"
#include "cli/command.h"
#include "cli/scene_argument.h"
#include "cli/shared_options.h"
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
    command.add_option("SCENE", options.scenes, "scene files")->required();
    add_settings(command, options.settings, "override a scene key");
}

int perform(const CheckOptions& options) {
    int status = 0;
    FigureRuns runs;
    for (const std::string& given : options.scenes) {
        try {
            const std::string file = scene_argument(given);
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
    return make_command<CheckOptions>("check", "check scenes, and say where they are wrong",
                                      declare, perform);
}

}  // namespace fumon
