#pragma once

#include "base/image.h"
#include "picture/compare.h"

namespace fumon::plain {

/// Two opaque pictures of one size compared, and where they differ (fumon's compare() and
/// difference_picture()), as plain loops on one thread, as one writes them first: what fumon's
/// rates are measured against. The same numbers and the same picture; thumbnails apart.
struct Compared {
    Comparison comparison;
    Image difference;
};

Compared compare(const Image& first, const Image& second);

}  // namespace fumon::plain
