#include "view/subject/computed_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "measure/suite.h"
#include "run/recorder.h"
#include "run/still.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

std::vector<std::int64_t> moments_of(const Snapshot& first, std::int64_t steps) {
    constexpr double most_bytes = 2147483648.0;
    const double bytes =
        static_cast<double>(first.bed.size()) * 8.0 * static_cast<double>(1 + first.fields.size());
    const auto affordable = static_cast<std::int64_t>(std::max(2.0, most_bytes / bytes));
    const std::int64_t count =
        std::min({affordable, static_cast<std::int64_t>(most_computed_moments), steps + 1});
    std::vector<std::int64_t> moments;
    for (std::int64_t i = 0; i < count; ++i)
        moments.push_back(count == 1 ? 0 : steps * i / (count - 1));
    return moments;
}

class ComputedSubject : public ViewSubject {
  public:
    ComputedSubject(std::string name, PreparedRun run, std::vector<fs::path> files)
        : name_(std::move(name)),
          files_(std::move(files)),
          run_(std::move(run)),
          first_(std::make_shared<const Snapshot>(run_.model->snapshot())),
          steps_(moments_of(*first_, run_.scene.run.steps)),
          suite_(measured_landform(*first_), *first_, recorded_measures(run_.scene)) {
        const std::vector<MeasureColumn> columns = measured_columns(suite_.columns(), *first_);
        for (const MeasureColumn& column : columns) names_.emplace_back(column.name);
        gathered_ = std::make_unique<RowGatherer>(names_, suite_.columns(), *first_);
        keep(first_);
        thread_ = std::thread([this] { compute(); });
    }

    ~ComputedSubject() override {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        wake_.notify_all();
        thread_.join();
    }

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] const Scene& scene() const override { return run_.scene; }
    [[nodiscard]] const std::vector<InputFile>& inputs() const override {
        return run_.initial.inputs;
    }
    [[nodiscard]] const Snapshot& first() const override { return *first_; }

    [[nodiscard]] std::vector<ShownMoment> moments() override {
        const std::lock_guard lock(mutex_);
        std::vector<ShownMoment> all;
        const double last = kept_.back()->time;
        const double each =
            kept_.back()->step > 0 ? last / static_cast<double>(kept_.back()->step) : 0.0;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const bool ready = i < kept_.size();
            all.push_back(
                {steps_[i], ready ? kept_[i]->time : each * static_cast<double>(steps_[i]), ready});
        }
        return all;
    }

    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::size_t number) override {
        if (number >= steps_.size())
            throw InputError(fmt::format("moment {}: there are {}", number, steps_.size()));
        const std::lock_guard lock(mutex_);
        if (number < kept_.size()) return kept_[number];
        if (!fault_.empty()) throw InputError(fault_);
        wanted_ = std::max(wanted_, number);
        wake_.notify_all();
        return nullptr;
    }

    [[nodiscard]] MeasuredRows rows(const std::vector<std::string>& columns,
                                    std::size_t number) override {
        if (columns.empty()) return {};
        const std::lock_guard lock(mutex_);
        return plotted_.at(number);
    }

    [[nodiscard]] std::vector<ViewColumn> measurements() override {
        const std::lock_guard lock(mutex_);
        std::vector<ViewColumn> columns;
        for (const MeasuredColumn& column : gathered_->rows().columns) {
            const double* values = column.values.data();
            columns.push_back({std::string(column.column.name), std::string(column.column.unit),
                               std::vector<double>(values, values + column.values.size())});
        }
        return columns;
    }

    [[nodiscard]] ViewWork work() override {
        const std::lock_guard lock(mutex_);
        ViewWork work{"computed", step_, steps_[wanted_], 0.0, fault_};
        if (kept_.size() <= wanted_ && fault_.empty()) {
            work.state = "computing";
            const double seconds = watch_.seconds();
            if (seconds > 0.0)
                work.cell_steps_per_second = static_cast<double>(first_->bed.size()) *
                                             static_cast<double>(step_ - step_before_) / seconds;
        }
        return work;
    }

    [[nodiscard]] std::vector<fs::path> files() const override { return files_; }

  private:
    /// The mutex is held, or the thread does not run yet.
    void keep(std::shared_ptr<const Snapshot> snapshot) {
        gathered_->take(*snapshot, suite_.row(*snapshot));
        plotted_.push_back(run_.plotted ? run_.plotted->rows() : MeasuredRows{});
        kept_.push_back(std::move(snapshot));
    }

    void compute() {
        std::unique_lock lock(mutex_);
        for (;;) {
            wake_.wait(lock, [&] { return ended_ || wanted_ >= kept_.size(); });
            if (ended_) return;
            const std::int64_t target = steps_[kept_.size()];
            step_before_ = step_;
            watch_ = {};
            lock.unlock();
            std::string fault;
            std::shared_ptr<const Snapshot> reached;
            try {
                const int signal = advance(run_,
                                           [&](const Model& model) {
                                               step_ = model.steps_done();
                                               return ended_ || model.steps_done() >= target;
                                           },
                                           {});
                if (signal != 0) fault = "fumon was asked to stop";
                reached = std::make_shared<const Snapshot>(run_.model->snapshot());
            } catch (const std::exception& refusal) {
                fault = refusal.what();
            }
            lock.lock();
            if (ended_) return;
            try {
                if (fault.empty()) keep(std::move(reached));
            } catch (const std::exception& refusal) {
                fault = refusal.what();
            }
            if (!fault.empty()) {
                fault_ = fault;
                wanted_ = kept_.size() - 1;
            }
        }
    }

    std::string name_;
    std::vector<fs::path> files_;
    PreparedRun run_;
    std::shared_ptr<const Snapshot> first_;
    std::vector<std::int64_t> steps_;  ///< of the moments
    MeasureSuite suite_;
    std::vector<std::string> names_;

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<std::shared_ptr<const Snapshot>> kept_;
    std::vector<MeasuredRows> plotted_;
    std::unique_ptr<RowGatherer> gathered_;
    std::size_t wanted_ = 0;
    std::string fault_;
    Stopwatch watch_;
    std::int64_t step_before_ = 0;
    std::atomic<std::int64_t> step_{0};
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

}  // namespace

std::unique_ptr<ViewSubject> computed_subject(std::string name, PreparedRun run,
                                              std::vector<fs::path> files) {
    return std::make_unique<ComputedSubject>(std::move(name), std::move(run), std::move(files));
}

}  // namespace fumon
