#include "run/parallel_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "base/thread_clock.h"
#include "run/manifest.h"
#include "run/terminal/interrupt.h"
#include "run/terminal/job_watch.h"
#include "run/terminal/progress.h"

namespace fumon {

namespace {
/// The threads that work on the runs; each takes the next run when it has finished one.
class ParallelRuns {
  public:
    ParallelRuns(const std::vector<RunTask>& tasks, std::vector<RunRecord>& records)
        : tasks_(tasks), records_(records) {
        for (const RunRecord& record : records) done_ += record.status == RunStatus::done ? 1 : 0;
        for (const RunTask& task : tasks) {
            pending_.push_back(&task);
            work_ += task.work;
        }
    }

    void start(int threads) {
        const int workers = std::min(threads, static_cast<int>(tasks_.size()));
        running_ = workers;
        for (int worker = 0; worker < workers; ++worker) {
            const int share = threads / workers + (worker < threads % workers ? 1 : 0);
            threads_.emplace_back([this, share] { work(share); });
        }
    }

    /// Waits for all of them, telling what happens.
    void wait(StatusLine& status) {
        constexpr std::chrono::milliseconds poll_interval{50};
        std::unique_lock lock(mutex_);
        for (;;) {
            const bool ended =
                changed_.wait_for(lock, poll_interval, [this] { return running_ == 0; });
            for (const std::string& failure : failures_) status.error(failure);
            for (const std::string& plausibility_warning : plausibility_warnings_)
                status.note(plausibility_warning);
            for (const std::string& success : successes_) status.verbose(success);
            failures_.clear();
            plausibility_warnings_.clear();
            successes_.clear();
            if (status.watch() != nullptr) tell(*status.watch());
            if (ended) break;
            if (status.due()) {
                status.show(run_progress_text(done_, records_.size(), failed_, watch_.seconds(),
                                              work_done_ / work_));
            }
        }
        lock.unlock();
        threads_.clear();
        status.clear();
    }

  private:
    void tell(JobWatch& watch) const {
        const double share = work_ > 0.0 ? work_done_ / work_ : 0.0;
        const bool known = share > 0.0 && share <= 1.0;
        watch.tell({{"runs", static_cast<std::int64_t>(done_ + failed_),
                     static_cast<std::int64_t>(records_.size()),
                     failed_ > 0 ? fmt::format("{} failed", failed_) : ""}},
                   known ? watch_.seconds() * (1.0 - share) / share : -1.0);
    }

    void work(int threads) {
        name_this_thread("fumon-sweep");
        while (const RunTask* task = next()) {
            RunRecord record;
            const Attempt attempt = outcome(*task, threads, record);
            if (attempt == Attempt::interrupted) break;
            if (attempt == Attempt::busy) {
                requeue(*task);
            } else {
                report_outcome(*task, record);
            }
        }
        const std::lock_guard lock(mutex_);
        --running_;
        changed_.notify_all();
    }

    const RunTask* next() {
        const std::lock_guard lock(mutex_);
        if (interrupting_signal() != 0 || pending_.empty()) return nullptr;
        const RunTask* task = pending_.front();
        pending_.pop_front();
        return task;
    }

    void requeue(const RunTask& task) {
        constexpr std::chrono::milliseconds busy_retry_delay{100};
        std::this_thread::sleep_for(busy_retry_delay);
        const std::lock_guard lock(mutex_);
        pending_.push_back(&task);
    }

    Attempt outcome(const RunTask& task, int threads, RunRecord& record) {
        const Stopwatch watch;
        Attempt attempt = Attempt::done;
        try {
            attempt = task.body(threads, record, work_done_);
            record.status = RunStatus::done;
        } catch (const Cancelled&) {
            attempt = Attempt::interrupted;
        } catch (...) {
            record.status = RunStatus::failed;
            record.wall_seconds = watch.seconds();
            record.state.clear();
            record.message = one_line(error_text(std::current_exception()));
        }
        return attempt;
    }

    void report_outcome(const RunTask& task, const RunRecord& record) {
        const std::lock_guard lock(mutex_);
        records_[task.number - 1] = record;
        if (record.status == RunStatus::done) {
            ++done_;
            if (!record.message.empty())
                plausibility_warnings_.push_back(fmt::format("{}: {}", task.name, record.message));
            successes_.push_back(
                fmt::format("{} is done in {}", task.name, clock_text(record.wall_seconds)));
        } else {
            ++failed_;
            failures_.push_back(fmt::format("{} failed: {}", task.name, record.message));
        }
    }

    const std::vector<RunTask>& tasks_;
    std::vector<RunRecord>& records_;
    double work_ = 0.0;
    Stopwatch watch_;

    std::atomic<double> work_done_{0.0};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<const RunTask*> pending_;
    int running_ = 0;
    std::size_t done_ = 0;
    std::size_t failed_ = 0;
    std::vector<std::string> failures_;               ///< not told yet
    std::vector<std::string> plausibility_warnings_;  ///< not told yet
    std::vector<std::string> successes_;              ///< not told yet
    std::vector<std::jthread> threads_;               // last: joined before what they use goes
};

}  // namespace

std::string run_progress_text(std::size_t done, std::size_t runs, std::size_t failed,
                              double seconds, double share) {
    std::string text = fmt::format("{} of {} runs", done, runs);
    if (failed > 0) text += fmt::format(", {} failed", failed);
    text += fmt::format(", {} elapsed", clock_text(seconds));
    if (share > 0.0 && share <= 1.0)
        text += fmt::format(", about {} left", clock_text(seconds * (1.0 - share) / share));
    return text;
}

void do_runs(const std::vector<RunTask>& tasks, int threads, StatusLine& status,
             std::vector<RunRecord>& records) {
    if (tasks.empty()) return;
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    ParallelRuns runs(tasks, records);
    runs.start(threads);
    runs.wait(status);
}

}  // namespace fumon
