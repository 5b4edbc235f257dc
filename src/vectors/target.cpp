#include "vectors/target.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "base/error.h"

namespace fumon::vectors {

namespace {

struct Target {
    std::string_view name;
    std::int64_t bit;
};

// What every x86-64 processor has is a target of its own from Highway 1.0.4 on.
#ifdef HWY_SSE2
constexpr std::int64_t of_every_processor = HWY_SCALAR | HWY_EMU128 | HWY_SSE2;
#else
constexpr std::int64_t of_every_processor = HWY_SCALAR | HWY_EMU128;
#endif

/// The best one first.
constexpr std::array known{Target{"avx512", HWY_AVX3}, Target{"avx2", HWY_AVX2},
                           Target{"sse4", HWY_SSE4}, Target{"neon", HWY_NEON},
                           Target{"plain", of_every_processor}};

/// Of the processor. Asked once: with each question Highway goes back to the best target.
std::int64_t supported() {
    static const std::int64_t bits = hwy::SupportedTargets() & HWY_TARGETS;
    return bits;
}

const Target*& chosen() {
    static const Target* target = nullptr;
    return target;
}

}  // namespace

std::vector<std::string> targets() {
    std::vector<std::string> names;
    for (const Target& one : known) {
        if ((supported() & one.bit) != 0) names.emplace_back(one.name);
    }
    return names;
}

std::string target() {
    return chosen() != nullptr ? std::string(chosen()->name) : targets().front();
}

void use_target(std::string_view name) {
    const std::vector<std::string> there = targets();
    if (std::ranges::find(there, name) == there.end()) {
        throw InputError(fmt::format("there is no vector target \"{}\" on this processor, but {}",
                                     name, fmt::join(there, ", ")));
    }
    chosen() = std::ranges::find(known, name, &Target::name);
    hwy::GetChosenTarget().Update(chosen()->bit);
}

void use_target_of_environment() {
    const char* name = std::getenv("FUMON_VECTOR_TARGET");
    if (name == nullptr || *name == '\0') return;
    try {
        use_target(name);
    } catch (const InputError& refusal) {
        throw InputError(fmt::format("FUMON_VECTOR_TARGET: {}", refusal.what()));
    }
}

}  // namespace fumon::vectors
