#include "sweep/sweep_work.h"

#include <fmt/format.h>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "files/file_lock.h"
#include "models/shared/state_hash.h"
#include "run/manifest.h"
#include "run/picture_text.h"
#include "run/prepared_run.h"
#include "run/recorder.h"
#include "run/simulate.h"

namespace fumon {

namespace {

/// One run from its scene to its files.
Attempt do_run(const SweepPlan& plan, const SweepFolder& folder, std::size_t number,
               const SweepRun& run, int threads, RunRecord& record,
               std::atomic<double>& cell_steps) {
    const Stopwatch watch;
    PreparedRun prepared = prepare_run(scene_of(plan, run), threads);
    if (run_id(prepared.scene, prepared.initial) != run.id)
        throw Error("one of its input files has changed since the sweep began");
    Recorder recorder(prepared.scene, prepared.model->snapshot(),
                      {folder.paths(number),
                       resolved_scene(prepared.scene, prepared.initial.inputs), false, threads});
    if (!simulate(prepared, recorder, record, cell_steps)) return Attempt::interrupted;
    record.state = hex(state_hash(*prepared.model));
    record.wall_seconds = watch.seconds();
    record.status = RunStatus::done;
    folder.write_record(number, record);
    return Attempt::done;
}

/// Keeps why a run failed for whoever merges, if that can still be written.
void keep_failure(const SweepFolder& folder, std::size_t number, RunRecord record, double seconds) {
    record.status = RunStatus::failed;
    record.wall_seconds = seconds;
    record.state.clear();
    record.message = one_line(error_text(std::current_exception()));
    try {
        folder.write_record(number, record);
    } catch (const std::exception&) {
        return;  // the run's own fault is what is told
    }
}

/// The same, unless another program makes it or has made it.
Attempt try_run(const SweepPlan& plan, const SweepFolder& folder, std::size_t number,
                const SweepRun& run, int threads, RunRecord& record,
                std::atomic<double>& cell_steps) {
    const Stopwatch watch;
    const FileLock lock(folder.run_lock(number));
    if (!lock.held()) return Attempt::busy;
    if (RunRecord there = folder.read_record(number); there.status == RunStatus::done) {
        record = std::move(there);
        return Attempt::done;
    }
    try {
        return do_run(plan, folder, number, run, threads, record, cell_steps);
    } catch (const Cancelled&) {
        throw;
    } catch (...) {
        keep_failure(folder, number, record, watch.seconds());
        throw;
    }
}

}  // namespace

std::vector<RunTask> sweep_tasks(const SweepPlan& plan, const SweepFolder& folder,
                                 const std::vector<std::size_t>& numbers,
                                 const std::vector<RunRecord>& records) {
    std::vector<RunTask> tasks;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (records[k].status == RunStatus::done) continue;
        const std::size_t number = numbers[k];
        const SweepRun& run = plan.runs[folder.order()[number - 1]];
        RunTask task{k + 1, fmt::format("run {} ({})", number, run_label(plan, run)), run.work, {}};
        task.body = [&plan, &folder, number, &run](int threads, RunRecord& record,
                                                   std::atomic<double>& cell_steps) {
            return try_run(plan, folder, number, run, threads, record, cell_steps);
        };
        tasks.push_back(std::move(task));
    }
    return tasks;
}

}  // namespace fumon
