#include <fmt/format.h>

#include <cstdio>

#include "base/error.h"
#include "base/tell.h"
#include "cli/commands.h"
#include "paper/figure_plan.h"
#include "run/prepared_run.h"
#include "scene/read.h"
#include "scene/schedule.h"

namespace fumon {

int check_command(const std::vector<std::string>& scenes,
                  const std::vector<std::string>& settings) {
    int status = 0;
    FigureRuns runs;
    for (const std::string& file : scenes) {
        try {
            const PreparedRun prepared = prepare_run(read_scene(file, settings), 1);
            if (!prepared.scene.figure.panels.empty()) {
                FigureSources sources;
                plan_figure(file, settings, sources, runs, nullptr);
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

}  // namespace fumon
