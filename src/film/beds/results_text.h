#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "film/beds/stored_beds.h"
#include "foreign/foreign_run.h"
#include "scene/initial_bed.h"

namespace fumon {

/// What pictures record of another model's run (fumon:results), as JSON: its name, the model, its
/// files with their SHA-256, what each variable was taken for, and how the run was asked for. Empty
/// for fumon's own runs.
std::string results_text(const StoredBeds& beds);

/// The hash by which a file of results is recorded: the SHA-256 of its bytes, or of one above 256
/// MiB that of its size and its first and last MiB ("ends-…"), since reading all of it takes longer
/// than a film. Throws as file_hash().
std::string results_hash(const std::filesystem::path& file);

/// As much of it as opens the run again.
struct RecordedResults {
    std::string name;  ///< of its file, or the pattern of its files
    std::vector<InputFile> files;
    ForeignQuery query;
};

/// Reads it. Of pictures that have the name alone, that. Throws InputError, naming the picture,
/// where the text is damaged.
RecordedResults recorded_results(const std::string& text, const std::string& picture);

/// How a run was asked for, without folders of this machine.
nlohmann::ordered_json json_of_query(const ForeignQuery& query);
/// Throws nlohmann::json::exception where it is damaged.
ForeignQuery query_of_json(const nlohmann::ordered_json& json);

}  // namespace fumon
