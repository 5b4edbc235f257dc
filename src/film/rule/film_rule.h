#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "film/beds/film_runs.h"
#include "keys/override.h"

namespace fumon {

/// What a film by rule is for.
enum class FilmStyle {
    talk,    ///< 16 s, 1080p
    social,  ///< 12 s, higher than wide, larger letters
    loop,    ///< 12 s, once round the last bed: its end is its beginning
    survey   ///< 18 s, from the map to the land, with a map beside it
};

/// The style of a name. Throws InputError, with the known ones.
FilmStyle film_style(const std::string& name);
/// "talk, social, loop, survey".
std::string film_style_names();

struct FilmRule {
    FilmStyle style = FilmStyle::talk;
    double seconds = 0.0;             ///< 0: the style's own
    std::vector<Override> colours{};  ///< of the look, as TOML: what colours the ground
};

inline constexpr double shortest_film_by_rule = 4.0;  ///< seconds

/// A film of a run as the text of a film file, with comments: the whole, its growth with as much
/// change in each frame, the largest of what is there, and an orbit at the end; where a bed stands
/// on a table, from where it fills two thirds of the picture. `run` is what the text calls the run.
/// Of runs side by side the first decides. The same runs give the same text. Throws InputError for
/// a damaged run, and for a film shorter than shortest_film_by_rule.
std::string film_by_rule(const FilmRuns& runs, const FilmRule& rule, const std::string& run);

}  // namespace fumon
