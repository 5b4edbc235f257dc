#include "view/subject/stored_subject.h"

#include <fmt/format.h>

#include <mutex>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/csv_table.h"
#include "files/input_file.h"
#include "film/beds/results_text.h"
#include "film/beds/stored_beds.h"
#include "outputs/output_claims.h"

namespace fumon {

namespace fs = std::filesystem;

std::vector<ViewColumn> measurements_of(const fs::path& file) {
    std::error_code fault;
    if (!fs::is_regular_file(file, fault)) return {};
    std::string text = read_input_file(file);
    text.erase(text.rfind('\n') + 1);
    if (text.find('\n') == std::string::npos) return {};
    Table table = parse_csv_table({file.string(), text});
    std::vector<ViewColumn> columns;
    for (TableColumn& column : table.columns)
        if (column.words.empty())
            columns.push_back({column.name, column.unit, std::move(column.values)});
    return columns;
}

namespace {

class StoredSubject : public ViewSubject {
  public:
    StoredSubject(StoredBeds beds, fs::path measurements)
        : measurements_(std::move(measurements)), beds_(std::move(beds)) {}

    [[nodiscard]] std::string name() const override { return beds_.name(); }
    [[nodiscard]] const Scene& scene() const override { return beds_.scene(); }
    [[nodiscard]] const std::vector<InputFile>& inputs() const override { return beds_.inputs(); }
    [[nodiscard]] std::string results() const override { return results_text(beds_); }
    [[nodiscard]] const Snapshot& first() const override { return beds_.first(); }

    [[nodiscard]] std::vector<ShownMoment> moments() override {
        std::vector<ShownMoment> all;
        for (const StoredBed& bed : beds_.beds()) all.push_back({bed.step, bed.time});
        return all;
    }

    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::size_t number) override {
        if (number >= beds_.beds().size())
            throw InputError(fmt::format("moment {}: there are {}", number, beds_.beds().size()));
        const std::lock_guard lock(mutex_);
        return beds_.snapshot(number);
    }

    [[nodiscard]] MeasuredRows rows(const std::vector<std::string>& columns,
                                    std::size_t number) override {
        const std::lock_guard lock(mutex_);
        return beds_.measurements(columns).at(number);
    }

    [[nodiscard]] std::vector<ViewColumn> measurements() override {
        return measurements_of(measurements_);
    }

    [[nodiscard]] ViewWork work() override {
        const std::int64_t last = beds_.beds().back().step;
        return {"complete", last, last};
    }

    [[nodiscard]] std::vector<fs::path> files() const override { return beds_.files(); }

  private:
    fs::path measurements_;
    std::mutex mutex_;  ///< of what keeps beds
    StoredBeds beds_;
};

}  // namespace

std::unique_ptr<ViewSubject> stored_subject(const fs::path& folder, int threads,
                                            const std::vector<std::string>& settings) {
    return stored_subject(StoredBeds(folder, threads, settings), folder / "measurements.csv");
}

std::unique_ptr<ViewSubject> stored_subject(StoredBeds beds, fs::path measurements) {
    return std::make_unique<StoredSubject>(std::move(beds), std::move(measurements));
}

std::unique_ptr<ViewSubject> foreign_subject(const std::string& argument, int threads,
                                             const std::vector<std::string>& settings) {
    const std::string ending = small_ending(argument);
    const bool several = argument.find_first_of("*?") != std::string::npos;
    if (!several && ending != ".nc" && ending != ".nc4") return nullptr;
    try {
        StoredBeds beds = StoredBeds::of_files(argument, threads, settings);
        if (several || beds.beds().size() > 1) return stored_subject(std::move(beds), {});
    } catch (const InputError&) {
        if (several) throw;
    }
    return nullptr;
}

}  // namespace fumon
