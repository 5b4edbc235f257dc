#include "foreign/field_files.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "foreign/file_numbers.h"
#include "foreign/raster_file.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

bool is_file(const std::string& path) {
    std::error_code fault;
    return fs::is_regular_file(path, fault);
}

/// A file and its variable: "grid.nc:zb".
std::pair<std::string, std::string> file_and_variable(const std::string& source) {
    const std::size_t colon = source.rfind(':');
    if (is_file(source) || colon == std::string::npos) return {source, ""};
    return {source.substr(0, colon), source.substr(colon + 1)};
}

}  // namespace

FieldRequest field_request(const std::string& text) {
    const std::size_t equals = text.find('=');
    const auto quantity = quantity_of_key(std::string_view(text).substr(0, equals));
    if (equals == std::string::npos || equals + 1 == text.size() || !quantity)
        throw InputError(
            fmt::format("--field {}: it takes QUANTITY=NAME or QUANTITY=FILE, where "
                        "QUANTITY is one of {}",
                        text, quantity_keys()));
    return {*quantity, text.substr(equals + 1)};
}

bool is_file_request(const std::string& source) {
    return is_pattern(source) || is_file(file_and_variable(source).first) ||
           source.find('/') != std::string::npos || fs::path(source).has_extension();
}

std::vector<fs::path> files_of_source(const std::string& source) {
    if (!is_file_request(source)) return {};
    if (is_pattern(source)) return files_of_pattern(source);
    return {file_and_variable(source).first};
}

void add_field_of_file(ForeignRun& run, Quantity quantity, const std::string& source,
                       const ForeignQuery& query) {
    const double cell_size = run.scale.in_metres ? run.scale.dx : query.cell_size;
    std::vector<fs::path> files;
    std::string variable;
    if (is_pattern(source)) {
        const std::vector<NumberedFile> series =
            in_order(files_of_pattern(source), query.time_pattern);
        for (const NumberedFile& one : series) files.push_back(one.file);
        if (!run.numbers.empty()) {
            std::vector<fs::path> paired;
            for (std::size_t i = 0; i < run.numbers.size(); ++i) {
                for (const NumberedFile& one : series)
                    if (one.number == run.numbers[i]) paired.push_back(one.file);
                if (paired.size() == i + 1) continue;
                throw InputError(fmt::format("{}: no file has the number or date of {}", source,
                                             run.files[i].string()));
            }
            files = std::move(paired);
        }
        if (files.size() != run.times.times.size())
            throw InputError(fmt::format("{}: {} files, but {} has {} records", source,
                                         files.size(), run.name, run.times.times.size()));
    } else {
        const auto [file, named] = file_and_variable(source);
        files.emplace_back(file);
        variable = named;
    }
    const RasterFile first = read_raster_file(files.front(), variable, quantity, cell_size);
    if (first.values.nx() != run.nx || first.values.ny() != run.ny)
        throw InputError(
            fmt::format("{}: has {} x {} cells, but {} has {} x {}; all fields of a "
                        "run need the same grid",
                        files.front().string(), first.values.nx(), first.values.ny(), run.name,
                        run.nx, run.ny));
    ForeignField field{quantity, source, "", "", "--field", files.size() > 1, false, {}};
    if (files.size() > 1) {
        field.read = [files, quantity, cell_size](std::size_t record) {
            return read_raster_file(files.at(record), "", quantity, cell_size).values;
        };
    } else {
        field.read = [kept = std::make_shared<const Grid>(first.values)](std::size_t) {
            return *kept;
        };
    }
    if (!run.scale.in_metres) run.scale = first.scale;
    run.fields.push_back(std::move(field));
    run.files.insert(run.files.end(), files.begin(), files.end());
}

}  // namespace fumon
