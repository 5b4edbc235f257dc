#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

/// A seamless square of sand grain, `grain_size` texels on each side, around 127.5: white noise
/// with a coarser part, from hashes, the same on every machine.
inline constexpr int grain_size = 512;
std::vector<std::uint8_t> grain_texels();

/// A square of texels at half its size: each the mean of two columns and then of two rows, halves
/// rounded up both times, which is what llvmpipe's mipmaps are. `size`, of the given one, is even.
std::vector<std::uint8_t> downsampled_texels(const std::vector<std::uint8_t>& texels, int size);

}  // namespace fumon
