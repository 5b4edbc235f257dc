#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/terminal/work_options.h"

namespace fumon {

/// Options of `fumon again` for a film.
struct FilmAgain {
    std::filesystem::path film;    ///< that is made again
    std::filesystem::path output;  ///< empty: NAME-again here
    bool force = false;
    bool trust = false;               ///< without limits on its runs
    std::vector<std::string> from{};  ///< files of other models' runs, in their order
    WorkOptions work;
};

/// Whether a file is a film that fumon cut from stored beds: by its own texts or its sidecar's.
bool is_made_film(const std::filesystem::path& file);

/// Simulates the runs of a film again, cuts it from their beds and says whether its bytes are the
/// same. Returns the exit status. Throws InputError where the film does not record its runs, or
/// asks for too much.
int make_film_again(const FilmAgain& wanted);

}  // namespace fumon
