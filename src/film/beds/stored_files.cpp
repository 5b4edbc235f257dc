#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/snapshots/ground_range.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_record.h"
#include "film/beds/results_text.h"
#include "film/beds/stored_beds.h"
#include "film/beds/stored_still.h"
#include "foreign/open_run.h"
#include "measure/suite.h"
#include "scene/read.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// How a run of another model is shown where nobody says more.
constexpr const char* foreign_scene = R"([model]
name = "static"
[bed]
kind = "file"
file = "-"
[[overlay]]
kind = "time"
[[overlay]]
kind = "scale-bar"
corner = "lower-left"
)";

/// Whether a file is fumon's own with the scene of its run.
bool is_run_of_fumon(const fs::path& file) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault) ||
        !is_netcdf(start_of_input_file(file, netcdf_signature_length)))
        return false;
    try {
        return is_fields_file(file) && !read_fields_scene(file).empty();
    } catch (const InputError&) {
        return false;  // which opening it says better
    }
}

constexpr const char* bar_of_colours = R"([[overlay]]
kind = "colour-bar"
corner = "lower-right"
)";

/// What a user wants to see beside the query's maps: the field of the look.
ForeignQuery with_field_of(ForeignQuery query, const std::vector<std::string>& settings) {
    for (const Override& setting : read_settings(settings))
        if (setting.path == "look.field") query.scalars.push_back(plain_text(setting));
    return query;
}

Scene scene_of_foreign(const ForeignRun& run, const std::vector<std::string>& settings) {
    Scene scene = parse_scene(foreign_scene, "", "", settings);
    if (scene.view.look.colour_by != Colouring::natural)
        scene = parse_scene(std::string(foreign_scene) + bar_of_colours, "", "", settings);
    std::erase_if(scene.locations,
                  [](const auto& entry) { return !entry.second.starts_with("--set"); });
    if (scene.title.empty()) scene.title = run.title;
    const ForeignField* bed = run.find(Quantity::bed);
    scene.bed.file = run.files.empty() ? run.name : run.files.front().string();
    if (bed != nullptr && !bed->dimensions.empty()) scene.bed.variable = bed->name;
    scene.run.steps = run.times.steps.back();
    return scene;
}

}  // namespace

StoredBeds StoredBeds::of_argument(const std::string& argument, int threads,
                                   const std::vector<std::string>& settings,
                                   const ForeignQuery& query) {
    if (query.fields.empty()) {
        if (const auto folder = run_folder_of(argument))
            return StoredBeds(*folder, threads, settings);
    }
    if (is_foreign_run(argument)) return of_files(argument, threads, settings, query);
    std::error_code fault;
    if (fs::is_regular_file(argument, fault))
        throw InputError(
            fmt::format("{}: is neither a run's folder nor a file of results; results are NetCDF, "
                        "or a series of "
                        "rasters as a pattern of names ('elev_*.asc')",
                        argument));
    return StoredBeds(argument, threads, settings);
}

StoredBeds StoredBeds::of_files(const std::string& argument, int threads,
                                const std::vector<std::string>& settings,
                                const ForeignQuery& query) {
    if (query.fields.empty() && is_run_of_fumon(argument))
        return of_own_fields(argument, threads, settings);
    const ForeignQuery asked = with_field_of(query, settings);
    return of_foreign(open_foreign_run(argument, asked), asked, settings);
}

StoredBeds StoredBeds::of_foreign_files(const std::string& argument, const ForeignQuery& query) {
    return of_foreign(open_foreign_run(argument, query), query, {});
}

void StoredBeds::distrust(std::shared_ptr<const std::vector<std::string>> hashes) {
    run_.scene.trusted = false;
    run_.scene.bed_hashes = std::move(hashes);
}

StoredBeds StoredBeds::of_records(ForeignRun run, const std::vector<std::string>& settings) {
    return of_foreign(std::move(run), {}, settings);
}

StoredBeds StoredBeds::of_own_fields(const fs::path& file, int threads,
                                     const std::vector<std::string>& settings) {
    StoredBeds stored;
    stored.name_ = file.string();
    stored.folder_ = file.has_parent_path() ? file.parent_path() : fs::path(".");
    stored.fields_ = file.filename();
    stored.measurements_ = file.stem().string() + ".csv";
    stored.manifest_ = file;
    for (const FieldsMoment& moment : read_fields_moments(file))
        stored.beds_.push_back({moment.step, moment.time, ""});
    if (stored.beds_.empty())
        throw InputError(
            fmt::format("{}: has no record yet; let the run write one first", stored.name_));
    Scene scene = scene_of_fields(file, settings);
    Scene at_start = scene;
    at_start.bed = BedSettings{};
    at_start.bed.kind = BedKind::file;
    at_start.bed.file = file.string();
    at_start.bed.variable = "bed_height";
    at_start.bed.record = stored.beds_.size() > 1 ? 1 : 0;
    at_start.grid.cell_size.clear();
    at_start.locations["bed.file"] = "--set 1";  // as seen from the working folder
    InitialBed initial = make_initial_bed(at_start);
    initial.inputs = {{file.string(), results_hash(file)}};
    initial.note.clear();
    stored.run_ = prepare_run(prepare_scene(std::move(scene), std::move(initial)), threads);
    stored.first_ = stored.run_.model->snapshot();
    stored.run_.model.reset();
    return stored;
}

StoredBeds StoredBeds::of_foreign(ForeignRun run, const ForeignQuery& query,
                                  const std::vector<std::string>& settings) {
    StoredBeds stored;
    stored.name_ = run.name;
    stored.foreign_ = std::move(run);
    stored.query_ = query;
    const ForeignRun& foreign = *stored.foreign_;
    for (std::size_t i = 0; i < foreign.times.times.size(); ++i)
        stored.beds_.push_back({foreign.times.steps[i], foreign.times.times[i], ""});
    stored.first_ = foreign_snapshot(foreign, 0);
    if (const std::string fault = beyond_ground(stored.first_); !fault.empty())
        throw InputError(fmt::format("{}: {}", foreign.name, fault));
    InitialBed initial;
    initial.bed = stored.first_.bed;
    initial.nodata = stored.first_.nodata;
    initial.scale = stored.first_.scale;
    if (!foreign.files.empty())
        initial.inputs.push_back(
            {foreign.files.front().string(), results_hash(foreign.files.front())});  // its bed.file
    PreparedScene ready = prepare_scene(scene_of_foreign(foreign, settings), std::move(initial));
    for (std::size_t i = 1; i < foreign.files.size(); ++i)
        ready.initial.inputs.push_back({foreign.files[i].string(), results_hash(foreign.files[i])});
    stored.run_.scene = std::move(ready.scene);
    stored.run_.initial = std::move(ready.initial);
    stored.run_.initial.bed = {};  // which nothing steps
    check_shown(stored.run_.scene, stored.first_);
    return stored;
}

std::vector<MeasuredRows> StoredBeds::measured_rows(const std::vector<std::string>& names) const {
    std::vector<MeasuredRows> rows;
    MeasureSuite suite(measured_landform(first_), first_,
                       {run_.scene.output.channel_area, first_.scale.in_metres});
    RowGatherer gatherer(names, suite.columns(), first_);
    for (std::size_t number = 0; number < beds_.size(); ++number) {
        const auto bed = snapshot(number);
        gatherer.take(*bed, suite.row(*bed));
        rows.push_back(gatherer.rows());
    }
    return rows;
}

}  // namespace fumon
