#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/image.h"

namespace fumon {

/// Pictures of one size that are kept on disk for a while, in a file without a name beside the
/// output: nothing is left of it when the program ends, however it ends.
class FrameSpool {
  public:
    /// `beside`: the output. Throws Error where there can be no such file.
    /// `transparent`: with alpha.
    FrameSpool(const std::filesystem::path& beside, int width, int height,
               bool transparent = false);

    void add(const Image& image);  ///< throws Error on a full disk
    [[nodiscard]] Image frame(std::int64_t number) const;
    [[nodiscard]] std::int64_t frames() const { return frames_; }

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    std::filesystem::path name_;
    std::unique_ptr<std::FILE, Close> file_;
    int width_;
    int height_;
    bool transparent_;
    std::int64_t frames_ = 0;
};

/// An image of another size: each pixel the mean of what it covers, with alpha by how much of that
/// is seen.
Image resized(const Image& image, int width, int height);

}  // namespace fumon
