#include "web/page_run.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "drape/lay_drape.h"
#include "drape/lay_layers.h"
#include "film/beds/stored_still.h"
#include "foreign/file_numbers.h"
#include "foreign/open_run.h"
#include "scene/initial_bed.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

PageRun page_of(const std::shared_ptr<const StoredBeds>& beds) {
    PageRun run;
    run.name = beds->name();
    run.scene = beds->scene();
    run.inputs = beds->inputs();
    run.first = beds->first();
    run.beds = beds->beds();
    run.files = beds->files();
    run.snapshot = [beds](std::size_t bed) { return beds->snapshot(bed); };
    return run;
}

/// Of one bed alone.
void keep_bed(PageRun& run, std::size_t number) {
    run.beds = {run.beds.at(number)};
    run.snapshot = [all = std::move(run.snapshot), number](std::size_t) { return all(number); };
}

}  // namespace

std::optional<PageRun> stored_page_run(const std::string& argument, int threads,
                                       const std::vector<std::string>& settings,
                                       std::optional<std::int64_t> step) {
    std::shared_ptr<const StoredBeds> beds;
    std::error_code fault;
    if (const std::optional<fs::path> folder = run_folder_of(argument)) {
        beds = std::make_shared<StoredBeds>(*folder, threads, settings);
    } else if (is_pattern(argument) || is_foreign_run(argument)) {
        try {
            beds =
                std::make_shared<StoredBeds>(StoredBeds::of_argument(argument, threads, settings));
        } catch (const InputError&) {
            if (step || !fs::is_regular_file(argument, fault)) throw;
            return std::nullopt;  // it may be terrain all the same
        }
    } else {
        return std::nullopt;
    }
    PageRun run = page_of(beds);
    if (step) keep_bed(run, bed_of_step(*beds, *step));
    return run;
}

PageRun single_page_run(std::string name, Scene scene, Snapshot snapshot, std::string& note) {
    InitialBed drawn;
    drawn.bed = snapshot.bed;
    drawn.scale = snapshot.scale;
    // The page needs their names alone, to leave out the folders of this machine.
    if (bed_kind(scene) == BedKind::file)
        drawn.inputs.push_back({bed_path(scene).lexically_normal().string(), ""});
    lay_drape(scene, drawn);
    lay_layers(scene, drawn);
    note = std::move(drawn.note);
    PageRun run;
    run.files.emplace_back(name);
    run.name = std::move(name);
    run.scene = std::move(scene);
    run.inputs = std::move(drawn.inputs);
    run.beds = {{snapshot.step, snapshot.time, ""}};
    run.first = std::move(snapshot);
    run.snapshot = [only = std::make_shared<const Snapshot>(run.first)](std::size_t) {
        return only;
    };
    return run;
}

std::vector<std::size_t> thinned_beds(std::size_t all, std::size_t most) {
    std::vector<std::size_t> numbers;
    if (all == 0 || most == 0) return numbers;
    const std::size_t count = std::min(all, most);
    if (count == 1) return {all - 1};
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back((i * (all - 1) + (count - 1) / 2) / (count - 1));
    return numbers;
}

}  // namespace fumon
