#pragma once

#include <filesystem>
#include <memory>

#include "picture/movie_format.h"

struct AVPacket;
struct AVCodecParameters;

namespace fumon {

/// A file of encoded pictures that can be played while it is being written, up to the last key
/// frame but one at least: MP4 and QuickTime as fragments (ISO/IEC 14496-12, 8.8), one a key frame.
/// It has its final name from the beginning, since it is not meant to be whole.
class GrowingMovie {
  public:
    /// Frames are counted in units of numerator/denominator seconds. Throws Error where the file
    /// cannot be made.
    GrowingMovie(const std::filesystem::path& file, const MovieFormat& format,
                 const AVCodecParameters& coded, int numerator, int denominator);
    ~GrowingMovie();  ///< completes it

    /// Adds a copy of a packet whose times count frames. Throws Error on a failed write.
    void add(const AVPacket& packet);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
