#include "view/sweep/sweep_listing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/csv_table.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_listed_runs = 100'000;

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::string unit_of_key(const std::string& model, const std::string& path) {
    try {
        Scene scene = default_scene(model);
        const KeyTable table = scene_keys(scene);
        const Key* key = table.find(path);
        return key != nullptr ? key->notes.unit : std::string();
    } catch (const InputError&) {
        return {};
    }
}

/// Whether an axis has a table's value: as it was written, "0.10", or the same number.
bool is_value(const std::string& written, const TableColumn& column, std::size_t row) {
    if (written == column.text(row)) return true;
    double number = 0.0;
    const char* const end = written.data() + written.size();
    const auto [last, fault] = std::from_chars(written.data(), end, number);
    return column.words.empty() && fault == std::errc{} && last == end &&
           number == column.values[row];
}

/// Where a table's value stands among those of an axis; none where it is no value of it.
std::optional<std::size_t> place_of(const ListedAxis& axis, const TableColumn& column,
                                    std::size_t row) {
    const auto found = std::ranges::find_if(
        axis.values, [&](const std::string& written) { return is_value(written, column, row); });
    if (found == axis.values.end()) return std::nullopt;
    return static_cast<std::size_t>(found - axis.values.begin());
}

}  // namespace

bool is_sweep_folder(const fs::path& folder) {
    std::error_code fault;
    return fs::is_regular_file(folder / "sweep.json", fault);
}

SweepListing::SweepListing(fs::path folder) : folder_(std::move(folder)) {
    read_manifest();
}

void SweepListing::read_manifest() {
    const fs::path file = folder_ / "sweep.json";
    std::error_code fault;
    const auto written = fs::last_write_time(file, fault);
    std::vector<ListedAxis> axes;
    std::size_t count = 0;
    try {
        const Json json = parse_json(read_input_file(file));
        const Json& scene = json.at("scene");
        title_ = scene.value("title", "");
        const auto model = scene.at("model").at("name").get<std::string>();
        for (const Json& over : json.at("over")) {
            const auto keys = over.at("keys").get<std::vector<std::string>>();
            if (keys.empty()) throw InputError(file.string() + ": an axis without a key");
            axes.push_back({fmt::format("{}", fmt::join(keys, "+")),
                            unit_of_key(model, keys.front()),
                            over.at("values").get<std::vector<std::string>>()});
        }
        const std::int64_t first = whole_number(json.at("seeds").at("first"));
        const std::int64_t last = whole_number(json.at("seeds").at("last"));
        if (last < first || last - first >= static_cast<std::int64_t>(most_listed_runs))
            throw InputError(file.string() + ": seeds that no sweep has");
        if (last > first || axes.empty()) {
            ListedAxis seeds{"seed", "", {}};
            for (std::int64_t seed = first; seed <= last; ++seed)
                seeds.values.push_back(std::to_string(seed));
            axes.push_back(std::move(seeds));
        }
        count = json.at("runs").size();
    } catch (const nlohmann::json::exception&) {
        throw InputError(fmt::format("{}: is damaged, or of no sweep", file.string()));
    }
    if (count > most_listed_runs) throw InputError(file.string() + ": more runs than a sweep has");
    axes_ = std::move(axes);
    runs_.assign(count, {});
    for (std::size_t n = 0; n < count; ++n) runs_[n].number = static_cast<std::int64_t>(n) + 1;
    manifest_written_ = written;
    place_runs();
}

/// By runs.csv; runs that it does not list yet stand as a new sweep numbers them.
void SweepListing::place_runs() {
    for (std::size_t n = 0; n < runs_.size(); ++n) {
        std::size_t rest = n;
        runs_[n].at.assign(axes_.size(), 0);
        for (std::size_t axis = axes_.size(); axis-- > 0;) {
            const std::size_t values = std::max<std::size_t>(1, axes_[axis].values.size());
            runs_[n].at[axis] = rest % values;
            rest /= values;
        }
    }
    const fs::path file = folder_ / "runs.csv";
    std::error_code fault;
    table_written_ = fs::last_write_time(file, fault);
    if (!fs::is_regular_file(file, fault)) return;
    try {
        const Table table = parse_csv_table({file.string(), read_input_file(file)});
        const TableColumn* numbers = table.find("run");
        if (numbers == nullptr) return;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const double number = numbers->values[row];
            if (!(number >= 1.0) || number > static_cast<double>(runs_.size())) continue;
            ListedRun& run = runs_[static_cast<std::size_t>(number) - 1];
            for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
                const std::string& label = axes_[axis].label;
                const TableColumn* column = table.find(label.substr(0, label.find('+')));
                if (column == nullptr) continue;
                if (const auto place = place_of(axes_[axis], *column, row)) run.at[axis] = *place;
            }
        }
    } catch (const InputError&) {
        return;  // it is being written
    }
}

void SweepListing::look_at(ListedRun& run) const {
    const std::string stem = (folder_ / "runs" / fmt::format("{:04}", run.number)).string();
    std::error_code fault;
    run.status = fs::exists(stem + ".lock", fault) ? "running" : "pending";
    if (!fs::exists(stem + ".json", fault)) return;
    try {
        const Json json = parse_json(read_input_file(stem + ".json"));
        run.message = json.value("message", "");
        if (json.value("failed", false)) {
            if (run.status == "pending") run.status = "failed";  // else it is tried again
            return;
        }
        if (json.contains("id")) run.status = "done";
        run.stored = fs::exists(stem + "-fields.nc", fault);
    } catch (const nlohmann::json::exception&) {
        return;
    } catch (const Error&) {
        return;
    }
}

const std::vector<ListedRun>& SweepListing::runs() {
    constexpr double rarely = 50.0;
    const double begin = steady_seconds();
    if (begin < next_look_) return runs_;
    std::error_code fault;
    if (fs::last_write_time(folder_ / "sweep.json", fault) != manifest_written_) {
        try {
            read_manifest();  // the sweep has grown
        } catch (const Error&) {
            return runs_;
        }
    } else if (fs::last_write_time(folder_ / "runs.csv", fault) != table_written_) {
        place_runs();  // a sweep that grows writes it after its manifest, shards at their merge
    }
    for (ListedRun& run : runs_)
        if (run.status != "done") look_at(run);
    const double end = steady_seconds();
    next_look_ = end + std::max(1.0, rarely * (end - begin));
    return runs_;
}

}  // namespace fumon
