#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "base/number_text.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "run/drawing.h"
#include "run/inputs/scene_argument.h"
#include "run/terminal/interrupt.h"
#include "shards/shard.h"
#include "shards/slurm_script.h"
#include "sweep/merge_shards.h"
#include "sweep/sweep_folder.h"
#include "sweep/sweep_plan.h"
#include "sweep/sweep_work.h"
#include "view/sweep/sweep_pages.h"
#include "view/watch/job_server.h"

namespace fumon {

namespace {

struct SweepOptions {
    std::string scene;
    std::vector<std::string> over;  ///< "key=v1,v2" or "key=low:high:count"
    std::string seeds;              ///< "10" or "1:10"
    std::string folder;
    bool force = false;
    ShardOptions shards;
    std::vector<std::string> from;  ///< folders of shards, to be merged
    WatchOptions watch;
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
    auto* force = add_force(
        command, options.force,
        "replace the sweep that the folder holds, and files of others that are in its way");
    add_shard_options(command, options.shards,
                      "write the tables from what the shards have made, and name those missing");
    command.get_option("--shard")->excludes(force);
    command
        .add_option("--from", options.from,
                    "with --merge: the folder of a shard that wrote into its own (repeatable)")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->needs(command.get_option("--merge")->excludes(force));
    add_watch_options(command, options.watch);
    add_work_options(command, options.work);
    add_examples(
        command,
        {{"fumon sweep terada-barchans --over model.creep_rate=0.1:0.5:5 --seeds 10 -o out/creep",
          ""},
         {"fumon sweep terada-barchans --over grid.nx+grid.ny=64,128 -o out/sizes",
          "keys that go together"},
         {"fumon sweep terada-ripples --seeds 100 -o out/many --shard 3/16",
          "one of 16 machines' share"},
         {"fumon sweep terada-ripples --seeds 100 -o out/many --merge",
          "the table, when all are done"},
         {"fumon sweep terada-ripples --seeds 100 -o out/many --slurm 16 | sbatch",
          "both, under Slurm"},
         {"mpirun -n 8 fumon sweep terada-ripples --seeds 100 -o out/many", "both, under MPI"}},
        "DIR/sweep.csv has one row per run and measured step, DIR/runs.csv one row per run, "
        "DIR/runs each run's files.\n"
        "The same command resumes where it was stopped; with more values or seeds it makes only "
        "the new runs.\n"
        "Exit status: 0 done, 2 wrong input, 3 some runs failed or shards are missing, 130/143 "
        "interrupted (finished\nruns are kept).");
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

/// All numbers of a sweep's runs.
std::vector<std::size_t> all_runs(const SweepPlan& plan) {
    std::vector<std::size_t> numbers(plan.runs.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{1});
    return numbers;
}

std::vector<RunRecord> read_records(const SweepFolder& folder,
                                    const std::vector<std::size_t>& numbers) {
    std::vector<RunRecord> records;
    records.reserve(numbers.size());
    for (const std::size_t number : numbers) records.push_back(folder.read_record(number));
    return records;
}

/// Makes the runs that are not done yet; those that failed are tried again.
std::vector<RunRecord> make_runs(const SweepPlan& plan, const SweepFolder& folder,
                                 const std::vector<std::size_t>& numbers, bool alone,
                                 const SweepOptions& options, StatusLine& status) {
    std::vector<RunRecord> records = read_records(folder, numbers);
    for (RunRecord& record : records) {
        if (record.status == RunStatus::failed) record = {};
    }
    if (const std::size_t kept = count(records, RunStatus::done); kept > 0)
        status.note(of_runs(kept, records.size()) + " were there already");
    if (alone) folder.write_runs(records);
    do_runs(sweep_tasks(plan, folder, numbers, records), options.work.threads, status, records);
    return records;
}

/// Says how it ended, with `what` the sweep or a shard of it and `where` its results; returns the
/// exit status.
int report_outcome(const std::vector<RunRecord>& records, const std::string& what,
                   const std::string& where, StatusLine& status) {
    const std::size_t done = count(records, RunStatus::done);
    const std::size_t failed = count(records, RunStatus::failed);
    const int signal = done + failed < records.size() ? interrupting_signal() : 0;
    if (signal != 0) {
        status.note(fmt::format(
            "{}stopped by {}: {} are done and in {}; the same command continues from here", what,
            signal == SIGINT ? "an interrupt" : "a request to terminate",
            of_runs(done, records.size()), where));
        return exit_status_of_signal(signal);
    }
    status.note(fmt::format("{}{} are done: {}", what, of_runs(done, records.size()), where));
    if (failed == 0) return 0;
    status.note(fmt::format("{} failed{}; the same command tries them again",
                            of_runs(failed, records.size()),
                            what.empty() ? " (see runs.csv)" : ""));
    return could_not_work;
}

/// Takes the port at which a sweep is shown in a browser. Nobody knows the address before
/// tell_address().
void open_window(std::optional<JobServer>& window, JobWatch& watch, const SweepOptions& options) {
    prepare_drawing(options.work);
    ViewOptions look;
    look.work = options.work;
    look.watch = &watch;
    window.emplace(
        watch,
        [folder = options.folder, look] { return std::make_unique<SweepPages>(folder, look); },
        options.watch.port);
}

void tell_address(const JobServer& window) {
    std::fputs(window.address_lines().c_str(), stdout);
    std::fflush(stdout);
}

/// For those who watch it.
std::string end_text(const std::vector<RunRecord>& records, const std::string& folder) {
    const std::size_t done = count(records, RunStatus::done);
    const std::size_t failed = count(records, RunStatus::failed);
    if (done + failed < records.size())
        return of_runs(done, records.size()) + " are done; the same command goes on";
    const std::string shown = "; fumon view " + folder;
    return failed == 0 ? "complete" + shown
                       : fmt::format("{} failed; the same command tries them again{}",
                                     of_runs(failed, records.size()), shown);
}

int sweep_alone(const SweepPlan& plan, const SweepOptions& options, JobWatch& watch,
                StatusLine& status) {
    std::optional<JobServer> window;
    if (options.watch.on) open_window(window, watch, options);
    const SweepFolder folder(options.folder, plan, options.force);
    if (window) tell_address(*window);
    for (const std::string& note : plan.notes) status.note(note);
    const std::vector<RunRecord> records =
        make_runs(plan, folder, all_runs(plan), true, options, status);
    folder.write_runs(records);
    folder.write_table(records);
    const int ended = report_outcome(records, "", folder.table().string(), status);
    if (window) window->end(end_text(records, options.folder));
    return ended;
}

int sweep_shard(const SweepPlan& plan, const Shard& shard, const SweepOptions& options,
                StatusLine& status) {
    const SweepFolder folder(options.folder, plan, shard.of, SweepFolder::Use::shard);
    for (const std::string& note : plan.notes) status.note(note);
    const std::vector<RunRecord> records = make_runs(
        plan, folder, runs_of_shard(plan, folder, shard.number, shard.of), false, options, status);
    return report_outcome(records, fmt::format("shard {}: ", shard_text(shard)), options.folder,
                          status);
}

int merge(const SweepPlan& plan, const SweepOptions& options, SweepFolder::Use use,
          StatusLine& status) {
    std::vector<std::filesystem::path> folders(options.from.begin(), options.from.end());
    folders.emplace_back(options.folder);
    const int shards = shards_in(folders);
    const SweepFolder folder(options.folder, plan, shards, use);
    for (const std::string& from : options.from) import_runs(plan, folder, from);
    const std::vector<RunRecord> records = read_records(folder, all_runs(plan));
    folder.write_runs(records);
    const std::vector<std::string> missing = missing_shards(plan, folder, records, shards);
    if (!missing.empty()) {
        for (const std::string& line : missing) status.error(line);
        throw Error(fmt::format("{}: the table is not written, since {} of {} runs are missing",
                                options.folder, count(records, RunStatus::pending),
                                records.size()));
    }
    folder.write_table(records);
    folder.end_sharing();
    return report_outcome(records, "", folder.table().string(), status);
}

/// The share of a program that mpirun started, and all of them together where no other one has
/// still to end.
int sweep_rank(const SweepPlan& plan, const Shard& shard, const SweepOptions& options,
               StatusLine& status) {
    const int ended = sweep_shard(plan, shard, options, status);
    if (interrupting_signal() != 0) return ended;
    {
        const SweepFolder folder(options.folder, plan, shard.of, SweepFolder::Use::shard);
        if (count(read_records(folder, all_runs(plan)), RunStatus::pending) > 0) return ended;
    }
    return merge(plan, options, SweepFolder::Use::last_shard, status);
}

/// The words of the same command without what says how it is shared out.
std::vector<std::string> words_of(const SweepOptions& options) {
    std::vector<std::string> words{"sweep", options.scene};
    for (const std::string& over : options.over) words.insert(words.end(), {"--over", over});
    if (!options.seeds.empty()) words.insert(words.end(), {"--seeds", options.seeds});
    for (const std::string& one : options.work.settings) words.insert(words.end(), {"--set", one});
    words.insert(words.end(), {"-o", options.folder});
    return words;
}

int perform(const SweepOptions& given) {
    const InterruptGuard guard;
    SweepOptions options = given;
    JobWatch watch;
    StatusLine status(options.work.verbosity, options.watch.on ? &watch : nullptr);
    if (options.watch.on && (options.shards.merge || !options.shards.shard.empty() ||
                             options.shards.slurm_shards > 0)) {
        throw InputError(
            "--view watches a sweep that one program makes; look at one that several share with "
            "fumon view DIR");
    }
    const Share share = share_of(options.shards, options.work, status, "writes the table");
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
    if (options.shards.slurm_shards > 0) {
        const auto shards = static_cast<int>(options.shards.slurm_shards);
        std::fputs(slurm_script({"fumon-sweep", words_of(options), shards}).c_str(), stdout);
        return 0;
    }
    if (options.shards.merge) return merge(*plan, options, SweepFolder::Use::merge, status);
    if (!share.shard) return sweep_alone(*plan, options, watch, status);
    return share.of_mpirun ? sweep_rank(*plan, *share.shard, options, status)
                           : sweep_shard(*plan, *share.shard, options, status);
}

}  // namespace

Command sweep_command() {
    return make_command<SweepOptions>(
        "sweep", "run a scene many times, over values and seeds, into one table of measurements",
        declare, perform);
}

}  // namespace fumon
