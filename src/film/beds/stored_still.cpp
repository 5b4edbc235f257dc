#include "film/beds/stored_still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>

#include "base/error.h"

namespace fumon {

namespace fs = std::filesystem;

std::optional<fs::path> run_folder_of(const fs::path& input) {
    std::error_code fault;
    const auto is_run = [&](const fs::path& folder) {
        return fs::is_regular_file(folder / "run.json", fault);
    };
    if (fs::is_directory(input, fault)) {
        if (is_run(input)) return input;
        return std::nullopt;
    }
    const fs::path folder = input.has_parent_path() ? input.parent_path() : fs::path(".");
    if (input.filename() == "fields.nc" && is_run(folder)) return folder;
    return std::nullopt;
}

std::size_t bed_of_step(const StoredBeds& beds, std::int64_t step) {
    const std::vector<StoredBed>& stored = beds.beds();
    const auto after = std::ranges::lower_bound(stored, step, {}, &StoredBed::step);
    if (after != stored.end() && after->step == step)
        return static_cast<std::size_t>(after - stored.begin());
    if (beds.foreign_query())
        throw InputError(
            fmt::format("{}: has no record of step {}; it has those of the steps {} to {}",
                        beds.name(), step, stored.front().step, stored.back().step));
    std::string nearest;
    if (after != stored.begin()) nearest = fmt::format("{}", (after - 1)->step);
    if (after != stored.end())
        nearest += fmt::format("{}{}", nearest.empty() ? "" : " and ", after->step);
    throw InputError(fmt::format(
        "{}: stored no bed of step {}, the nearest are of {}; take one of those, or draw the scene "
        "(fumon still SCENE --step {}), which computes the step",
        beds.name(), step, nearest, step));
}

std::size_t bed_of_time(const StoredBeds& beds, double time) {
    const auto distance = [&](const StoredBed& bed) { return std::abs(bed.time - time); };
    return static_cast<std::size_t>(std::ranges::min_element(beds.beds(), {}, distance) -
                                    beds.beds().begin());
}

}  // namespace fumon
