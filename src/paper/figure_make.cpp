#include "paper/figure_make.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>

#include "run/terminal/interrupt.h"

namespace fumon {

std::vector<RunRecord> make_runs(const FigureRuns& runs, const RunStore& store,
                                 const WorkOptions& work, StatusLine& status) {
    std::vector<RunRecord> records(runs.all().size());
    std::vector<RunTask> tasks;
    for (std::size_t k = 0; k < records.size(); ++k) {
        const StoredRun& run = runs[k];
        if (store.holds(run)) {
            store.clear_leftovers(run);
            records[k].status = RunStatus::done;
            continue;
        }
        RunTask task{k + 1, run.label, run.work, {}};
        task.body = [&store, &run](int threads, RunRecord& record,
                                   std::atomic<double>& cell_steps) {
            return store.make(run, threads, record, cell_steps);
        };
        tasks.push_back(std::move(task));
    }
    if (!tasks.empty() && tasks.size() < records.size()) {
        status.note(fmt::format("{} of {} runs were there already", records.size() - tasks.size(),
                                records.size()));
    }
    std::stable_sort(tasks.begin(), tasks.end(),
                     [](const RunTask& a, const RunTask& b) { return a.work > b.work; });
    do_runs(tasks, work.threads, status, records);
    return records;
}

std::string missing_run(const FigurePlan& plan, const FigureRuns& runs,
                        const std::vector<RunRecord>& records) {
    for (const std::size_t run : runs_of(plan)) {
        if (records[run].status != RunStatus::done)
            return fmt::format("{}: is not made, since its run {} failed", plan.file,
                               runs[run].label);
    }
    return {};
}

int report_interrupted(StatusLine& status, const std::vector<RunRecord>& records) {
    const auto done = std::count_if(records.begin(), records.end(), [](const RunRecord& record) {
        return record.status == RunStatus::done;
    });
    status.note(
        fmt::format("stopped by {}: {} of {} runs are done; the same command continues from here",
                    interrupting_signal() == SIGINT ? "an interrupt" : "a request to terminate",
                    done, records.size()));
    return exit_status_of_signal(interrupting_signal());
}

}  // namespace fumon
