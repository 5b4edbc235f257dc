#include "paper/store/run_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "files/atomic_file.h"
#include "files/file_lock.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "files/netcdf/netcdf_record.h"
#include "files/snapshot_outline.h"
#include "models/registry.h"
#include "models/shared/state_hash.h"
#include "paper/store/results.h"
#include "run/picture_text.h"
#include "run/prepared_run.h"
#include "run/recorder.h"
#include "run/run_folder.h"
#include "run/run_identity.h"
#include "run/simulate.h"
#include "scene/input_maps.h"
#include "scene/json.h"
#include "scene/scene_roles.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "job.json";

/// What lies beside a run's folder while a program works on it.
constexpr std::string_view lock_end = ".lock";
constexpr std::string_view previous_ending = ".former";

/// What lies in the folder of a stored run.
constexpr std::array<const char*, 4> stored_files{"measurements.csv", "avalanches.csv", "fields.nc",
                                                  manifest_name};

/// Deletes the files of a stored run and its folder. What else lies there stays, and the folder
/// with it.
void remove_folder(const fs::path& folder) {
    std::error_code fault;
    if (fs::is_symlink(folder, fault)) return;
    for (const char* name : stored_files) {
        fs::remove(folder / name, fault);
        fs::remove(temporary_name(folder / name), fault);
    }
    fs::remove(folder, fault);
}

/// A run that is made anew takes the place of the folder, so nothing else may lie there.
void refuse_other_files(const fs::path& folder) {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        const std::string name = entry.path().filename().string();
        const auto is_its = [&name](const char* stored) {
            return name == stored || name == temporary_name(stored);
        };
        if (std::ranges::any_of(stored_files, is_its)) continue;
        throw InputError(
            fmt::format("{}: is not a file of a stored run and would be replaced with its folder; "
                        "move it elsewhere",
                        entry.path().string()));
    }
}

void move_to(const fs::path& from, const fs::path& to) {
    std::error_code fault;
    fs::rename(from, to, fault);
    if (fault) throw Error(fmt::format("cannot write {}: {}", to.string(), fault.message()));
}

void write_manifest(const fs::path& folder, const StoredRun& run, const RunRecord& record,
                    nlohmann::ordered_json outline) {
    nlohmann::ordered_json json;
    json["fumon"] = FUMON_VERSION;
    json["id"] = hex(run.id);
    json["label"] = run.label;
    json["steps"] = record.steps;
    json["fields_at"] = run.steps;
    json["wall_seconds"] = record.wall_seconds;
    json["state_sha256"] = record.state;
    json["snapshots"] = std::move(outline);
    write_file(folder / manifest_name, json_text(json, 2) + "\n");
}

}  // namespace

StoredRun stored_run(const Scene& scene, const InitialBed& initial) {
    StoredRun run{only_roles(scene, measured_roles), {}, {}, {}, 0.0};
    Scene& stored = run.scene;
    if (!initial.inputs.empty()) {
        name_inputs(stored, initial.inputs, &InputFile::path);
        stored.directory.clear();
    }
    if (stored.output.measure_every > 0) stored.frames = {};  // they decide nothing then
    run.id = text_hash(hex(run_id(stored, initial)) + " fumon " FUMON_VERSION);
    run.work = static_cast<double>(scene.grid.nx) * static_cast<double>(scene.grid.ny) *
               static_cast<double>(scene.run.steps + 1);
    return run;
}

StoredRun stored_results(const PreparedScene& prepared, std::shared_ptr<const ForeignRun> results) {
    StoredRun run = stored_run(prepared.scene, prepared.initial);
    std::string read = hex(run.id);
    for (const ForeignScalar& scalar : results->scalars) read += " " + scalar.name;
    run.id = text_hash(read);
    run.results = std::move(results);
    return run;
}

fs::path RunStore::place(const StoredRun& run) const {
    constexpr std::size_t digits = 16;
    return folder_ / hex(run.id).substr(0, digits);
}

fs::path RunStore::beside(const StoredRun& run, std::string_view end) const {
    return place(run) += end;
}

fs::path RunStore::measurements(const StoredRun& run) const {
    return place(run) / "measurements.csv";
}

fs::path RunStore::avalanches(const StoredRun& run) const {
    return place(run) / "avalanches.csv";
}

fs::path RunStore::fields(const StoredRun& run) const {
    return place(run) / "fields.nc";
}

std::optional<RunStore::Content> RunStore::content(const StoredRun& run) const {
    const fs::path manifest = place(run) / manifest_name;
    std::error_code fault;
    if (!fs::exists(manifest, fault)) return std::nullopt;
    try {
        const auto json = parse_json(read_input_file(manifest));
        if (json.at("id") != hex(run.id) || !fs::exists(measurements(run))) return std::nullopt;
        const std::vector<std::int64_t> steps = whole_numbers(json.at("fields_at"));
        Content content{{steps.begin(), steps.end()}, read_outline(json.at("snapshots"))};
        if (!content.steps.empty() && !fs::exists(fields(run))) return std::nullopt;
        content.outline.landform = find_model(run.scene.model.name)->landform;
        return content;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;  // another program has just taken it away, or no bed has its size
    }
}

bool RunStore::holds(const StoredRun& run) const {
    if (run.results) return true;
    const std::optional<Content> there = content(run);
    return there && std::ranges::includes(there->steps, run.steps);
}

std::optional<Snapshot> RunStore::outline(const StoredRun& run) const {
    if (run.results) return foreign_snapshot(*run.results, 0);
    std::optional<Content> there = content(run);
    if (!there) return std::nullopt;
    return std::move(there->outline);
}

Snapshot RunStore::snapshot(const StoredRun& run, std::int64_t step) const {
    if (run.results) return snapshot_of_results(*run.results, step);
    std::optional<Snapshot> known = outline(run);
    if (!known) throw InputError(fmt::format("{}: is damaged; delete it", place(run).string()));
    return read_fields_snapshot(fields(run), step, std::move(*known));
}

void RunStore::clear_leftovers(const StoredRun& run) const {
    std::error_code fault;
    if (!fs::exists(beside(run, lock_end), fault) &&
        !fs::exists(beside(run, previous_ending), fault))
        return;
    try {
        const FileLock lock(beside(run, lock_end));  // whose end takes the file away
        if (lock.held()) remove_folder(beside(run, previous_ending));
    } catch (const Error&) {
        // a store that may only be read keeps them
    }
}

Attempt RunStore::make(const StoredRun& run, int threads, RunRecord& record,
                       std::atomic<double>& cell_steps) const {
    const Stopwatch watch;
    make_folder(folder_);
    const FileLock lock(beside(run, lock_end));
    if (!lock.held()) return Attempt::busy;
    if (holds(run)) return Attempt::done;

    StoredRun wanted = run;
    if (const std::optional<Content> there = content(run))
        wanted.steps.insert(there->steps.begin(), there->steps.end());
    wanted.scene.output.fields_at.assign(wanted.steps.begin(), wanted.steps.end());

    const fs::path made = beside(run, ".part");
    for (const fs::path& folder : {place(run), made, beside(run, previous_ending)})
        refuse_other_files(folder);
    remove_folder(made);  // what a killed program may have left
    make_folder(made);
    try {
        PreparedRun prepared = prepare_run(wanted.scene, threads);
        if (stored_run(prepared.scene, prepared.initial).id != run.id)
            throw Error("one of its input files has changed since the start");
        const Snapshot first = prepared.model->snapshot();
        Recorder recorder(
            prepared.scene, first,
            {RecordPaths{made / "measurements.csv", made / "avalanches.csv", made / "fields.nc"},
             resolved_scene(prepared.scene, prepared.initial.inputs), false, threads});
        if (!simulate(prepared, recorder, record, cell_steps)) {
            remove_folder(made);
            return Attempt::interrupted;
        }
        record.state = hex(state_hash(*prepared.model));
        record.wall_seconds = watch.seconds();
        write_manifest(made, wanted, record, outline_json(first));
        put(made, run);
    } catch (...) {
        remove_folder(made);
        throw;
    }
    return Attempt::done;
}

void RunStore::put(const fs::path& made, const StoredRun& run) const {
    const fs::path previous = beside(run, previous_ending);
    remove_folder(previous);
    if (fs::exists(place(run))) move_to(place(run), previous);
    move_to(made, place(run));
    remove_folder(previous);
}

}  // namespace fumon
