#include "run/stage_threads.h"

#include <chrono>
#include <utility>

#include "base/thread_clock.h"

namespace fumon {

void StageThreads::start(const std::string& name, std::function<void()> stage) {
    {
        const std::lock_guard lock(mutex_);
        ++running_;
    }
    threads_.emplace_back([this, name, stage = std::move(stage)] {
        name_this_thread(name);
        guard(stage);
        const std::lock_guard lock(mutex_);
        if (--running_ == 0) all_done_.notify_all();
    });
}

void StageThreads::guard(const std::function<void()>& part) {
    try {
        part();
    } catch (...) {
        keep(std::current_exception());
        abort();
    }
}

void StageThreads::keep(const std::exception_ptr& error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = error;
}

void StageThreads::abort() {
    {
        const std::lock_guard lock(mutex_);
        aborted_ = true;
    }
    stop_();
}

bool StageThreads::aborted() {
    const std::lock_guard lock(mutex_);
    return aborted_;
}

void StageThreads::report(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (line != last_message_) pending_messages_.push_back(last_message_ = line);
}

void StageThreads::wait(Progress& progress) {
    constexpr std::chrono::milliseconds poll_interval{50};
    std::unique_lock lock(mutex_);
    for (bool done = false; !done;) {
        done = all_done_.wait_for(lock, poll_interval, [this] { return running_ == 0; });
        const std::vector<std::string> lines = std::exchange(pending_messages_, {});
        lock.unlock();
        for (const std::string& line : lines) progress.note(line);
        if (!done) progress.show();
        lock.lock();
    }
    lock.unlock();
    threads_.clear();
}

}  // namespace fumon
