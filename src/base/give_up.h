#pragma once

#include <atomic>
#include <cstdint>
#include <ctime>
#include <exception>

namespace fumon {

/// Thrown out of the midst of long work after a signal has asked the program to stop. What was
/// being made is not to be used any more.
class GivenUp : public std::exception {
  public:
    [[nodiscard]] const char* what() const noexcept override { return "given up: asked to stop"; }
};

/// Seconds that work which is asked to stop has to come to a good end, such as that of a step.
inline constexpr double patience = 1.0;

/// When the program was asked to stop, in nanoseconds of the monotonic clock; 0: it was not.
inline std::atomic<std::int64_t> asked_to_stop_at{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

/// Nanoseconds of the monotonic clock; signal handlers may call it.
inline std::int64_t monotonic_nanoseconds() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

/// Throws GivenUp where the program was asked to stop more than `patience` ago. Long work calls it
/// between rows, sub-steps and topplings: as long as nobody asks, it costs a load.
inline void give_up_if_asked() {
    const std::int64_t asked = asked_to_stop_at.load(std::memory_order_relaxed);
    if (asked == 0) [[likely]]
        return;
    if (static_cast<double>(monotonic_nanoseconds() - asked) > 1e9 * patience) throw GivenUp();
}

}  // namespace fumon
