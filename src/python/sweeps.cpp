#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <future>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/cancellation.h"
#include "files/csv_table.h"
#include "files/input_file.h"
#include "measure/suite.h"
#include "python/module.h"
#include "python/scene_value.h"
#include "python/signal_polling.h"
#include "run/prepared_run.h"
#include "run/terminal/interrupt.h"
#include "scene/uses_metres.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_work.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

/// A sweep and what came of it.
struct DoneSweep {
    SweepPlan plan;
    std::vector<RunRecord> records;   ///< of plan.runs, in their order
    std::vector<Table> measurements;  ///< likewise; empty where a run left none
    std::map<std::string, MeasureColumn> columns;
};

/// How far a sweep is, for another thread to see.
struct Count {
    std::atomic<std::size_t> done{0};
    std::atomic<std::size_t> all{0};
};

/// Counts a run whichever way it ends.
void count_in(RunTask& task, Count& count) {
    task.body = [body = std::move(task.body), &count](int threads, RunRecord& record,
                                                      std::atomic<double>& cell_steps) {
        struct AtEnd {
            Count& count;
            ~AtEnd() { ++count.done; }
        } const at_end{count};
        return body(threads, record, cell_steps);
    };
}

/// What the columns of the runs' tables mean: a run is made ready for each that is not known yet.
void explain_columns(DoneSweep& sweep) {
    for (std::size_t n = 0; n < sweep.measurements.size(); ++n) {
        const auto& columns = sweep.measurements[n].columns;
        const bool known = std::ranges::all_of(columns, [&](const TableColumn& column) {
            return column.name == "step" || column.name == "time" ||
                   sweep.columns.contains(column.name);
        });
        if (known) continue;
        const PreparedRun run = prepare_run(scene_of(sweep.plan, sweep.plan.runs[n]), 1);
        const Snapshot first = run.model->snapshot();
        sweep.columns.emplace("time", MeasureColumn{"time", first.time_unit, "time of the model"});
        const MeasureSuite suite(measured_landform(first), first,
                                 {run.scene.output.channel_area, uses_metres(run.scene)});
        for (const MeasureColumn& column : suite.columns())
            sweep.columns.emplace(column.name, column);
    }
}

/// Makes the runs as `fumon sweep` makes them. Nothing where it was interrupted.
std::optional<DoneSweep> make_sweep(const SweepRequest& request, const std::string& folder_name,
                                    int threads, Count& count) {
    auto plan = make_plan(request);
    if (!plan) return std::nullopt;
    DoneSweep sweep{std::move(*plan), {}, {}, {}};
    const SweepFolder folder(folder_name, sweep.plan, false);
    std::vector<std::size_t> numbers(sweep.plan.runs.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{1});
    std::vector<RunRecord> records;
    records.reserve(numbers.size());
    for (const std::size_t number : numbers) {
        records.push_back(folder.read_record(number));
        if (records.back().status == RunStatus::failed) records.back() = {};  // tried again
    }
    count.all = records.size();
    std::vector<RunTask> tasks = sweep_tasks(sweep.plan, folder, numbers, records);
    count.done = records.size() - tasks.size();
    for (RunTask& task : tasks) count_in(task, count);
    folder.write_runs(records);
    StatusLine quiet(Verbosity::quiet);
    do_runs(tasks, threads, quiet, records);
    folder.write_runs(records);
    folder.write_table(records);
    if (interrupting_signal() != 0) return std::nullopt;
    sweep.records.resize(records.size());
    sweep.measurements.resize(records.size());
    for (std::size_t number = 1; number <= records.size(); ++number) {
        const std::size_t n = folder.order()[number - 1];
        sweep.records[n] = records[number - 1];
        if (records[number - 1].status != RunStatus::done) continue;
        const std::string file = folder.paths(number).measurements.string();
        const std::string text = read_input_file(file);
        sweep.measurements[n] = parse_csv_table({file, text});
    }
    explain_columns(sweep);
    return sweep;
}

/// The same on another thread, while Python hears its signals and is told how far it is.
DoneSweep wait_for_sweep(const SweepRequest& request, const std::string& folder, int threads,
                         const py::object& report) {
    Count count;
    const py::gil_scoped_release unlocked;
    std::future<std::optional<DoneSweep>> future =
        std::async(std::launch::async, [&] { return make_sweep(request, folder, threads, count); });
    try {
        while (future.wait_for(signal_poll_interval) != std::future_status::ready) {
            check_signals();
            const py::gil_scoped_acquire locked;
            if (!report.is_none() && count.all > 0) report(count.done.load(), count.all.load());
        }
    } catch (...) {
        request_stop(SIGINT);
        future.wait();
        clear_interrupt();
        throw;
    }
    auto sweep = future.get();
    if (!sweep) throw Cancelled();
    return std::move(*sweep);
}

py::dict run_of(const DoneSweep& sweep, std::size_t n) {
    const RunRecord& record = sweep.records[n];
    py::dict run;
    run["combination"] = sweep.plan.runs[n].combination;
    run["seed"] = sweep.plan.runs[n].seed;
    run["done"] = record.status == RunStatus::done;
    run["message"] = record.message;
    run["state"] = record.state;
    py::dict columns;
    for (const TableColumn& column : sweep.measurements[n].columns)
        columns[py::str(column.name)] = py::array_t<double>(
            static_cast<py::ssize_t>(column.values.size()), column.values.data());
    run["columns"] = columns;
    return run;
}

/// {"axes": [how many values each has], "runs": [run_of …], "columns": {name: (unit, help)}}.
py::dict python_sweep(const SceneValue& scene, const std::vector<std::string>& over,
                      const std::string& seeds, const std::string& folder, int threads,
                      const py::object& report) {
    const SweepRequest request{scene.text(), scene.overrides(), over, "", seeds};
    const DoneSweep sweep = wait_for_sweep(request, folder, threads, report);
    py::dict result;
    py::list axes;
    for (const SweepAxis& axis : sweep.plan.axes) {
        py::list values;
        for (const Override& value : axis.values) values.append(plain_text(value));
        axes.append(py::make_tuple(axis.keys, values));
    }
    result["axes"] = axes;
    py::list runs;
    for (std::size_t n = 0; n < sweep.plan.runs.size(); ++n) runs.append(run_of(sweep, n));
    result["runs"] = runs;
    py::dict columns;
    for (const auto& [name, column] : sweep.columns)
        columns[py::str(name)] = py::make_tuple(column.unit, column.help);
    result["columns"] = columns;
    return result;
}

}  // namespace

void define_sweeps(py::module_& core) {
    core.def("sweep", &python_sweep, py::arg("scene"), py::arg("over"), py::arg("seeds"),
             py::arg("folder"), py::arg("threads"), py::arg("tell"));
}

}  // namespace fumon::python
