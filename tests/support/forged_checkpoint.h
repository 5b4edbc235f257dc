#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "base/sha256.h"

namespace fumon::test {

/// The entries of reals in a checkpoint's bytes: their names, and where their first value lies.
inline std::vector<std::pair<std::string, std::size_t>> reals_of(const std::string& checkpoint) {
    const auto number = [&](std::size_t at, std::size_t size) {
        std::uint64_t value = 0;
        std::memcpy(&value, checkpoint.data() + at, size);
        return static_cast<std::size_t>(value);
    };
    std::vector<std::pair<std::string, std::size_t>> found;
    for (std::size_t at = 12; at < checkpoint.size() - 40;) {
        const char kind = checkpoint[at];
        const std::size_t length = number(at + 1, 2);
        const std::string name = checkpoint.substr(at + 3, length);
        const std::size_t count = number(at + 3 + length, 8);
        at += 11 + length;
        if (kind == 'd' && count > 0) found.emplace_back(name, at);
        at += count * (kind == 't' ? 1 : 8);
    }
    return found;
}

/// The checkpoint with another real there, and the checksum that belongs to it.
inline std::string forged_checkpoint(std::string checkpoint, std::size_t at, double value) {
    std::memcpy(checkpoint.data() + at, &value, sizeof(value));
    Sha256Stream hash;
    hash.add(checkpoint.data(), checkpoint.size() - 32);
    const Sha256 sum = hash.finish();
    std::copy(sum.begin(), sum.end(), checkpoint.end() - 32);
    return checkpoint;
}

}  // namespace fumon::test
