#include "run/job_thread.h"

#include <utility>

#include "base/thread_clock.h"

namespace fumon {

JobThread::~JobThread() {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    changed_.notify_all();
}

void JobThread::hand_over(std::function<void()> job) {
    wait();
    if (!thread_.joinable()) thread_ = std::jthread([this] { work(); });
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
    busy_ = true;
    changed_.notify_all();
}

void JobThread::wait() {
    if (const std::exception_ptr met = failure()) std::rethrow_exception(met);
}

std::exception_ptr JobThread::failure() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !busy_; });
    return failure_;
}

void JobThread::work() {
    name_this_thread(name_);
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return ending_ || job_; });
        if (!job_) return;
        std::function<void()> job = std::exchange(job_, nullptr);
        lock.unlock();
        std::exception_ptr met;
        try {
            job();
        } catch (...) {
            met = std::current_exception();
        }
        job = nullptr;  // what it holds goes before the next one comes
        lock.lock();
        failure_ = met;
        busy_ = false;
        changed_.notify_all();
    }
}

}  // namespace fumon
