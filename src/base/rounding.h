#pragma once

namespace fumon {

/// The nearest whole number of a value ≥ 0, halves upward; vectorises, unlike std::lround.
inline int nearest(float value) {
    const float shifted = value + 0.5F;
    return static_cast<int>(shifted);
}

}  // namespace fumon
