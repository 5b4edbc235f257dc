#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "film/beds/film_runs.h"
#include "film/cache/picture_cache.h"
#include "film/film_output.h"
#include "run/terminal/status_line.h"
#include "run/terminal/work_options.h"

namespace fumon {

/// A film's file as it was made.
struct MadeFilm {
    std::int64_t frames = 0;
    double seconds = 0.0;  ///< its length
    int width = 0;         ///< of its pictures
    int height = 0;
    int signal = 0;                 ///< that stopped it: there is no file; or 0
    std::int64_t begun_frame = 0;   ///< from 0, at which it was stopped
    bool goes_on = false;           ///< whether its frames up to there are kept, see FrameCache
    std::int64_t sheet_frames = 0;  ///< on the contact sheet beside it
};

/// Draws a film from the stored beds of its runs and writes it whole, or nothing. With captions a
/// SubRip file is written beside a movie, and a sidecar beside what holds no text. Throws
/// InputError before anything is drawn where film and run do not fit, Error where drawing or
/// writing fails. Pictures are taken from `cache` and put there; none: all are drawn.
MadeFilm make_film(const FilmOutput& output, const FilmRuns& runs, const std::string& remake,
                   const WorkOptions& work, StatusLine& status, PictureCache* cache = nullptr);

/// The captions' file beside a movie.
std::filesystem::path captions_of(std::filesystem::path file);

}  // namespace fumon
