#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "film/script/film_sizes.h"
#include "run/frame_painter.h"

namespace fumon {

/// The frames of a film, any of them at any time. Lives on one thread.
class FilmFrames {
  public:
    FilmFrames() = default;
    FilmFrames(const FilmFrames&) = delete;
    FilmFrames& operator=(const FilmFrames&) = delete;
    virtual ~FilmFrames() = default;

    [[nodiscard]] virtual std::int64_t frames() const = 0;
    [[nodiscard]] virtual FilmSize size() const = 0;
    [[nodiscard]] virtual bool transparent() const = 0;  ///< whether frames have alpha
    virtual Image paint(std::int64_t frame) = 0;
    /// The light of a frame, without anything that is written over it; of films of one run. Frames
    /// are drawn either by this or by paint().
    virtual LayeredImage light(std::int64_t frame);
    /// Lets go of OpenGL, and of the memory that it takes, until the next frame.
    virtual void close() = 0;
    /// What draws them. Throws Error where OpenGL fails.
    [[nodiscard]] virtual DrawingRecord record() = 0;
    /// Lines for the user: letters that no font has, shots that show few beds in many frames.
    [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;
};

/// `share` of the second image and the rest of the first, of one size.
Image mixed(Image first, const Image& second, double share);

/// The same of light, layer by layer.
LayeredImage mixed(LayeredImage first, const LayeredImage& second, double share);

}  // namespace fumon
