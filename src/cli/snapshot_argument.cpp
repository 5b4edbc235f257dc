#include "cli/snapshot_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/snapshots/ground_range.h"
#include "cli/remark.h"
#include "files/netcdf/netcdf_record.h"
#include "foreign/open_run.h"
#include "measure/suite.h"
#include "scene/initial_bed.h"
#include "scene/terrain_scene.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// What a run's fields file holds beside the bed: its water or air, the numbers of a pile …
void add_record(const std::string& file, Snapshot& snapshot) {
    std::optional<FieldsRecord> record = read_fields_record(file);
    if (!record) return;
    snapshot.periodic = record->periodic;
    snapshot.numbers = std::move(record->numbers);
    const bool fits = std::ranges::all_of(record->fields, [&](const SnapshotField& field) {
        return field.values.nx() == snapshot.bed.nx() && field.values.ny() == snapshot.bed.ny();
    });
    if (fits) snapshot.fields = std::move(record->fields);
    if (record->section && snapshot.bed.ny() == 1 &&
        record->section->fields.front().values.nx() == snapshot.bed.nx())
        snapshot.section = std::move(record->section);
}

}  // namespace

fs::path last_state_of(const fs::path& run) {
    std::error_code fault;
    if (!fs::is_directory(run, fault)) return run;
    if (fs::exists(run / "fields.nc", fault)) return run / "fields.nc";
    fs::path last;
    for (const auto& entry : fs::directory_iterator(run / "beds", fault)) {
        const fs::path& file = entry.path();
        const bool is_bed = file.extension() == ".asc" || file.extension() == ".tif";
        if (is_bed && file.filename() > last.filename()) last = file;
    }
    if (!last.empty()) return last;
    throw InputError(fmt::format(
        "{}: holds neither fields.nc nor beds; run the scene with --set output.fields_every=N or "
        "output.bed_at=[N]",
        run.string()));
}

fs::path state_of_step(const fs::path& run, std::int64_t step) {
    std::error_code fault;
    if (!fs::is_directory(run, fault)) return run;
    if (fs::exists(run / "fields.nc", fault)) return run / "fields.nc";
    const fs::path bed = run / "beds" / fmt::format("bed_{:08}", step);
    for (const char* ending : {".asc", ".tif"}) {
        if (fs::path file = bed.string() + ending; fs::exists(file, fault)) return file;
    }
    throw InputError(
        fmt::format("--step {}: {} holds neither fields.nc nor {}.asc; it has the "
                    "beds of output.bed_at and output.bed_every",
                    step, run.string(), (fs::path("beds") / bed.filename()).string()));
}

std::optional<Snapshot> foreign_state(const std::string& file, std::optional<std::int64_t> step) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault) || !is_foreign_run(file) || is_fields_file(file))
        return std::nullopt;
    std::optional<ForeignRun> run;
    try {
        run = open_foreign_run(file);
    } catch (const InputError&) {
        if (step) throw;
        return std::nullopt;  // it may be terrain all the same, which reading it decides
    }
    if (!step && !run->has_water()) return std::nullopt;
    const std::vector<std::int64_t>& steps = run->times.steps;
    const auto found = std::ranges::find(steps, step.value_or(steps.back()));
    if (found == steps.end())
        throw InputError(fmt::format("--step {}: {} has records of the steps {} to {}", *step, file,
                                     steps.front(), steps.back()));
    return foreign_snapshot(*run, static_cast<std::size_t>(found - steps.begin()));
}

Snapshot read_snapshot(const std::string& file, const std::string& heights,
                       const std::vector<std::string>& settings, bool remarks) {
    if (heights.empty() && settings.empty()) {
        if (std::optional<Snapshot> state = foreign_state(file)) {
            if (remarks) remark(fmt::format("{}: record {}, its last\n", file, state->step + 1));
            return *std::move(state);
        }
    }
    const Scene scene = terrain_scene(file, heights, settings);
    InitialBed initial = make_initial_bed(scene);
    if (remarks && !initial.note.empty()) remark(initial.note + "\n");
    Snapshot snapshot;
    snapshot.time_unit = "steps";
    snapshot.bed = std::move(initial.bed);
    snapshot.nodata = std::move(initial.nodata);
    snapshot.scale = initial.scale;
    snapshot.periodic = scene.view.look.sea_level.is_word();  // a sea comes over the bed's edge
    if (scene.bed.variable.empty()) add_record(file, snapshot);
    snapshot.landform = guessed_landform(snapshot);
    if (const std::string fault = beyond_ground(snapshot); !fault.empty())
        throw InputError(fmt::format("{}: {}", file, fault));
    return snapshot;
}

}  // namespace fumon
