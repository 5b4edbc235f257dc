#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace fumon {

/// A thread of its own for jobs that are done in the order in which they are handed over, one at a
/// time, while the thread that hands them over goes on. At most one is under way, so that what jobs
/// hold takes no more memory however many there are. After a job that throws no other is done.
/// One thread hands over and waits.
class JobThread {
  public:
    /// `name` (at most 15 letters) is what the system calls the thread, which starts with the first
    /// job.
    explicit JobThread(std::string name) : name_(std::move(name)) {}
    /// Lets the job under way end.
    ~JobThread();
    JobThread(const JobThread&) = delete;
    JobThread& operator=(const JobThread&) = delete;

    /// Waits for the job before, and has this one done meanwhile. Rethrows what a job before threw;
    /// throws std::system_error where the system has no more threads.
    void hand_over(std::function<void()> job);

    /// Waits for the job under way. Rethrows what a job threw, each time that it is called.
    void wait();

    /// The same, and returns what a job threw, or nothing.
    [[nodiscard]] std::exception_ptr failure();

  private:
    void work();

    std::string name_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> job_;  ///< that the thread has not begun
    bool busy_ = false;
    std::exception_ptr failure_;
    bool ending_ = false;
    std::jthread thread_;  // last: joined before what it uses goes
};

}  // namespace fumon
