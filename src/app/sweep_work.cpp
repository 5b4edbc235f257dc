#include "app/sweep_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/check_finite.h"
#include "app/interrupt.h"
#include "app/manifest.h"
#include "app/picture_text.h"
#include "app/progress.h"
#include "app/recorder.h"
#include "app/workshop.h"
#include "support/error.h"
#include "support/thread_clock.h"

namespace fumon {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// The pending runs under way: threads that take one after the other.
class Work {
  public:
    Work(const SweepPlan& plan, const SweepFolder& folder, std::vector<RunRecord>& records)
        : plan_(plan), folder_(folder), records_(records) {
        for (std::size_t number = 1; number <= records.size(); ++number) {
            if (records[number - 1].status == RunStatus::done) {
                ++done_;
            } else {
                pending_.push_back(number);
                work_ += run(number).work;
            }
        }
    }

    void start(int threads) {
        const auto runs = static_cast<int>(pending_.size());
        const int workers = std::min(threads, runs);
        running_ = workers;
        for (int worker = 0; worker < workers; ++worker) {
            const int share = threads / workers + (worker < threads % workers ? 1 : 0);
            threads_.emplace_back([this, share] { work(share); });
        }
    }

    /// Waits for all of them, telling what happens.
    void wait(StatusLine& status) {
        constexpr std::chrono::milliseconds between_looks{50};
        std::unique_lock lock(mutex_);
        for (;;) {
            const bool ended =
                changed_.wait_for(lock, between_looks, [this] { return running_ == 0; });
            for (const std::string& failure : failures_) status.error(failure);
            for (const std::string& success : successes_) status.verbose(success);
            failures_.clear();
            successes_.clear();
            if (ended) break;
            if (status.due()) {
                status.show(sweep_progress_text(done_, records_.size(), failed_,
                                                seconds_since(start_), work_done_ / work_));
            }
        }
        lock.unlock();
        threads_.clear();
        status.clear();
    }

  private:
    [[nodiscard]] const SweepRun& run(std::size_t number) const {
        return plan_.runs[folder_.order()[number - 1]];
    }

    void work(int threads) {
        name_this_thread("fumon-sweep");
        while (interrupting_signal() == 0) {
            const std::size_t next = next_++;
            if (next >= pending_.size()) break;
            const std::size_t number = pending_[next];
            const auto record = outcome(number, threads);
            if (!record) break;
            const std::lock_guard lock(mutex_);
            records_[number - 1] = *record;
            if (record->status == RunStatus::done) {
                ++done_;
                successes_.push_back(fmt::format("run {} ({}) is done in {}", number,
                                                 run_label(plan_, run(number)),
                                                 clock_text(record->wall_seconds)));
            } else {
                ++failed_;
                failures_.push_back(fmt::format("run {} ({}) failed: {}", number,
                                                run_label(plan_, run(number)), record->message));
            }
        }
        const std::lock_guard lock(mutex_);
        --running_;
        changed_.notify_all();
    }

    /// What became of a run; nothing when it was interrupted.
    std::optional<RunRecord> outcome(std::size_t number, int threads) {
        const auto start = Clock::now();
        RunRecord record;
        try {
            if (!simulate(number, threads, record)) return std::nullopt;
            record.status = RunStatus::done;
            record.wall_seconds = seconds_since(start);
            folder_.write_record(number, record);
        } catch (...) {
            record.status = RunStatus::failed;
            record.wall_seconds = seconds_since(start);
            record.state.clear();
            record.message = one_line(error_text(std::current_exception()));
        }
        return record;
    }

    /// One run from its scene to its files. False when it was interrupted, with no file made; one
    /// that fails leaves what it has measured.
    bool simulate(std::size_t number, int threads, RunRecord& record) {
        Workshop workshop = set_up(scene_of(plan_, run(number)), threads);
        if (run_id(workshop.scene, workshop.initial) != run(number).id)
            throw Error("a file that it reads has changed since the sweep began");
        Model& model = *workshop.model;
        Recorder recorder(workshop.scene, model.snapshot(),
                          resolved_scene(workshop.scene, workshop.initial.inputs),
                          folder_.paths(number));
        try {
            if (!advance(workshop, recorder, record)) return false;
        } catch (...) {
            keep(recorder);
            throw;
        }
        record.state = hex(state_hash(model));
        recorder.commit();
        return true;
    }

    /// Runs the model to its end. False when it was interrupted.
    bool advance(Workshop& workshop, Recorder& recorder, RunRecord& record) {
        Model& model = *workshop.model;
        const auto cells = static_cast<double>(workshop.initial.bed.size());
        for (;;) {
            record.steps = model.steps_done();
            if (recorder.due(record.steps)) {
                const Snapshot snapshot = model.snapshot();
                check_finite(snapshot);
                recorder.record(snapshot);
            }
            if (record.steps >= workshop.scene.run.steps) break;
            if (interrupting_signal() != 0) return false;
            model.step();
            recorder.note(model.avalanches());
            work_done_ += cells;
        }
        check_finite(model.snapshot());
        return true;
    }

    /// What a failing run has measured before is kept where it can be.
    static void keep(Recorder& recorder) {
        try {
            recorder.commit();
        } catch (const std::exception&) {
            return;  // the run's own fault is what is told
        }
    }

    const SweepPlan& plan_;
    const SweepFolder& folder_;
    std::vector<RunRecord>& records_;
    std::vector<std::size_t> pending_;  ///< their numbers
    double work_ = 0.0;
    Clock::time_point start_ = Clock::now();

    std::atomic<std::size_t> next_{0};
    std::atomic<double> work_done_{0.0};
    std::mutex mutex_;
    std::condition_variable changed_;
    int running_ = 0;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    std::vector<std::string> failures_;   ///< not told yet
    std::vector<std::string> successes_;  ///< not told yet
    std::vector<std::jthread> threads_;   // last: joined before what they use goes
};

}  // namespace

std::string sweep_progress_text(std::size_t done, std::size_t runs, std::size_t failed,
                                double seconds, double share) {
    std::string text = fmt::format("{} of {} runs", done, runs);
    if (failed > 0) text += fmt::format(", {} failed", failed);
    text += fmt::format(", {} elapsed", clock_text(seconds));
    if (share > 0.0 && share <= 1.0)
        text += fmt::format(", about {} left", clock_text(seconds * (1.0 - share) / share));
    return text;
}

void do_runs(const SweepPlan& plan, const SweepFolder& folder, int threads, StatusLine& status,
             std::vector<RunRecord>& records) {
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    Work work(plan, folder, records);
    work.start(threads);
    work.wait(status);
}

}  // namespace fumon
