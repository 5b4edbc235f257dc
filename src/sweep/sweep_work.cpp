#include "sweep/sweep_work.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/stopwatch.h"
#include "models/shared/state_hash.h"
#include "run/picture_text.h"
#include "run/prepared_run.h"
#include "run/recorder.h"
#include "run/simulate.h"

namespace fumon {

namespace {

/// One run from its scene to its files.
Attempt do_run(const SweepPlan& plan, const SweepFolder& folder, const RunTask& task,
               const SweepRun& run, int threads, RunRecord& record,
               std::atomic<double>& cell_steps) {
    const Stopwatch watch;
    PreparedRun prepared = prepare_run(scene_of(plan, run), threads);
    if (run_id(prepared.scene, prepared.initial) != run.id)
        throw Error("a file that it reads has changed since the sweep began");
    Recorder recorder(
        prepared.scene, prepared.model->snapshot(),
        {folder.paths(task.number), resolved_scene(prepared.scene, prepared.initial.inputs)});
    if (!simulate(prepared, recorder, record, cell_steps)) return Attempt::interrupted;
    record.state = hex(state_hash(*prepared.model));
    record.wall_seconds = watch.seconds();
    folder.write_record(task.number, record);
    return Attempt::done;
}

}  // namespace

std::vector<RunTask> sweep_tasks(const SweepPlan& plan, const SweepFolder& folder,
                                 const std::vector<RunRecord>& records) {
    std::vector<RunTask> tasks;
    for (std::size_t number = 1; number <= records.size(); ++number) {
        if (records[number - 1].status == RunStatus::done) continue;
        const SweepRun& run = plan.runs[folder.order()[number - 1]];
        RunTask task{
            number, fmt::format("run {} ({})", number, run_label(plan, run)), run.work, {}};
        task.body = [&plan, &folder, task, &run](int threads, RunRecord& record,
                                                 std::atomic<double>& cell_steps) {
            return do_run(plan, folder, task, run, threads, record, cell_steps);
        };
        tasks.push_back(std::move(task));
    }
    return tasks;
}

}  // namespace fumon
