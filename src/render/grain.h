#pragma once

#include <cstdint>
#include <vector>

namespace fumon {

/// A seamless square of sand grain, `grain_size` texels on each side, around 127.5: white noise
/// with a coarser part, from hashes, the same on every machine.
inline constexpr int grain_size = 512;
std::vector<std::uint8_t> grain_texels();

}  // namespace fumon
