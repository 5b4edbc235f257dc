#pragma once

#include <cstdint>
#include <vector>

#include "base/huge_pages.h"

namespace fumon {

/// What lighting_texels() makes: as large as fields are, in memory that is used again like theirs.
using LightTexels = std::vector<std::uint16_t, HugePageAllocator<std::uint16_t>>;

}  // namespace fumon
