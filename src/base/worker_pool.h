#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace fumon {

/// A fixed set of threads for loops over rows. The calling thread takes a share of the work, so a
/// pool of one runs everything on the caller.
class WorkerPool {
  public:
    /// threads ≥ 1; 0 takes as many as the machine has processors. `name` (at most 15 letters) is
    /// what the system calls its threads, by which their CPU time is told apart. Throws
    /// std::system_error where the system has no more threads.
    explicit WorkerPool(int threads = 0, std::string name = "fumon-work");
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    [[nodiscard]] int size() const { return static_cast<int>(workers_.size()) + 1; }

    /// Calls body(begin, end) on disjoint contiguous ranges that cover [0, count), at most one per
    /// thread, and returns when all are done. Rethrows the first exception in range order. Not to
    /// be called from inside a body or from two threads at once.
    void for_ranges(int count, const std::function<void(int begin, int end)>& body);

  private:
    template <class Condition>
    static void spin_briefly(Condition condition);
    void work(int worker);
    void stop();
    void run_share(int share);

    std::string name_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable done_;
    const std::function<void(int, int)>* body_ = nullptr;
    std::vector<std::exception_ptr> errors_;
    int count_ = 0;
    std::atomic<int> running_ = 0;
    std::atomic<unsigned> round_ = 0;
    std::atomic<bool> stopping_ = false;
    std::vector<std::jthread> workers_;  // last: joined before what they use goes
};

}  // namespace fumon
