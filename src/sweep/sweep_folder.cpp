#include "sweep/sweep_folder.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <chrono>
#include <thread>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/csv_table.h"
#include "files/file_lock.h"
#include "files/input_file.h"
#include "outputs/output_claims.h"
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

constexpr const char* lock_end = ".lock";
/// Of the files of a run: the record comes last.
constexpr std::array<const char*, 5> run_file_ends{".csv", "-avalanches.csv", "-fields.nc", ".json",
                                                   lock_end};

/// Shards begin at the same time, each waiting while another one writes sweep.json.
constexpr std::chrono::seconds longest_wait{60};

/// Holds a lock file, waiting for it.
class WaitedLock {
  public:
    explicit WaitedLock(const fs::path& file) {
        const auto end = std::chrono::steady_clock::now() + longest_wait;
        do {
            lock_.emplace(file);
            if (lock_->held()) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        } while (std::chrono::steady_clock::now() < end);
        throw InputError(
            fmt::format("another fumon has held {} for {} s; wait for it or name another folder",
                        file.string(), longest_wait.count()));
    }

  private:
    std::optional<FileLock> lock_;
};

/// The number of the run that a file is called as one of, 0001.csv, 0001-fields.nc, 0001.json.part
/// …; −1 of any other.
std::int64_t number_of_run(std::string_view name) {
    constexpr std::string_view temporary = ".part";
    if (name.ends_with(temporary)) name.remove_suffix(temporary.size());
    for (const std::string_view end : run_file_ends) {
        if (!name.ends_with(end)) continue;
        const std::string_view digits = name.substr(0, name.size() - end.size());
        std::int64_t number = -1;
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (number > 0 && fmt::format("{:04}", number) == digits) return number;
    }
    return -1;
}

}  // namespace

SweepFolder::SweepFolder(fs::path folder, const SweepPlan& plan, bool force)
    : folder_(std::move(folder)), plan_(plan) {
    open(force, 0, true);
}

SweepFolder::SweepFolder(fs::path folder, const SweepPlan& plan, int shards, Use use)
    : folder_(std::move(folder)), plan_(plan) {
    if (use != Use::shard) {
        open(false, shards, true, use == Use::last_shard ? longest_wait : std::chrono::seconds{});
        return;
    }
    check_output_folder(folder_, "the sweep");
    make_folder(folder_);
    lock_.emplace(folder_, longest_wait);
    {
        const WaitedLock among_machines(folder_ / "sweep.lock");
        open(false, shards, false);
    }
    lock_.reset();
}

void SweepFolder::open(bool force, int shards, bool alone, std::chrono::seconds wait) {
    std::error_code fault;
    check_output_folder(folder_, "the sweep");
    if (fs::exists(folder_ / "runs", fault)) check_output_folder(folder_ / "runs", "the sweep");
    const bool there = fs::exists(folder_, fault);
    if (there && alone) lock_.emplace(folder_, wait);
    if (there && force) refuse_while_runs_are_made();
    if (there && !force) number_runs();
    const std::vector<fs::path> previous = previous_files(force);
    make_folder(folder_ / "runs");
    if (!there) lock_.emplace(folder_);
    if (force) remove_files(previous);
    if (order_.empty()) {
        for (std::size_t k = 0; k < plan_.runs.size(); ++k) order_.push_back(k);
    }
    write_manifest(shards);
}

void SweepFolder::refuse_while_runs_are_made() const {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder_ / "runs", fault)) {
        if (entry.path().extension() != lock_end) continue;
        if (number_of_run(entry.path().filename().string()) < 0) continue;
        if (FileLock(entry.path()).held()) continue;  // left by a program that was killed
        throw InputError(
            fmt::format("another fumon is working in {}; wait for it or name another folder",
                        folder_.string()));
    }
}

/// Runs that the folder's sweep knows keep their numbers; others follow in the plan's order.
void SweepFolder::number_runs() {
    if (!fs::exists(manifest())) return;
    PreviousSweep previous = previous_sweep(read_input_file(manifest()), plan_);
    if (!previous.differs.empty()) {
        throw InputError(fmt::format("{} {}; name another folder, or replace it with --force",
                                     folder_.string(), previous.differs));
    }
    order_ = std::move(previous.order);
    std::vector<bool> numbered(plan_.runs.size(), false);
    for (const std::size_t k : order_) numbered[k] = true;
    for (std::size_t k = 0; k < numbered.size(); ++k) {
        if (!numbered[k]) order_.push_back(k);
    }
}

std::int64_t SweepFolder::listed() const {
    try {
        return listed_runs(read_input_file(manifest()));
    } catch (const InputError&) {
        return -1;  // there is none
    }
}

std::vector<fs::path> SweepFolder::previous_files(bool force) const {
    const std::int64_t listed = this->listed();
    const auto planned = static_cast<std::int64_t>(plan_.runs.size());
    OutputClaims claims(force);
    claims.reads(plan_.scene.source);
    for (const InputFile& input : plan_.inputs) claims.reads(input.path);
    std::vector<fs::path> files;
    const auto add = [&](const fs::path& file, bool is_listed, bool is_planned) {
        if (!is_listed && !force) refuse_to_replace(file);
        if (!is_listed && !is_planned) return;
        claims.check(file, true);
        files.push_back(file);
    };
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder_ / "runs", fault)) {
        const std::int64_t number = number_of_run(entry.path().filename().string());
        if (number > 0) add(entry.path(), number <= listed, number <= planned);
    }
    for (const char* name : {"runs.csv", "sweep.csv", "sweep.json"}) {
        for (const fs::path& file : {folder_ / name, temporary_name(folder_ / name)}) {
            if (fs::exists(fs::symlink_status(file, fault))) add(file, listed >= 0, true);
        }
    }
    return files;
}

void SweepFolder::remove_files(const std::vector<fs::path>& files) const {
    std::error_code fault;
    const bool is_linked = fs::is_symlink(folder_ / "runs", fault);
    for (const fs::path& file : files) {
        if (!is_linked || file.parent_path().filename() != "runs") fs::remove(file, fault);
    }
}

void SweepFolder::write_manifest(int shards) const {
    const std::string text = sweep_manifest(plan_, order_, shards);
    if (shards > 0 && fs::exists(manifest()) && read_input_file(manifest()) == text) return;
    write_file(manifest(), text);
}

void SweepFolder::end_sharing() const {
    write_manifest(0);
}

fs::path SweepFolder::file(std::size_t number, const char* end) const {
    return folder_ / "runs" / fmt::format("{:04}{}", number, end);
}

RecordPaths SweepFolder::paths(std::size_t number) const {
    return {file(number, ".csv"), file(number, "-avalanches.csv"), file(number, "-fields.nc")};
}

fs::path SweepFolder::run_lock(std::size_t number) const {
    return file(number, lock_end);
}

RunRecord SweepFolder::read_record(std::size_t number) const {
    const fs::path text = file(number, ".json");
    if (!fs::exists(text)) return {};
    RunRecord record = parse_run_record(read_input_file(text), run(number).id);
    if (record.status == RunStatus::done && !fs::exists(paths(number).measurements)) return {};
    return record;
}

void SweepFolder::import_run(std::size_t number, const fs::path& from,
                             std::size_t number_there) const {
    for (const char* end : run_file_ends) {
        if (end == lock_end) continue;
        const fs::path there = from / "runs" / fmt::format("{:04}{}", number_there, end);
        std::error_code fault;
        if (fs::exists(there, fault)) {
            copy_whole(there, file(number, end));
        } else {
            fs::remove(file(number, end), fault);
        }
    }
}

void SweepFolder::write_record(std::size_t number, const RunRecord& record) const {
    write_file(file(number, ".json"), run_record_text(run(number).id, record));
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
