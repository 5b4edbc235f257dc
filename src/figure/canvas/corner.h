#pragma once

namespace fumon {

/// Where a small thing stands within a frame.
enum class Corner { upper_left, upper_right, lower_left, lower_right };

}  // namespace fumon
