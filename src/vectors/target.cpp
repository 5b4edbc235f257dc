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

/// The best one first.
constexpr std::array known{Target{"avx512", HWY_AVX3}, Target{"avx2", HWY_AVX2},
                           Target{"sse4", HWY_SSE4}, Target{"neon", HWY_NEON},
                           Target{"plain", HWY_SCALAR | HWY_EMU128}};

bool is_supported(const Target& target, std::int64_t disabled) {
    hwy::DisableTargets(disabled);
    const std::int64_t there = hwy::SupportedTargets() & HWY_TARGETS;
    return (there & target.bit) != 0;
}

std::int64_t& disabled_now() {
    static std::int64_t disabled = 0;
    return disabled;
}

void disable(std::int64_t bits) {
    disabled_now() = bits;
    hwy::DisableTargets(bits);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<std::string> targets() {
    std::vector<std::string> names;
    for (const Target& one : known) {
        if (is_supported(one, 0)) names.emplace_back(one.name);
    }
    hwy::DisableTargets(disabled_now());
    return names;
}

std::string target() {
    const auto found = std::ranges::find_if(
        known, [](const Target& one) { return is_supported(one, disabled_now()); });
    return found == known.end() ? "plain" : std::string(found->name);
}

void use_target(std::string_view name) {
    const std::vector<std::string> there = targets();
    if (std::ranges::find(there, name) == there.end()) {
        throw InputError(fmt::format("there is no vector target \"{}\" on this processor, but {}",
                                     name, fmt::join(there, ", ")));
    }
    disable(~std::ranges::find(known, name, &Target::name)->bit);
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
