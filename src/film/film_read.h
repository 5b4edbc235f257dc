#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "film/script/film.h"

namespace fumon {

/// The keywords of a film's texts in the files that are made of it.
inline constexpr const char* film_keyword = "fumon:film";
inline constexpr const char* remake_keyword = "fumon:remake";

/// What a film is read from.
struct FilmText {
    std::string text;    ///< TOML
    std::string remake;  ///< the command that makes it, as its end card shows it
};

/// The text of a film file, or the one recorded in a file that `fumon film` made or in its sidecar.
/// Throws InputError for any other file.
FilmText film_text(const std::filesystem::path& file);

/// Reads a film; `source` names it in messages, `settings` are "key.path=VALUE" overrides of the
/// command line. Throws InputError with a line "file:line:column: what is wrong; what would be
/// right" for each fault: an unknown key, a wrong type, a number out of range, keys that
/// contradict. Films that it cuts from are read, too, and their text takes the place of their
/// name; only from files where `reads_files`, which a film from anyone may not.
Film parse_film(std::string_view text, const std::string& source,
                const std::vector<std::string>& settings = {}, bool reads_files = true);

/// A film file, or the name of one of scenes/films.
std::filesystem::path film_file(const std::string& name);

/// Whether a text is that of a film: it has shots or excerpts. Throws InputError for what is no
/// TOML.
bool is_film(std::string_view text, const std::string& source);

/// The film as TOML, every key with its value.
std::string film_toml(const Film& film);

}  // namespace fumon
