#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "run/terminal/progress.h"

namespace fumon {

/// The threads of the pipeline's stages. What one throws is kept, the first of all, and stops the
/// others.
class StageThreads {
  public:
    /// `stop` makes every stage end; it is called from any of them.
    explicit StageThreads(std::function<void()> stop) : stop_(std::move(stop)) {}

    void start(const std::string& name, std::function<void()> stage);
    /// Calls what may throw as if it were a stage.
    void guard(const std::function<void()>& part);
    /// Keeps an error, the first of all, and stops nothing.
    void keep(const std::exception_ptr& error);
    void abort();
    [[nodiscard]] bool aborted();
    /// Has the thread that waits say something lasting, the same thing once in succession.
    void report(const std::string& line);

    /// Waits until all stages have ended, showing the progress.
    void wait(Progress& progress);
    /// The first error, or none. For when all stages have ended.
    [[nodiscard]] const std::exception_ptr& error() const { return error_; }

  private:
    std::function<void()> stop_;
    std::mutex mutex_;
    std::condition_variable all_done_;
    std::vector<std::string> pending_messages_;
    std::string last_message_;
    int running_ = 0;
    bool aborted_ = false;
    std::exception_ptr error_;
    std::vector<std::jthread> threads_;  // last: joined before what they use goes
};

}  // namespace fumon
