#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "film/script/film.h"
#include "film/script/film_sizes.h"
#include "outputs/output_claims.h"
#include "picture/png.h"

namespace fumon {

/// One file to make of a film.
struct FilmOutput {
    std::filesystem::path file;
    Film film;                      ///< with the size, rate and format of this file
    std::int64_t most_bytes = 0;    ///< 0: any
    bool goes_on = false;           ///< it keeps its frames until it is whole, see FrameCache
    std::filesystem::path sheet{};  ///< a contact sheet of the same frames beside a movie; or none
};

/// Claims a film's file and what is written beside it: captions and a sidecar. Throws as
/// OutputClaims::writes.
void claim_film(OutputClaims& claims, const FilmOutput& output);

/// What --formats calls a purpose or a format, in a row: "talk, social, readme, gif, …".
std::string output_names();

/// The outputs of a film: one file, or one for each name in `formats` ("talk", "social", "readme",
/// "gif", a movie format, "sheet", "poster"), called NAME-talk.mp4 … after `file`. Throws
/// InputError for unknown names and endings that do not fit.
std::vector<FilmOutput> film_outputs(const Film& film, const std::filesystem::path& file,
                                     const std::vector<std::string>& formats,
                                     std::int64_t most_bytes);

/// A draft: a small movie (a quarter of each side, a tenth of the frames, film.draft) and a contact
/// sheet of it, called NAME-draft.mp4 and NAME-draft.png.
FilmOutput draft_output(const Film& film, const std::filesystem::path& file);

/// The ending of a format's files: ".mp4", ".png".
std::string_view ending_of(const std::string& format);

}  // namespace fumon
