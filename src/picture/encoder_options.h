#pragma once

#include <string>
#include <utility>
#include <vector>

#include "picture/movie_format.h"

namespace fumon {

/// What the pictures of a movie are.
struct MovieSize {
    int width = 0;  ///< pixels
    int height = 0;
    double rate = 0.0;  ///< pictures per second
};

/// The most bits that an H.264 movie may take in a second, in thousands: 16,000 at 1080p30 and a
/// rate factor of 18, by the power 3/4 of the pixels per second, doubled with every 6 of the rate
/// factor less, at least 2,000. Its level (ITU-T H.264, table A-1) is the least that allows them.
int h264_kilobits(const MovieSize& size, int quality);

/// The options of a format's encoder, as libavcodec calls them, for a constant rate factor of 0 …
/// 51. `quickly`: with less work and more bytes, where the format can. They are the same on every
/// machine, since the bytes depend on them. "tag": the four letters by which a container calls the
/// codec.
std::vector<std::pair<std::string, std::string>> encoder_options(const MovieFormat& format,
                                                                 const MovieSize& size, int quality,
                                                                 bool quickly);

}  // namespace fumon
