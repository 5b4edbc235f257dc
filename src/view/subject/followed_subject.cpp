#include "view/subject/followed_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/input_file.h"
#include "files/json_text.h"
#include "files/netcdf/netcdf_record.h"
#include "film/beds/stored_beds.h"
#include "run/prepared_run.h"
#include "view/subject/stored_subject.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds poll_interval{1000};
/// What takes a second is done again after so many seconds: folders of other machines are slow.
constexpr int rarely = 50;

/// What run.json says now; nothing of it is needed.
Json manifest_of(const fs::path& folder) {
    try {
        return parse_json(read_input_file(folder / "run.json"));
    } catch (const Error&) {
        return Json::object();
    }
}

std::string state_in(const Json& manifest) {
    const bool says =
        manifest.is_object() && manifest.contains("status") && manifest["status"].is_string();
    return says ? manifest["status"].get<std::string>() : "unknown";
}

/// The step in "bed_00000100.asc"; none of any other name.
std::optional<std::int64_t> step_of_bed(const fs::path& file) {
    const std::string stem = file.stem().string();
    constexpr std::string_view begin = "bed_";
    const bool named = stem.starts_with(begin) && stem.size() > begin.size() &&
                       stem.find_first_not_of("0123456789", begin.size()) == std::string::npos;
    const bool whole = file.extension() == ".asc" || file.extension() == ".tif";
    constexpr std::size_t most_digits = 18;
    if (!named || !whole || stem.size() > begin.size() + most_digits) return std::nullopt;
    return std::stoll(stem.substr(begin.size()));
}

class FollowedSubject : public ViewSubject {
  public:
    /// `watch`: nullptr where another program computes the run.
    FollowedSubject(fs::path folder, Scene scene, std::vector<InputFile> inputs, Snapshot first,
                    JobWatch* watch)
        : folder_(std::move(folder)),
          scene_(std::move(scene)),
          inputs_(std::move(inputs)),
          first_(std::make_shared<const Snapshot>(std::move(first))),
          watch_(watch) {
        look();
    }

    [[nodiscard]] std::string name() const override { return folder_.string(); }
    [[nodiscard]] const Scene& scene() const override { return scene_; }
    [[nodiscard]] const std::vector<InputFile>& inputs() const override { return inputs_; }
    [[nodiscard]] const Snapshot& first() const override { return *first_; }

    [[nodiscard]] std::vector<ShownMoment> moments() override {
        const std::lock_guard lock(mutex_);
        look_again();
        std::vector<ShownMoment> all;
        for (const auto& [step, bed] : beds_) all.push_back({step, bed.time});
        if (watch_ != nullptr) watch_->ask_for_snapshot();
        if (const auto newest = newest_snapshot()) all.push_back({newest->step, newest->time});
        return all;
    }

    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::size_t number) override {
        const std::lock_guard lock(mutex_);
        if (number == beds_.size()) {
            if (auto newest = newest_snapshot()) return newest;
            if (watch_ != nullptr) --number;  // a bed is there of it meanwhile
        }
        if (number >= beds_.size())
            throw InputError(fmt::format("moment {}: there are {}", number, beds_.size()));
        const auto bed = std::next(beds_.begin(), static_cast<std::ptrdiff_t>(number));
        if (kept_ && kept_->step == bed->first) return kept_;
        kept_ = std::make_shared<const Snapshot>(read(bed->first, bed->second));
        return kept_;
    }

    /// Of a run that goes on plots stay empty.
    [[nodiscard]] MeasuredRows rows(const std::vector<std::string>& /*columns*/,
                                    std::size_t /*number*/) override {
        return {};
    }

    [[nodiscard]] std::vector<ViewColumn> measurements() override {
        const std::lock_guard lock(mutex_);
        return measured();
    }

    [[nodiscard]] ViewWork work() override {
        const std::lock_guard lock(mutex_);
        look_again();
        std::int64_t step = beds_.rbegin()->first;
        for (const ViewColumn& column : measured()) {
            if (column.name == "step" && !column.values.empty())
                step = std::max(step, static_cast<std::int64_t>(column.values.back()));
        }
        return {state_, step, scene_.run.steps};
    }

    [[nodiscard]] std::vector<fs::path> files() const override {
        return {folder_ / "run.json", folder_ / "measurements.csv", folder_ / "fields.nc"};
    }

  private:
    struct Bed {
        double time = 0.0;
        fs::path file{};  ///< empty: the first bed of all
        bool fields = false;
    };

    struct PieceMoments {
        fs::file_time_type written{};
        std::vector<FieldsMoment> moments{};
    };

    /// Read again when fifty times the time has passed that it took. A file may have got its name
    /// meanwhile.
    const std::vector<ViewColumn>& measured() {
        const auto now = Clock::now();
        if (now < next_measured_) return measured_;
        measured_ = read_measured();
        next_measured_ = Clock::now() + rarely * (Clock::now() - now);
        return measured_;
    }

    [[nodiscard]] std::vector<ViewColumn> read_measured() const {
        try {
            std::vector<ViewColumn> columns = measurements_of(folder_ / "measurements.csv");
            if (columns.empty()) columns = measurements_of(folder_ / "measurements.csv.part");
            return columns;
        } catch (const InputError&) {
            return {};
        }
    }

    /// The newest state where it is newer than all beds.
    [[nodiscard]] std::shared_ptr<const Snapshot> newest_snapshot() const {
        auto newest = watch_ != nullptr ? watch_->snapshot() : nullptr;
        return newest && newest->step > beds_.rbegin()->first ? newest : nullptr;
    }

    void look_again() {
        if (Clock::now() >= next_look_) look();
    }

    void look() {
        const Clock::time_point begin = Clock::now();
        state_ = state_in(manifest_of(folder_));
        std::map<std::int64_t, Bed> beds{{first_->step, Bed{first_->time}}};
        add_files(beds);
        add_fields(beds);
        beds_ = std::move(beds);
        const Clock::time_point end = Clock::now();
        next_look_ = end + std::max<Clock::duration>(poll_interval, rarely * (end - begin));
    }

    void add_files(std::map<std::int64_t, Bed>& beds) const {
        std::error_code fault;
        for (const auto& entry : fs::directory_iterator(folder_ / "beds", fault)) {
            if (const auto step = step_of_bed(entry.path()))
                beds.insert_or_assign(*step, Bed{static_cast<double>(*step), entry.path()});
        }
    }

    /// Those of the whole file, or of its pieces, which are not written to again.
    void add_fields(std::map<std::int64_t, Bed>& beds) {
        std::error_code fault;
        for (const auto& entry : fs::directory_iterator(folder_, fault)) {
            const std::string name = entry.path().filename().string();
            const bool whole = name == "fields.nc";
            const bool piece = name.starts_with("fields.nc.") && name.size() > 10 &&
                               name.find_first_not_of("0123456789", 10) == std::string::npos;
            if (!whole && !piece) continue;
            // A run that is resumed writes these names again.
            const auto written = entry.last_write_time(fault);
            PieceMoments& known = moments_[name];
            try {
                if (known.moments.empty() || known.written != written)
                    known = {written, read_fields_moments(entry.path())};
            } catch (const Error&) {
                continue;  // joined meanwhile
            }
            for (const FieldsMoment& moment : known.moments)
                beds.insert_or_assign(moment.step, Bed{moment.time, entry.path(), true});
        }
    }

    [[nodiscard]] Snapshot read(std::int64_t step, const Bed& bed) const {
        if (bed.file.empty()) return *first_;
        if (bed.fields) return read_fields_snapshot(bed.file, step, *first_);
        Snapshot snapshot = read_stored_bed(scene_, bed.file, *first_);
        snapshot.step = step;
        snapshot.time = bed.time;
        return snapshot;
    }

    fs::path folder_;
    Scene scene_;
    std::vector<InputFile> inputs_;
    std::shared_ptr<const Snapshot> first_;
    JobWatch* watch_;
    std::mutex mutex_;
    std::map<std::int64_t, Bed> beds_;             ///< by their steps
    std::map<std::string, PieceMoments> moments_;  ///< by the names of their files
    std::shared_ptr<const Snapshot> kept_;
    std::string state_;
    Clock::time_point next_look_{};
    std::vector<ViewColumn> measured_;
    Clock::time_point next_measured_{};
};

}  // namespace

bool is_unfinished_run(const fs::path& folder) {
    return state_in(manifest_of(folder)) != "complete";
}

std::unique_ptr<ViewSubject> followed_subject(const fs::path& folder, int threads,
                                              const std::vector<std::string>& settings) {
    PreparedRun run = prepare_run(scene_of_run(folder, settings), threads);
    Snapshot first = run.model->snapshot();
    return std::make_unique<FollowedSubject>(
        folder, std::move(run.scene), std::move(run.initial.inputs), std::move(first), nullptr);
}

std::unique_ptr<ViewSubject> watched_subject(const fs::path& folder, Scene scene,
                                             std::vector<InputFile> inputs, const Snapshot& first,
                                             JobWatch& watch) {
    return std::make_unique<FollowedSubject>(folder, std::move(scene), std::move(inputs), first,
                                             &watch);
}

}  // namespace fumon
