#include "sweep/sweep_folder.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/csv_table.h"
#include "files/input_file.h"
#include "run/run_folder.h"
#include "sweep/sweep_manifest.h"
#include "sweep/sweep_table.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

const char* status_name(RunStatus status) {
    switch (status) {
        case RunStatus::done:
            return "done";
        case RunStatus::failed:
            return "failed";
        default:
            return "pending";
    }
}

/// Whether a name is one of ours: 0001.csv, 0001-fields.nc, 0001.json.part …
bool is_run_file(const std::string& name) {
    const std::size_t digits = name.find_first_not_of("0123456789");
    constexpr std::size_t fewest_digits = 4;
    if (digits == std::string::npos || digits < fewest_digits) return false;
    std::string end = name.substr(digits);
    if (end.ends_with(".part")) end.resize(end.size() - std::string(".part").size());
    return end == ".csv" || end == ".json" || end == "-avalanches.csv" || end == "-fields.nc";
}

}  // namespace

SweepFolder::SweepFolder(fs::path folder, const SweepPlan& plan, bool force)
    : folder_(std::move(folder)), plan_(plan) {
    std::error_code fault;
    const bool there = fs::exists(folder_, fault);
    if (there && !fs::is_directory(folder_, fault)) {
        throw InputError(
            fmt::format("{} is a file; name a folder for the sweep with -o", folder_.string()));
    }
    if (there) lock_.emplace(folder_);
    if (there && !force) number_runs();
    make_folder(folder_ / "runs");
    if (!there) lock_.emplace(folder_);
    if (force) clear();
    if (order_.empty()) {
        for (std::size_t k = 0; k < plan_.runs.size(); ++k) order_.push_back(k);
    }
    write_manifest();
}

/// Runs that the folder's sweep knows keep their numbers; others follow in the plan's order.
void SweepFolder::number_runs() {
    if (!fs::exists(manifest())) return;
    std::map<std::string, std::size_t> planned;
    for (std::size_t k = 0; k < plan_.runs.size(); ++k) planned[hex(plan_.runs[k].id)] = k;
    std::string differs;
    try {
        const auto former = nlohmann::ordered_json::parse(read_input_file(manifest()));
        for (const std::string& id : run_ids(former)) {
            const auto found = planned.find(id);
            if (found == planned.end() || former.at("fumon") != FUMON_VERSION) {
                differs = "holds another sweep: " + difference(former, plan_);
                break;
            }
            order_.push_back(found->second);
            planned.erase(found);
        }
    } catch (const nlohmann::json::exception&) {
        differs = "holds a sweep whose sweep.json is damaged";
    }
    if (!differs.empty()) {
        throw InputError(fmt::format("{} {}; name another folder, or --force replaces it",
                                     folder_.string(), differs));
    }
    for (std::size_t k = 0; k < plan_.runs.size(); ++k) {
        if (planned.contains(hex(plan_.runs[k].id))) order_.push_back(k);
    }
}

void SweepFolder::clear() const {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder_ / "runs", fault)) {
        if (is_run_file(entry.path().filename().string())) fs::remove(entry.path(), fault);
    }
    for (const char* name : {"sweep.csv", "runs.csv", "sweep.json"})
        fs::remove(folder_ / name, fault);
}

void SweepFolder::write_manifest() const {
    write_file(manifest(), sweep_manifest(plan_, order_));
}

fs::path SweepFolder::file(std::size_t number, const char* end) const {
    return folder_ / "runs" / fmt::format("{:04}{}", number, end);
}

RecordPaths SweepFolder::paths(std::size_t number) const {
    return {file(number, ".csv"), file(number, "-avalanches.csv"), file(number, "-fields.nc")};
}

RunRecord SweepFolder::read_record(std::size_t number) const {
    const fs::path record = file(number, ".json");
    if (!fs::exists(record) || !fs::exists(paths(number).measurements)) return {};
    try {
        const auto json = nlohmann::json::parse(read_input_file(record));
        if (json.at("id") != hex(run(number).id)) return {};
        return {RunStatus::done, json.at("steps"), json.at("wall_seconds"), json.at("state_sha256"),
                ""};
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

void SweepFolder::write_record(std::size_t number, const RunRecord& record) const {
    nlohmann::ordered_json json;
    json["id"] = hex(run(number).id);
    json["steps"] = record.steps;
    json["wall_seconds"] = record.wall_seconds;
    json["state_sha256"] = record.state;
    write_file(file(number, ".json"), json.dump(2) + "\n");
}

void SweepFolder::write_runs(const std::vector<RunRecord>& records) const {
    std::vector<std::string> header{"run"};
    for (const std::string& key : varied_keys(plan_)) header.push_back(key);
    for (const char* name : {"seed", "status", "steps", "wall_seconds", "state_sha256", "message"})
        header.emplace_back(name);
    std::string text = csv_line(header);
    for (std::size_t number = 1; number <= records.size(); ++number) {
        const RunRecord& record = records[number - 1];
        const bool begun = record.status != RunStatus::pending;
        std::vector<std::string> cells{fmt::format("{}", number)};
        for (std::string& value : values_of(plan_, run(number))) cells.push_back(std::move(value));
        cells.push_back(fmt::format("{}", run(number).seed));
        cells.emplace_back(status_name(record.status));
        cells.push_back(begun ? fmt::format("{}", record.steps) : "");
        cells.push_back(begun ? fmt::format("{:.3f}", record.wall_seconds) : "");
        cells.push_back(record.state);
        cells.push_back(record.message);
        text += csv_line(cells);
    }
    write_file(folder_ / "runs.csv", text);
}

void SweepFolder::write_table(const std::vector<RunRecord>& records) const {
    std::vector<std::string> names{"run"};
    for (const std::string& key : varied_keys(plan_)) names.push_back(key);
    names.emplace_back("seed");
    std::vector<TablePart> parts;
    for (std::size_t number = 1; number <= records.size(); ++number) {
        const RunStatus status = records[number - 1].status;
        const bool measured =
            status == RunStatus::done ||
            (status == RunStatus::failed && std::filesystem::exists(paths(number).measurements));
        if (!measured) continue;
        std::vector<std::string> cells{fmt::format("{}", number)};
        for (std::string& value : values_of(plan_, run(number))) cells.push_back(std::move(value));
        cells.push_back(fmt::format("{}", run(number).seed));
        parts.push_back({std::move(cells), paths(number).measurements});
    }
    fumon::write_table(table(), names, parts);
}

}  // namespace fumon
