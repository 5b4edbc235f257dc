#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/image.h"

namespace fumon {

/// The frames of a film that is being made, as PNG files in the folder FILE.frames beside it, so
/// that an interrupted film continues where it stopped. The folder records the identity of the
/// film; frames of another film are replaced.
class FrameCache {
  public:
    /// `identity`: a text of all that decides the frames. Throws InputError where the folder holds
    /// something else than frames of films, Error where it cannot be written.
    FrameCache(const std::filesystem::path& file, const std::string& identity);

    /// A frame that was drawn before.
    [[nodiscard]] std::optional<Image> find(std::int64_t number) const;
    void add(std::int64_t number, const Image& image) const;  ///< throws Error on a full disk
    /// A film that plays up to where the frames end, whatever stops the program.
    [[nodiscard]] std::filesystem::path so_far() const;
    /// Where the film itself is encoded meanwhile.
    [[nodiscard]] std::filesystem::path whole() const;
    /// Puts the finished film in its place, and deletes the folder.
    void finish() const;

  private:
    [[nodiscard]] std::filesystem::path frame(std::int64_t number) const;
    void clear() const;

    std::filesystem::path file_;
    std::filesystem::path folder_;
};

}  // namespace fumon
