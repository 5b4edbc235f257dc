#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"

namespace fumon {

/// Small pictures of a film, a second apart, and its last one, row by row.
class ContactSheet {
  public:
    /// Of a film of so many frames (1 or more) of this size, `rate` of them a second.
    ContactSheet(std::int64_t frames, double rate, int width, int height);

    /// Which frames it shows, from the first to the last.
    [[nodiscard]] const std::vector<std::int64_t>& frames() const { return frames_; }
    [[nodiscard]] bool shows(std::int64_t frame) const;
    /// Puts one of them in its place.
    void add(std::int64_t frame, const Image& image);
    [[nodiscard]] const Image& image() const { return image_; }

  private:
    std::vector<std::int64_t> frames_;
    int width_;  ///< of a small picture
    int height_;
    int columns_;
    Image image_;
};

}  // namespace fumon
