#pragma once

#include <cstdint>
#include <string>

#include "film/script/film.h"

namespace fumon {

inline constexpr std::int64_t largest_film_side = 8192;
inline constexpr std::int64_t smallest_film_side = 16;

struct FilmSize {
    std::int64_t width = 0;  ///< pixels
    std::int64_t height = 0;
};

/// "1080p, 720p, 4k, …".
std::string film_size_names();

/// The size of a film: film.width and film.height, or film.size by name. Throws InputError, located
/// at the key.
FilmSize film_size(const Film& film);

}  // namespace fumon
