#include "models/shared/cycle_detector.h"

#include "base/error.h"

namespace fumon {

namespace {

/// One round of splitmix64 (Steele, Lea & Flood 2014).
std::uint64_t mix(std::uint64_t digest, std::uint64_t value) {
    std::uint64_t z = digest + value + 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
}

}  // namespace

void CycleDetector::compare(std::int64_t topplings, std::int64_t draws,
                            std::span<const std::size_t> changed,
                            std::span<const std::int32_t> cells,
                            std::span<const std::size_t> queue) {
    topplings_at_last_check_ = topplings;
    std::uint64_t digest = changed.size();
    for (const std::size_t cell : changed)
        digest = mix(digest, static_cast<std::uint64_t>(cells[cell]));
    for (const std::size_t cell : queue) digest = mix(digest, cell);
    if (digest == reference_digest_ && draws == reference_draws_) {
        throw Error(
            "the pile never comes to rest: grains move in a cycle, since this rule also moves them "
            "uphill; take model.direction = \"circular-mean\", model.topple_toward = "
            "\"toward-direction\", more grains per topple or a smoother bed");
    }
    if (++checks_ == next_reference_) {
        next_reference_ *= 2;
        reference_digest_ = digest;
        reference_draws_ = draws;
    }
}

}  // namespace fumon
