#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "render/image.h"

namespace fumon {

/// An MP4 movie (H.264, yuv420p, BT.709, faststart). An odd size is padded by repeating the edge
/// column or row. It is written to a temporary name; finish() gives it its own.
class Movie {
  public:
    /// quality: the constant rate factor, 0 … 51. Throws Error when the codec is missing or the
    /// file cannot be made.
    Movie(const std::filesystem::path& file, int width, int height, double frames_per_second,
          int quality);
    ~Movie();  ///< an unfinished movie is deleted
    Movie(const Movie&) = delete;
    Movie& operator=(const Movie&) = delete;

    void add(const Image& image);  ///< throws Error on a failed write or an image of another size
    void finish();  ///< completes the file and renames it; without frames nothing is left

    [[nodiscard]] int padded_width() const;
    [[nodiscard]] int padded_height() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fumon
