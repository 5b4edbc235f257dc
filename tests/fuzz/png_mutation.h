#pragma once

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace fumon::fuzz {

inline std::uint32_t big_endian(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U |
           std::uint32_t{bytes[2]} << 8U | bytes[3];
}

/// Makes the checksum of every chunk right, so that a mutation is looked at rather than refused.
inline void repair_checksums(std::uint8_t* data, std::size_t size) {
    constexpr std::size_t signature = 8;
    constexpr std::size_t around = 12;  // length, type and checksum of a chunk
    std::size_t at = signature;
    while (at + around <= size) {
        const std::size_t length = big_endian(data + at);
        if (length > size - at - around) return;
        const auto sum =
            static_cast<std::uint32_t>(crc32(0, data + at + 4, static_cast<unsigned>(length + 4)));
        for (unsigned i = 0; i < 4; ++i)
            data[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24U - 8U * i));
        at += length + around;
    }
}

}  // namespace fumon::fuzz

/// Mutates a PNG file and mends its checksums, but for one mutation in sixteen.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    const std::size_t mutated = LLVMFuzzerMutate(data, size, most);
    if (seed % 16 != 0) fumon::fuzz::repair_checksums(data, mutated);
    return mutated;
}
