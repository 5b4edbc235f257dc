#include "paper/store/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "files/hash.h"
#include "foreign/open_run.h"
#include "scene/initial_bed.h"
#include "scene/json.h"

namespace fumon {

namespace {

constexpr std::array<std::string_view, 4> result_endings{".nc", ".nc4", ".cdf", ".sww"};
constexpr std::size_t most_records = 200;

}  // namespace

bool names_results(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".toml") return false;
    return std::ranges::find(result_endings, ending) != result_endings.end() ||
           is_foreign_run(file.string());
}

std::string scene_of_results(const std::string& name) {
    return fmt::format("[model]\nname = \"static\"\n[bed]\nkind = \"file\"\nfile = {}\n",
                       json_text(nlohmann::ordered_json(name)));
}

std::shared_ptr<const ForeignRun> open_results(const Scene& scene, const std::string& field) {
    ForeignQuery query;
    if (field != "bed" && field != "change") query.scalars.push_back(field);
    const LookSettings& look = scene.view.look;
    if (look.colour_by == Colouring::field) query.scalars.push_back(look.field);
    const std::filesystem::path file = bed_path(scene);
    const std::string name = file.lexically_normal().string();
    if (!is_foreign_run(name))
        throw InputError(fmt::format("{}: there is no such file of results", name));
    ForeignRun results = open_foreign_run(name, query);
    if (results.files.size() != 1)
        throw InputError(fmt::format("{}: is {} files; a figure takes results that are one file",
                                     results.name, results.files.size()));
    return std::make_shared<const ForeignRun>(std::move(results));
}

PreparedScene prepare_results(Scene scene, const ForeignRun& results) {
    const Snapshot first = foreign_snapshot(results, 0);
    InitialBed initial;
    initial.bed = first.bed;
    initial.nodata = first.nodata;
    initial.scale = first.scale;
    initial.inputs.push_back(
        {results.files.front().string(), hex(file_hash(results.files.front()))});
    scene.run.steps = results.times.steps.back();
    return prepare_scene(std::move(scene), std::move(initial));
}

std::vector<std::int64_t> steps_of_results(const ForeignRun& results, std::int64_t every) {
    const std::vector<std::int64_t>& all = results.times.steps;
    const std::size_t stride = std::max<std::size_t>(1, all.size() / most_records);
    std::vector<std::int64_t> steps;
    for (std::size_t record = 0; record < all.size(); ++record) {
        const bool shown = every > 0 ? all[record] % every == 0 : record % stride == 0;
        if (shown) steps.push_back(all[record]);
    }
    return steps;
}

Snapshot snapshot_of_results(const ForeignRun& results, std::int64_t step) {
    const std::vector<std::int64_t>& steps = results.times.steps;
    const auto found = std::ranges::lower_bound(steps, std::max(step, steps.front()));
    if (found == steps.end() || *found != std::max(step, steps.front()))
        throw InputError(
            fmt::format("{}: has no record of step {}; its {} records are of steps "
                        "{} to {}",
                        results.name, step, steps.size(), steps.front(), steps.back()));
    return foreign_snapshot(results, static_cast<std::size_t>(found - steps.begin()));
}

}  // namespace fumon
