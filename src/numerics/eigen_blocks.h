#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace fumon {

/// To be called before dense matrices are factorised or multiplied. Eigen cuts them into blocks by
/// the caches of the processor that it runs on, and rounding follows the blocks; from then on every
/// processor counts as one with these caches.
inline void same_eigen_blocks_everywhere() {
    constexpr std::ptrdiff_t first_level = 32 * 1024;  // bytes
    constexpr std::ptrdiff_t second_level = 256 * 1024;
    constexpr std::ptrdiff_t third_level = 2 * 1024 * 1024;
    [[maybe_unused]] static const bool done = [] {
        Eigen::setCpuCacheSizes(first_level, second_level, third_level);
        return true;
    }();
}

}  // namespace fumon
