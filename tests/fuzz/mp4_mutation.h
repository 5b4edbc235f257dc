#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace fumon::fuzz {

/// Where the box "moov", which holds a movie's metadata, begins; `size` where there is none.
inline std::size_t find_moov(const std::uint8_t* data, std::size_t size) {
    const char* const name = "moov";
    const std::uint8_t* const found = std::search(data, data + size, name, name + 4);
    const auto at = static_cast<std::size_t>(found - data);
    return found == data + size || at < 4 ? size : at - 4;
}

}  // namespace fumon::fuzz

/// Mutates what is behind the head of an MP4 movie's "moov", which then ends where the file does;
/// one mutation in eight is of any bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    const std::size_t moov = fumon::fuzz::find_moov(data, size);
    if (moov == size || seed % 8 == 0) return LLVMFuzzerMutate(data, size, most);
    const std::size_t head = moov + 8;
    const std::size_t mutated = head + LLVMFuzzerMutate(data + head, size - head, most - head);
    const auto length = static_cast<std::uint32_t>(mutated - moov);
    for (unsigned i = 0; i < 4; ++i)
        data[moov + i] = static_cast<std::uint8_t>(length >> (24U - 8U * i));
    return mutated;
}
