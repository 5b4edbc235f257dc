#include "base/worker_pool.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/thread_clock.h"

namespace fumon {

WorkerPool::WorkerPool(int threads, std::string name) : name_(std::move(name)) {
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    errors_.resize(static_cast<std::size_t>(threads));
    workers_.reserve(static_cast<std::size_t>(threads) - 1);
    try {
        for (int worker = 1; worker < threads; ++worker)
            workers_.emplace_back([this, worker] { work(worker); });
    } catch (...) {
        stop();  // those that have started, which are joined now
        throw;
    }
}

WorkerPool::~WorkerPool() {
    stop();
}

void WorkerPool::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
}

/// Polls for a moment whether the condition holds, since waking a sleeping thread costs about 20
/// µs, as much as a step of a small grid.
template <class Condition>
void WorkerPool::spin_briefly(Condition condition) {
    constexpr int spin_count = 2000;  // some 20 µs
    for (int look = 0; look < spin_count && !condition(); ++look) {
#if defined(__x86_64__)
        __builtin_ia32_pause();
#endif
    }
}

void WorkerPool::for_ranges(int count, const std::function<void(int begin, int end)>& body) {
    if (count <= 0) return;
    {
        const std::lock_guard lock(mutex_);
        body_ = &body;
        count_ = count;
        running_ = size();
        std::fill(errors_.begin(), errors_.end(), nullptr);
        ++round_;
    }
    wake_.notify_all();
    run_share(0);
    spin_briefly([this] { return running_ == 0; });
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return running_ == 0; });
    body_ = nullptr;
    for (const std::exception_ptr& error : errors_) {
        if (error) std::rethrow_exception(error);
    }
}

void WorkerPool::work(int worker) {
    name_this_thread(name_);
    unsigned seen = 0;
    for (;;) {
        spin_briefly([&] { return stopping_ || round_ != seen; });
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return stopping_ || round_ != seen; });
            if (stopping_) return;
            seen = round_;
        }
        run_share(worker);
    }
}

void WorkerPool::run_share(int share) {
    const std::int64_t shares = size();
    const auto begin = static_cast<int>(count_ * static_cast<std::int64_t>(share) / shares);
    const auto end = static_cast<int>(count_ * static_cast<std::int64_t>(share + 1) / shares);
    try {
        if (begin < end) (*body_)(begin, end);
    } catch (...) {
        errors_[static_cast<std::size_t>(share)] = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (--running_ == 0) done_.notify_one();
}

}  // namespace fumon
