#include "film/beds/stored_beds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/find_named.h"
#include "base/snapshots/ground_range.h"
#include "base/truncation.h"
#include "files/csv_table.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "files/netcdf/netcdf_record.h"
#include "film/beds/bed_alone.h"
#include "measure/suite.h"
#include "run/inputs/find_input.h"
#include "run/run_identity.h"
#include "scene/json.h"
#include "scene/read.h"
#include "scene/uses_metres.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_cached_beds = 4;  // a cross-fade of two shots, and what comes next
constexpr std::size_t most_cached_bytes = std::size_t{96} << 20U;  // of more than one

std::size_t bytes_of(const Snapshot& snapshot) {
    return snapshot.bed.size() * sizeof(double) * (1 + snapshot.fields.size());
}

/// A JSON value as TOML: objects as inline tables.
std::string toml_value(const Json& value) {
    if (value.is_object()) {
        std::string text;
        for (const auto& [name, part] : value.items())
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, toml_value(part));
        return "{" + text + "}";
    }
    if (value.is_array()) {
        std::string text;
        for (const Json& part : value) text += (text.empty() ? "" : ", ") + toml_value(part);
        return "[" + text + "]";
    }
    return json_text(value);
}

std::string scene_toml(const Json& scene) {
    std::string text;
    for (const auto& [name, value] : scene.items())
        text += fmt::format("{} = {}\n", name, toml_value(value));
    return text;
}

Json read_any_manifest(const fs::path& folder) {
    const fs::path file = folder / "run.json";
    std::error_code fault;
    if (!fs::is_directory(folder, fault))
        throw InputError(
            fmt::format("{}: is not a folder; a film is cut from a run's folder", folder.string()));
    if (!fs::is_regular_file(file, fault))
        throw InputError(
            fmt::format("{}: holds no run (no run.json); `fumon run SCENE -o {}` "
                        "makes one",
                        folder.string(), folder.string()));
    try {
        Json manifest = parse_json(read_input_file(file));
        static_cast<void>(manifest.at("status"));
        return manifest;
    } catch (const nlohmann::json::exception&) {
        throw InputError(
            fmt::format("{}: is not the manifest of a run, or is damaged; run the scene "
                        "again",
                        file.string()));
    }
}

Json read_manifest(const fs::path& folder) {
    Json manifest = read_any_manifest(folder);
    if (manifest["status"] == "complete") return manifest;
    throw InputError(
        fmt::format("{}: its run is not finished; `fumon run --resume {}` continues it",
                    folder.string(), folder.string()));
}

std::vector<InputFile> inputs_of(const Json& manifest) {
    std::vector<InputFile> inputs;
    for (const auto& input : manifest.value("inputs", Json::array()))
        inputs.push_back({input.at("path"), input.at("sha256")});
    return inputs;
}

/// What the run computed and recorded, which is not computed again.
void check_settings(const Scene& stored, const Scene& changed) {
    const std::string differs =
        scene_difference(scene_json(stored, recorded_roles), scene_json(changed, recorded_roles));
    if (differs.empty()) return;
    throw InputError(fmt::format(
        "--set: {}; with stored beds only keys of the look and of the output files can change",
        differs));
}

Scene scene_of(const Json& manifest, const fs::path& folder,
               const std::vector<std::string>& settings) {
    const std::string file = (folder / "run.json").string();
    SceneText text{scene_toml(manifest.at("scene")), file, ""};
    text.version = manifest.at("fumon").get<std::string>();
    text.resolved = true;
    Scene scene = parse_scene(text, read_settings(settings));
    if (!settings.empty()) check_settings(parse_scene(text, {}), scene);
    const std::vector<InputFile> inputs = inputs_of(manifest);
    find_inputs(scene, inputs, folder / "run.json", "run");
    return scene;
}

void check_beds_suffice(const std::string& name, const Snapshot& first, const View& view) {
    const std::string_view missing = missing_besides_beds(first, view);
    if (missing.empty()) return;
    throw InputError(
        fmt::format("{}: its run stored beds without {}; run the scene again with "
                    "--set output.fields_every=N",
                    name, missing));
}

std::vector<StoredBed> beds_of(const Json& manifest, const fs::path& folder, const Snapshot& first,
                               const View& view) {
    std::vector<StoredBed> beds;
    if (manifest.contains("fields")) {
        for (const FieldsMoment& moment :
             read_fields_moments(folder / manifest["fields"].get<std::string>()))
            beds.push_back({moment.step, moment.time, ""});
        if (!beds.empty()) return beds;
    }
    const double steps = std::max(1.0, manifest.value("steps_done", 1.0));
    const double time_of_step = manifest.value("time", steps) / steps;
    std::set<std::int64_t> seen;
    for (const auto& bed : manifest.value("beds", Json::array())) {
        const auto step = bed.at("step").get<std::int64_t>();
        if (!seen.insert(step).second) continue;  // in another format
        beds.push_back({step, time_of_step * static_cast<double>(step), bed.at("file")});
    }
    if (beds.empty()) {
        throw InputError(fmt::format(
            "{}: its run stored no beds to cut a film from; run the scene again with --set "
            "output.fields_every=N (all fields) or output.bed_every=N (beds alone), every N steps",
            folder.string()));
    }
    check_beds_suffice(folder.string(), first, view);
    return beds;
}

/// What is kept by a number, else what is read, which is kept then in the place of the oldest. Of
/// `like`, an outline of it, the oldest go before it is read.
template <class Kept, class Read>
std::shared_ptr<const Snapshot> kept_or(std::vector<Kept>& all, std::size_t number,
                                        const Snapshot& like, const Read& read) {
    const auto found = std::ranges::find(all, number, &Kept::number);
    if (found != all.end()) {
        std::rotate(found, found + 1, all.end());
        return all.back().snapshot;
    }
    const std::size_t bytes = std::max<std::size_t>(1, bytes_of(like));
    const std::size_t most =
        std::clamp<std::size_t>(most_cached_bytes / bytes, 1, most_cached_beds);
    if (all.size() >= most)
        all.erase(all.begin(), all.end() - static_cast<std::ptrdiff_t>(most - 1));
    all.push_back({number, std::make_shared<const Snapshot>(read())});
    return all.back().snapshot;
}

Scene scene_of_bed(const Scene& scene, const fs::path& file) {
    Scene stored = scene;
    stored.bed = BedSettings{};
    stored.bed.kind = BedKind::file;
    stored.bed.file = file.string();
    stored.locations["bed.file"] = "--set 1";  // as seen from the working folder
    return stored;
}

}  // namespace

Scene scene_of_run(const fs::path& folder, const std::vector<std::string>& settings) {
    const Json manifest = read_any_manifest(folder);
    try {
        return scene_of(manifest, folder, settings);
    } catch (const nlohmann::json::exception&) {
        throw InputError(
            fmt::format("{}: is damaged; run the scene again", (folder / "run.json").string()));
    }
}

Scene scene_of_fields(const fs::path& file, const std::vector<std::string>& settings) {
    SceneText text{read_fields_scene(file), file.string(), ""};
    text.version = read_fields_version(file);
    text.resolved = true;
    return parse_scene(text, read_settings(settings));
}

Snapshot read_stored_bed(const Scene& scene, const fs::path& file, const Snapshot& outline) {
    Snapshot snapshot = outline;
    InitialBed read = make_initial_bed(scene_of_bed(scene, file));
    if (read.bed.nx() != outline.bed.nx() || read.bed.ny() != outline.bed.ny())
        throw InputError(
            fmt::format("{}: has a different size than the run's beds", file.string()));
    snapshot.bed = std::move(read.bed);
    if (!snapshot.nodata.empty() && !read.nodata.empty()) snapshot.nodata = std::move(read.nodata);
    keep_fields_of_bed(snapshot);
    return snapshot;
}

StoredBeds::StoredBeds(fs::path folder, int threads, const std::vector<std::string>& settings)
    : name_(folder.string()),
      folder_(std::move(folder)),
      fields_("fields.nc"),
      measurements_("measurements.csv"),
      manifest_(folder_ / "run.json") {
    const Json manifest = read_manifest(folder_);
    try {
        run_ = prepare_run(scene_of(manifest, folder_, settings), threads);
        first_ = run_.model->snapshot();
        beds_ = beds_of(manifest, folder_, first_, run_.scene.view);
    } catch (const nlohmann::json::exception&) {
        throw InputError(
            fmt::format("{}: is damaged; run the scene again", (folder_ / "run.json").string()));
    }
    run_.model.reset();
}

StoredBeds StoredBeds::of_sweep(const fs::path& folder, std::int64_t number, int threads) {
    StoredBeds stored;
    stored.name_ = fmt::format("{}, run {}", folder.string(), number);
    stored.folder_ = folder / "runs";
    stored.fields_ = fmt::format("{:04}-fields.nc", number);
    stored.measurements_ = fmt::format("{:04}.csv", number);
    stored.manifest_ = folder / "sweep.json";
    std::error_code fault;
    if (!fs::exists(stored.folder_ / fmt::format("{:04}.json", number), fault)) {
        throw InputError(fmt::format(
            "{}: is not finished; `fumon sweep` with the same values continues it", stored.name_));
    }
    const fs::path fields = stored.folder_ / stored.fields_;
    if (!fs::exists(fields, fault)) {
        throw InputError(
            fmt::format("{}: stored no beds to cut a film from; make the sweep again with --set "
                        "output.fields_every=N, every N steps",
                        stored.name_));
    }
    try {
        Scene scene = scene_of_fields(fields);
        const std::vector<InputFile> inputs =
            inputs_of(parse_json(read_input_file(stored.manifest_)));
        find_inputs(scene, inputs, stored.manifest_, "sweep");
        stored.run_ = prepare_run(std::move(scene), threads);
    } catch (const nlohmann::json::exception&) {
        throw InputError(
            fmt::format("{}: is damaged; make the sweep again", stored.manifest_.string()));
    }
    stored.first_ = stored.run_.model->snapshot();
    stored.run_.model.reset();
    for (const FieldsMoment& moment : read_fields_moments(fields))
        stored.beds_.push_back({moment.step, moment.time, ""});
    if (stored.beds_.empty()) throw InputError(stored.name_ + ": stored no beds; make it again");
    return stored;
}

StoredBeds StoredBeds::recorded(std::string name, fs::path folder, PreparedRun run, Snapshot first,
                                std::vector<StoredBed> written) {
    StoredBeds stored;
    stored.name_ = std::move(name);
    stored.folder_ = std::move(folder);
    stored.fields_ = "fields.nc";
    stored.measurements_ = "measurements.csv";
    stored.run_ = std::move(run);
    const auto steps = static_cast<double>(stored.run_.model->steps_done());
    const double time_of_step = stored.run_.model->snapshot().time / std::max(1.0, steps);
    stored.run_.model.reset();
    stored.first_ = std::move(first);
    std::error_code fault;
    if (!fs::exists(stored.folder_ / stored.fields_, fault)) {
        check_beds_suffice(stored.name_, stored.first_, stored.run_.scene.view);
        stored.beds_ = std::move(written);
        for (StoredBed& bed : stored.beds_) bed.time = time_of_step * static_cast<double>(bed.step);
        return stored;
    }
    for (const FieldsMoment& moment : read_fields_moments(stored.folder_ / stored.fields_))
        stored.beds_.push_back({moment.step, moment.time, ""});
    return stored;
}

Snapshot StoredBeds::read(std::size_t number, const Snapshot& outline) const {
    if (foreign_) {
        const bool all = outline.fields.size() == first_.fields.size();
        return all ? foreign_snapshot(*foreign_, number) : foreign_bed(*foreign_, number);
    }
    const StoredBed& bed = beds_.at(number);
    if (bed.file.empty()) {
        Snapshot stored = read_fields_snapshot(folder_ / fields_, bed.step, outline);
        if (const std::string fault = beyond_ground(stored); !fault.empty())
            throw InputError(fmt::format("{}: {}", (folder_ / fields_).string(), fault));
        return stored;
    }
    Snapshot snapshot = read_stored_bed(run_.scene, folder_ / bed.file, outline);
    snapshot.step = bed.step;
    snapshot.time = bed.time;
    return snapshot;
}

std::shared_ptr<const Snapshot> StoredBeds::snapshot(std::size_t number) const {
    return kept_or(kept_, number, first_, [&] { return read(number, first_); });
}

std::shared_ptr<const Snapshot> StoredBeds::snapshot(const RecordPlace& place) const {
    if (place.share <= 0.0 || place.next == place.bed) return snapshot(place.bed);
    const auto known = std::ranges::find(blended_, place, &Blended::place);
    if (known != blended_.end()) return known->snapshot;
    if (blended_.size() >= 2) blended_.erase(blended_.begin());
    // What lies between the same two is read once.
    const bool goes_on = !blended_.empty() && blended_.back().place.bed == place.bed &&
                         blended_.back().place.next == place.next;
    const auto one = goes_on ? blended_.back().one : snapshot(place.bed);
    const auto other = goes_on ? blended_.back().other : snapshot(place.next);
    blended_.push_back(
        {place, one, other, std::make_shared<const Snapshot>(blended(*one, *other, place.share))});
    return blended_.back().snapshot;
}

std::int64_t StoredBeds::step_at(const RecordPlace& place) const {
    const std::int64_t from = beds_.at(place.bed).step;
    const auto way = static_cast<double>(beds_.at(place.next).step - from);
    return from + std::llround(place.share * way);
}

std::shared_ptr<const Snapshot> StoredBeds::heights(std::size_t number) const {
    const auto whole = std::ranges::find(kept_, number, &Kept::number);
    if (whole != kept_.end()) return whole->snapshot;
    if (!bare_) {
        bare_ = first_;
        bare_->fields.clear();
        bare_->numbers.clear();
        bare_->section.reset();
    }
    return kept_or(kept_heights_, number, *bare_, [&] { return read(number, *bare_); });
}

std::vector<MeasuredRows> StoredBeds::measurements(const std::vector<std::string>& names) const {
    std::vector<MeasuredRows> rows;
    if (names.empty()) {
        rows.resize(beds_.size());
        return rows;
    }
    if (foreign_) return measured_rows(names);
    const fs::path file = folder_ / measurements_;
    std::error_code fault;
    if (!fs::is_regular_file(file, fault))
        throw InputError(
            fmt::format("{}: does not exist, but a plot needs it; run the scene with "
                        "output.measurements = true",
                        file.string()));
    const Table table = parse_csv_table({file.string(), read_input_file(file)});
    const MeasureSuite suite(measured_landform(first_), first_,
                             {run_.scene.output.channel_area, uses_metres(run_.scene)});
    RowGatherer gatherer(names, suite.columns(), first_);
    const TableColumn* steps = table.find("step");
    const TableColumn* times = table.find("time");
    if (steps == nullptr || times == nullptr)
        throw InputError(file.string() + ": has no step or time; run the scene again");
    for (const std::string& name : names) {
        if (table.find(name) == nullptr && find_named(suite.columns(), name) != nullptr)
            throw InputError(
                fmt::format("{}: has no column {}, but a plot needs it; add it to output.columns",
                            file.string(), name));
    }
    for (std::size_t i = 0; i < table.rows(); ++i) {
        Snapshot at;
        at.step = truncated(steps->values[i]);
        at.time = times->values[i];
        while (rows.size() < beds_.size() && at.step > beds_[rows.size()].step)
            rows.push_back(gatherer.rows());
        std::vector<double> row;
        for (const MeasureColumn& column : suite.columns()) {
            const TableColumn* found = table.find(column.name);
            row.push_back(found == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                           : found->values[i]);
        }
        gatherer.take(at, row);
    }
    rows.resize(beds_.size(), gatherer.rows());
    return rows;
}

std::vector<fs::path> StoredBeds::files() const {
    if (foreign_) return foreign_->files;
    std::vector<fs::path> files{manifest_, folder_ / fields_, folder_ / measurements_};
    for (const StoredBed& bed : beds_)
        if (!bed.file.empty()) files.push_back(folder_ / bed.file);
    for (const InputFile& input : run_.initial.inputs) files.emplace_back(input.path);
    return files;
}

}  // namespace fumon
