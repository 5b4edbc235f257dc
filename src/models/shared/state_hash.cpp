#include "models/shared/state_hash.h"

#include <bit>
#include <cstdint>
#include <span>

namespace fumon {

namespace {

void add_doubles(Sha256Stream& hasher, std::span<const double> values) {
    if constexpr (std::endian::native == std::endian::little) {
        hasher.add(values.data(), values.size_bytes());
    } else {
        for (const double value : values)
            hasher.add_little_endian(std::bit_cast<std::uint64_t>(value));
    }
}

}  // namespace

Sha256 state_hash(const Model& model) {
    Sha256Stream hasher;
    hasher.add(model.name().data(), model.name().size());
    hasher.add_little_endian(static_cast<std::uint64_t>(model.steps_done()));
    for (const StateField& field : model.state()) add_doubles(hasher, field.values);
    return hasher.finish();
}

}  // namespace fumon
