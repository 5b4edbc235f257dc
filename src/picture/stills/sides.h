#pragma once

#include <fmt/format.h>

#include <string_view>

#include "base/error.h"
#include "base/image.h"

namespace fumon {

/// Throws InputError for a picture that has no pixels or a longer side than a format holds.
inline void check_sides(const Image& image, int longest, std::string_view format) {
    if (image.width >= 1 && image.height >= 1 && image.width <= longest && image.height <= longest)
        return;
    throw InputError(fmt::format(
        "a picture of {} × {} pixels is too large for {}, which holds {} on a side; write a PNG",
        image.width, image.height, format, longest));
}

}  // namespace fumon
