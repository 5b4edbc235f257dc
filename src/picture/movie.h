#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "base/image.h"
#include "picture/movie_format.h"
#include "picture/png.h"

namespace fumon {

class ColourTable;

/// How a movie is encoded.
struct MovieCoding {
    const MovieFormat& format;
    int quality = 18;                      ///< constant rate factor, 0 … 51
    const ColourTable* colours = nullptr;  ///< of a GIF, which needs one; outlives the movie
    /// Its frames have alpha, where the format can; elsewhere they are laid on white.
    bool transparent = false;
    /// A second file, which plays at any time what has been encoded up to there and stays whatever
    /// ends the program; none where empty. It may be NAME.part, the usual temporary name: the movie
    /// is then written as NAME.whole.part meanwhile.
    std::filesystem::path so_far{};
    bool quickly = false;  ///< with less work and more bytes, where the format can
};

/// A movie: MP4 (H.264, yuv420p, BT.709, faststart) or another format. A key frame comes at least
/// every second. Where the format needs even sides, an odd one is padded by repeating the edge
/// column or row. It is written to a temporary name; finish() gives it its own.
class Movie {
  public:
    /// quality: the constant rate factor, 0 … 51. Throws Error when the codec is missing or the
    /// file cannot be made.
    Movie(const std::filesystem::path& file, int width, int height, double frames_per_second,
          int quality);
    Movie(const std::filesystem::path& file, int width, int height, double frames_per_second,
          const MovieCoding& coding);
    ~Movie();  ///< an unfinished movie is deleted
    Movie(const Movie&) = delete;
    Movie& operator=(const Movie&) = delete;

    void add(const Image& image);  ///< throws Error on a failed write or an image of another size
    /// Completes the file with these texts in its metadata and renames it; without frames nothing
    /// is left.
    void finish(const PictureText& texts = {});

    [[nodiscard]] int padded_width() const;
    [[nodiscard]] int padded_height() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The encoder's libraries and their versions.
std::string movie_encoder();

/// Whether a file begins as an MP4 movie. Throws InputError when it cannot be read.
bool is_movie(const std::filesystem::path& file);

/// The texts of a movie's metadata, in its order, as Movie::finish writes them; of any other movie
/// none. Throws InputError when it is not an MP4 movie or is damaged.
PictureText read_movie_texts(const std::filesystem::path& file);

}  // namespace fumon
