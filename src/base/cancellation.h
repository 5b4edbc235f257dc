#pragma once

#include <atomic>
#include <cstdint>
#include <ctime>
#include <exception>

namespace fumon {

/// Thrown out of the midst of long work after a signal has asked the program to stop. What was
/// being made is not to be used any more.
class Cancelled : public std::exception {
  public:
    [[nodiscard]] const char* what() const noexcept override { return "given up: asked to stop"; }
};

/// Seconds that work which is asked to stop has to come to a good end, such as that of a step.
inline constexpr double cancellation_grace_s = 1.0;

/// When the program was asked to stop, in nanoseconds of the monotonic clock; 0: it was not.
inline std::atomic<std::int64_t> stop_requested_at_ns{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

/// Nanoseconds of the monotonic clock; signal handlers may call it.
inline std::int64_t monotonic_nanoseconds() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

/// Throws Cancelled where the program was asked to stop more than `cancellation_grace_s` ago. Long
/// work calls it between rows, sub-steps and topplings: as long as nobody asks, it costs a load.
inline void throw_if_cancelled() {
    const std::int64_t asked = stop_requested_at_ns.load(std::memory_order_relaxed);
    if (asked == 0) [[likely]]
        return;
    if (static_cast<double>(monotonic_nanoseconds() - asked) > 1e9 * cancellation_grace_s)
        throw Cancelled();
}

}  // namespace fumon
