#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "film/beds/film_runs.h"
#include "film/script/film.h"
#include "film/script/layer_files.h"
#include "foreign/foreign_run.h"
#include "scene/initial_bed.h"

namespace fumon {

/// Keyword → text, the metadata of a film's file or its sidecar.
using FilmTexts = std::map<std::string, std::string>;

/// A run that a film was cut from, as the film records it.
struct FilmedRun {
    std::string name;   ///< what the film called it
    std::string scene;  ///< resolved, as TOML
    std::vector<InputFile> inputs;
    std::string version;                    ///< of the fumon that cut the film
    std::optional<ForeignQuery> foreign{};  ///< of another model: how it was asked for
};

/// The sidecar of a file that `fumon film` made: FILE.json.
std::filesystem::path sidecar_of(const std::filesystem::path& file);

/// The texts of an MP4 or PNG, of the sidecar beside another file, or of a sidecar itself; none
/// where there are none.
FilmTexts read_film_texts(const std::filesystem::path& file);

/// Writes the text of a film's runs (fumon:runs), and reads it. Throws InputError where a film has
/// none: it is of an older version, or damaged.
std::string filmed_runs_text(const FilmRuns& runs);
std::vector<FilmedRun> filmed_runs(const FilmTexts& texts, const std::string& film);

/// Writes the text of the files of a film's layers (fumon:layers), and reads it; no files where
/// there is none.
std::string filmed_layers_text(const std::vector<LayerRecord>& layers);
std::vector<LayerRecord> filmed_layers(const FilmTexts& texts);

/// Where the files lie that the layers of a film within `file` name, for Film::found_layers; those
/// that the command line names are left out. Throws as find_input() where one is missing or has
/// changed since the film was made.
LayerFiles found_layers(Film film, const std::vector<LayerRecord>& layers,
                        const std::filesystem::path& file);

/// The size that a film had to fit (fumon:most-bytes); 0: any.
std::int64_t most_bytes_of(const FilmTexts& texts);

/// In what the making of a film and of one made again differ, in words.
std::string why_films_differ(const FilmTexts& then, const std::filesystem::path& made);

inline constexpr const char* runs_keyword = "fumon:runs";
inline constexpr const char* layers_keyword = "fumon:layers";
inline constexpr const char* most_bytes_keyword = "fumon:most-bytes";

}  // namespace fumon
