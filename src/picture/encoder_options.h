#pragma once

#include <string>
#include <utility>
#include <vector>

#include "picture/movie_format.h"

namespace fumon {

/// The options of a format's encoder, as libavcodec calls them, for a constant rate factor of 0 …
/// 51. `quickly`: with less work and more bytes, where the format can. They are the same on every
/// machine, since the bytes depend on them. "tag": the four letters by which a container calls the
/// codec.
std::vector<std::pair<std::string, std::string>> encoder_options(const MovieFormat& format,
                                                                 int quality, bool quickly);

}  // namespace fumon
