#pragma once

#include <algorithm>

namespace fumon {

/// 0 up to `from`, 1 beyond `to`, and level at both: 3t² − 2t³ between them.
template <class Number>
Number smooth_step(Number from, Number to, Number at) {
    const Number t = std::clamp((at - from) / (to - from), Number{0}, Number{1});
    return t * t * (Number{3} - Number{2} * t);
}

}  // namespace fumon
