#include "film/film_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/scratch_folder.h"
#include "film/film_read.h"
#include "film/film_texts.h"
#include "film/make_film.h"
#include "film/results_again.h"
#include "outputs/output_claims.h"
#include "picture/exr.h"
#include "run/drawing.h"
#include "run/inputs/find_input.h"
#include "run/output_files.h"
#include "run/prepared_run.h"
#include "run/run_folder.h"
#include "run/simulate.h"
#include "run/terminal/interrupt.h"
#include "scene/read.h"
#include "scene/schedule.h"
#include "scene/trust.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// `layers`: files of the film besides the run's.
Scene scene_of(const FilmedRun& run, const std::vector<LayerRecord>& layers,
               const FilmAgain& wanted) {
    std::vector<InputFile> listed = run.inputs;
    for (const LayerRecord& layer : layers) listed.push_back(layer.input);
    Scene scene = parse_scene(
        {run.scene, wanted.film.string(), "", wanted.trust, hashes_of(listed), run.version, true},
        {});
    check_limits(scene, 1, scene.run.steps);
    find_inputs(scene, run.inputs, wanted.film, "film");
    return scene;
}

/// Writes beds alone, as a run does.
class BedWriter : public StepObserver {
  public:
    BedWriter(const Scene& scene, const fs::path& folder)
        : schedule_(bed_schedule(scene)), formats_(scene.output.bed_format), folder_(folder, true) {
        if (schedule_.count() > 0) make_folder(folder / "beds");
    }
    [[nodiscard]] bool wants(std::int64_t step) const override { return schedule_.due(step); }
    void take(const SharedSnapshot& snapshot) override {
        const BedRecord written = write_bed(folder_, *snapshot, formats_);
        beds_.push_back({snapshot->step, 0.0,
                         RunFolder::bed_name(snapshot->step, written.files.front().ending)});
    }
    [[nodiscard]] const std::vector<StoredBed>& beds() const { return beds_; }

  private:
    Schedule schedule_;
    std::vector<std::string> formats_;
    RunFolder folder_;
    std::vector<StoredBed> beds_;
};

/// Simulates a run into a folder. Nothing when interrupted.
std::optional<StoredBeds> stored_again(const FilmedRun& run, const std::vector<LayerRecord>& layers,
                                       const FilmAgain& wanted, const fs::path& folder) {
    PreparedScene ready = prepare_scene(scene_of(run, layers, wanted));
    check_limits(ready.scene, static_cast<std::int64_t>(ready.initial.bed.size()),
                 ready.scene.run.steps);
    PreparedRun prepared = prepare_run(std::move(ready), wanted.work.threads);
    if (!run.inputs.empty()) prepared.initial.inputs = run.inputs;  // as they were named then
    Snapshot first = prepared.model->snapshot();
    Recording recording;
    recording.files = {folder / "measurements.csv", folder / "avalanches.csv",
                       folder / "fields.nc"};
    recording.resolved = run.scene;
    recording.threads = wanted.work.threads;
    Recorder recorder(prepared.scene, first, std::move(recording));
    RunRecord record;
    std::atomic<double> cell_steps{0.0};
    BedWriter writer(prepared.scene, folder);
    if (!simulate(prepared, recorder, record, cell_steps, &writer)) return std::nullopt;
    return StoredBeds::recorded(run.name, folder, std::move(prepared), std::move(first),
                                writer.beds());
}

/// The endings that what is made again may have, that of the film first.
std::vector<std::string_view> endings_of(const Film& film, const fs::path& file) {
    if (film.settings.format != "poster") return {ending_of(film.settings.format)};
    constexpr std::size_t signature = 4;  // bytes
    if (is_exr(start_of_input_file(file, signature))) return {exr_ending.front(), ".png"};
    return {".png", exr_ending.front()};
}

}  // namespace

bool is_made_film(const fs::path& file) {
    const FilmTexts texts = read_film_texts(file);
    return texts.contains(film_keyword);
}

int make_film_again(const FilmAgain& wanted) {
    const FilmTexts texts = read_film_texts(wanted.film);
    const std::vector<FilmedRun> runs = filmed_runs(texts, wanted.film.string());
    const FilmText text = film_text(wanted.film);
    Film film = parse_film(text.text, wanted.film.string(), wanted.work.settings, false);
    const std::vector<LayerRecord> layers = filmed_layers(texts);
    film.found_layers = found_layers(film, layers, wanted.film);
    const std::vector<std::string_view> endings = endings_of(film, wanted.film);
    const fs::path usual = wanted.film.stem().string() + "-again" + std::string(endings.front());
    FilmOutput output{wanted.output.empty() ? usual : wanted.output, std::move(film),
                      most_bytes_of(texts)};
    check_ending(output.file, "this film", endings);
    OutputClaims claims(wanted.force);
    claims.reads(wanted.film);
    claim_film(claims, output);
    prepare_drawing(wanted.work);
    StatusLine status(wanted.work.verbosity);
    const ScratchFolder scratch;
    std::vector<StoredBeds> stored;
    const auto foreign =
        std::ranges::count_if(runs, [](const FilmedRun& run) { return run.foreign.has_value(); });
    if (std::cmp_greater(wanted.from.size(), foreign))
        throw InputError(fmt::format(
            "{}: --from is given {} times, but {} of the film's runs are another model's",
            wanted.film.string(), wanted.from.size(), foreign));
    auto given = wanted.from.begin();
    for (const FilmedRun& run : runs) {
        if (run.foreign) {
            const std::string from = given == wanted.from.end() ? "" : *given++;
            std::vector<InputFile> others;
            others.reserve(layers.size());
            for (const LayerRecord& layer : layers) others.push_back(layer.input);
            stored.push_back(results_again(
                {run.name, run.inputs, *run.foreign},
                {wanted.film, "film", from, wanted.work.threads, wanted.trust, std::move(others)},
                status));
            continue;
        }
        const fs::path folder = scratch.path() / std::to_string(stored.size() + 1);
        fs::create_directory(folder);
        if (status.due())
            status.show(fmt::format("simulates run {} of {}", stored.size() + 1, runs.size()));
        std::optional<StoredBeds> beds = stored_again(run, layers, wanted, folder);
        if (!beds) return exit_status_of_signal(interrupting_signal());
        stored.push_back(std::move(*beds));
    }
    const FilmRuns film_runs(std::move(stored), arrangement_of(output.film));
    const MadeFilm made = make_film(output, film_runs, text.remake, wanted.work, status);
    if (made.signal != 0) return exit_status_of_signal(made.signal);
    const bool other_format = small_ending(output.file) != endings.front();
    if (other_format || !wanted.work.settings.empty()) {
        status.note(fmt::format("{}: made", output.file.string()));
    } else if (file_hash(output.file) == file_hash(wanted.film)) {
        status.note(
            fmt::format("{}: the same bytes as {}", output.file.string(), wanted.film.string()));
    } else {
        status.note(fmt::format("{}: made, but its bytes differ from {} ({})", output.file.string(),
                                wanted.film.string(), why_films_differ(texts, output.file)));
    }
    return 0;
}

}  // namespace fumon
