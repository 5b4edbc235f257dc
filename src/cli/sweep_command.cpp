#include <fmt/format.h>

#include <algorithm>
#include <csignal>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/commands.h"
#include "run/terminal/interrupt.h"
#include "run/terminal/progress.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_plan.h"
#include "sweep/sweep_work.h"

namespace fumon {

namespace {

std::size_t count(const std::vector<RunRecord>& records, RunStatus status) {
    return static_cast<std::size_t>(
        std::count_if(records.begin(), records.end(),
                      [&](const RunRecord& record) { return record.status == status; }));
}

std::string of_runs(std::size_t count, std::size_t all) {
    return fmt::format("{} of {} runs", with_commas(static_cast<std::int64_t>(count)),
                       with_commas(static_cast<std::int64_t>(all)));
}

}  // namespace

int sweep_command(const SweepOptions& options) {
    const InterruptGuard guard;
    StatusLine status(options.work.verbosity);
    const auto plan =
        make_plan({read_scene_text(options.scene), read_settings(options.work.settings),
                   options.over, "", options.seeds});
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

}  // namespace fumon
