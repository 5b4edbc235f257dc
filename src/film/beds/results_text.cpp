#include "film/beds/results_text.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/hash.h"
#include "files/json_text.h"
#include "foreign/quantity.h"
#include "scene/input_maps.h"
#include "scene/json.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// "bed=/home/me/grid.nc:zb" as "bed=grid.nc:zb".
std::string without_local_folder(const std::string& field) {
    const std::size_t equals = field.find('=');
    const fs::path source = field.substr(equals == std::string::npos ? 0 : equals + 1);
    if (equals == std::string::npos || !source.is_absolute()) return field;
    return field.substr(0, equals + 1) + source.filename().string();
}

nlohmann::ordered_json json_of_files(const std::vector<InputFile>& files) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const InputFile& file : without_local_paths(files))
        list.push_back({{"path", file.path}, {"sha256", file.hash}});
    return list;
}

/// The files that the run was read from, without those that its scene reads besides.
std::vector<InputFile> files_of(const StoredBeds& beds) {
    std::vector<InputFile> files;
    for (const fs::path& file : beds.foreign()->files)
        for (const InputFile& input : beds.inputs())
            if (input.path == file.string()) {
                files.push_back(input);
                break;
            }
    return files;
}

}  // namespace

nlohmann::ordered_json json_of_query(const ForeignQuery& query) {
    nlohmann::ordered_json fields = nlohmann::ordered_json::array();
    for (const std::string& field : query.fields) fields.push_back(without_local_folder(field));
    return {{"fields", std::move(fields)},
            {"time_pattern", query.time_pattern},
            {"time_unit", query.time_unit},
            {"cell_size", query.cell_size},
            {"scalars", query.scalars}};
}

ForeignQuery query_of_json(const nlohmann::ordered_json& json) {
    return {json.at("fields"), json.at("time_pattern"), json.at("time_unit"), json.at("cell_size"),
            json.value("scalars", std::vector<std::string>())};
}

std::string results_hash(const fs::path& file) {
    constexpr std::uintmax_t largest = std::uintmax_t{1} << 28U;  // bytes
    constexpr std::size_t end = std::size_t{1} << 20U;            // bytes
    const std::uintmax_t size = fs::file_size(file);
    if (size <= largest) return hex(file_hash(file));
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(2 * end, '\0');
    stream.read(bytes.data(), end);
    stream.seekg(-static_cast<std::streamoff>(end), std::ios::end);
    stream.read(bytes.data() + end, end);
    return "ends-" + hex(text_hash(bytes + fmt::format("{}", size)));
}

std::string results_text(const StoredBeds& beds) {
    const ForeignRun* run = beds.foreign();
    if (run == nullptr) return {};
    nlohmann::ordered_json json{{"name", fs::path(beds.name()).filename().string()},
                                {"model", run->model},
                                {"files", json_of_files(files_of(beds))}};
    nlohmann::ordered_json& variables = json["variables"] = nlohmann::ordered_json::object();
    for (const ForeignField& field : run->fields)
        variables[std::string(facts_of(field.quantity).key)] = field.name;
    if (beds.foreign_query()) json["query"] = json_of_query(*beds.foreign_query());
    return json_text(json);
}

RecordedResults recorded_results(const std::string& text, const std::string& picture) {
    if (!text.starts_with('{')) return {text, {}, {}};
    try {
        const nlohmann::ordered_json json = parse_json(text);
        RecordedResults results{json.at("name"), {}, query_of_json(json.at("query"))};
        for (const auto& file : json.at("files"))
            results.files.push_back({file.at("path"), file.at("sha256")});
        return results;
    } catch (const nlohmann::json::exception&) {
        throw InputError(
            fmt::format("{}: its fumon:results text is damaged; take an untouched copy", picture));
    }
}

}  // namespace fumon
