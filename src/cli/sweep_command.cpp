#include <fmt/format.h>

#include <algorithm>
#include <csignal>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/scene_argument.h"
#include "cli/shared_options.h"
#include "run/terminal/interrupt.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_plan.h"
#include "sweep/sweep_work.h"

namespace fumon {

namespace {

struct SweepOptions {
    std::string scene;
    std::vector<std::string> over;  ///< "key=v1,v2" or "key=low:high:count"
    std::string seeds;              ///< "10" or "1:10"
    std::string folder;
    bool force = false;
    WorkOptions work;
};

void declare(CLI::App& command, SweepOptions& options) {
    command.add_option("SCENE", options.scene, "a scene file (TOML)")->required();
    command
        .add_option("--over", options.over,
                    "vary a key: --over key=v1,v2 or key=low:high:count (repeatable: all "
                    "combinations; default: the scene's sweep.over)")
        ->type_name("KEY=VALUES")
        ->allow_extra_args(false);
    command
        .add_option("--seeds", options.seeds,
                    "runs of each combination: how many seeds, from the scene's own on, or "
                    "first:last (default: the scene's sweep.seeds)")
        ->type_name("N");
    command.add_option("-o,--output", options.folder, "the folder for the sweep")
        ->type_name("DIR")
        ->required();
    add_force(command, options.force,
              "replace the sweep that the folder holds, and files of others that are in its way");
    add_work_options(command, options.work);
    command.footer(
        "  fumon sweep SCENE --over model.creep_rate=0.1:0.5:5 --seeds 10 -o out/creep\n"
        "  fumon sweep SCENE --over bed.file=a.asc,b.asc --over run.steps=100,200 -o out/beds\n"
        "  fumon sweep SCENE --over grid.nx+grid.ny=64,128 -o out/sizes    keys that go "
        "together\n\n"
        "DIR/sweep.csv has one row per run and measured step, DIR/runs.csv one row per run, "
        "DIR/runs each run's files.\n"
        "The same command resumes where it was stopped; with more values or seeds it makes only "
        "the new runs.\n"
        "Exit status: 0 done, 1 some runs failed, 2 wrong input, 130/143 interrupted (finished "
        "runs are kept).");
}

std::size_t count(const std::vector<RunRecord>& records, RunStatus status) {
    return static_cast<std::size_t>(
        std::count_if(records.begin(), records.end(),
                      [&](const RunRecord& record) { return record.status == status; }));
}

std::string of_runs(std::size_t count, std::size_t all) {
    return fmt::format("{} of {} runs", with_commas(static_cast<std::int64_t>(count)),
                       with_commas(static_cast<std::int64_t>(all)));
}

int perform(const SweepOptions& options) {
    const InterruptGuard guard;
    StatusLine status(options.work.verbosity);
    const auto plan =
        make_plan({read_scene_text(scene_argument(options.scene)),
                   read_settings(options.work.settings), options.over, "", options.seeds});
    if (!plan) {
        status.note("stopped while the runs were being checked; nothing is written");
        return exit_status_of_signal(interrupting_signal());
    }
    if (plan->axes.empty() && plan->runs.size() == 1 && options.seeds.empty()) {
        throw InputError(
            fmt::format("{}: nothing to vary; give --over key=v1,v2 or --seeds 10", options.scene));
    }
    const SweepFolder folder(options.folder, *plan, options.force);
    for (const std::string& note : plan->notes) status.note(note);

    std::vector<RunRecord> records;
    for (std::size_t number = 1; number <= plan->runs.size(); ++number)
        records.push_back(folder.read_record(number));
    if (const std::size_t kept = count(records, RunStatus::done); kept > 0)
        status.note(of_runs(kept, records.size()) + " were there already");
    folder.write_runs(records);
    do_runs(sweep_tasks(*plan, folder, records), options.work.threads, status, records);
    folder.write_runs(records);
    folder.write_table(records);

    const std::size_t done = count(records, RunStatus::done);
    const std::size_t failed = count(records, RunStatus::failed);
    const int signal = done + failed < records.size() ? interrupting_signal() : 0;
    if (signal != 0) {
        status.note(
            fmt::format("stopped by {}: {} are done and in {}; the same command goes on from here",
                        signal == SIGINT ? "an interrupt" : "a request to terminate",
                        of_runs(done, records.size()), folder.table().string()));
        return exit_status_of_signal(signal);
    }
    status.note(
        fmt::format("{} are done: {}", of_runs(done, records.size()), folder.table().string()));
    if (failed == 0) return 0;
    status.note(fmt::format("{} failed (see runs.csv); the same command tries them again",
                            of_runs(failed, records.size())));
    return 1;
}

}  // namespace

Command sweep_command() {
    return make_command<SweepOptions>(
        "sweep", "run a scene many times, over values and seeds, into one table of measurements",
        declare, perform);
}

}  // namespace fumon
