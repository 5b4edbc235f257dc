#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fumon {

/// A kind of file that a movie may become.
struct MovieFormat {
    std::string_view name;         ///< "h264"
    std::string_view ending;       ///< of the file's name: ".mp4"
    std::string_view muxer;        ///< as libavformat calls it
    std::string_view encoder;      ///< as libavcodec calls it
    std::string_view pixels;       ///< as libavutil calls them: "yuv420p"
    std::string_view open_pixels;  ///< the same with alpha; empty: it has none
    bool even_sides = false;       ///< its pictures need them
    std::string_view help;         ///< one line
};

/// All of them; the first of those with an ending is the one that the ending means.
std::span<const MovieFormat> movie_formats();

/// The format of a name, or null.
const MovieFormat* find_movie_format(std::string_view name);

/// "prores, ffv1, …": those with alpha.
std::string transparent_format_names();

/// "h264, hevc, …".
std::string movie_format_names();

}  // namespace fumon
