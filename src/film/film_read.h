#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "film/film.h"

namespace fumon {

/// Reads a film's file; `settings` are "key.path=VALUE" overrides of the command line. Throws
/// InputError with a line "file:line:column: what is wrong; what would be right" for each fault: an
/// unknown key, a wrong type, a number out of range, keys that contradict.
Film read_film(const std::filesystem::path& file, const std::vector<std::string>& settings = {});

/// The same of a film's text; `source` names it in messages.
Film parse_film(std::string_view text, const std::string& source,
                const std::vector<std::string>& settings = {});

/// The film as TOML, every key with its value.
std::string film_toml(const Film& film);

}  // namespace fumon
