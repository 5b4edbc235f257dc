#include "foreign/raster_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/error.h"
#include "files/unit_conversion.h"
#include "foreign/field_files.h"
#include "foreign/file_numbers.h"
#include "foreign/raster_file.h"
#include "foreign/run_times.h"
#include "foreign/variable_names.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// A name without its digits and marks: "waterdepth" of "waterdepth_720".
std::string letters_of(const std::string& name) {
    std::string letters;
    for (const char letter : name)
        if (std::isalpha(static_cast<unsigned char>(letter)) != 0)
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return letters;
}

/// What the files of a series are called, without numbers: by their names, or their ending, which
/// LISFLOOD-FP gives by what they hold.
struct SeriesKind {
    Quantity quantity = Quantity::bed;
    std::string model;
    double dry = 0.0;
    std::string reason = "a series of rasters is one of beds";
};

SeriesKind kind_of(const fs::path& file) {
    const std::string stem = letters_of(file.stem().string());
    const std::string ending = letters_of(file.extension().string());
    if (ending == "wd") return {Quantity::depth, "LISFLOOD-FP", 0.001, "its ending .wd"};
    if (ending == "elev" || ending == "wse")
        return {Quantity::level, "LISFLOOD-FP", 0.001, "its ending ." + ending};
    for (const ForeignModel& model : foreign_models()) {
        if (model.name == "fumon") continue;  // which writes no series of depths
        for (const QuantityNames& names : model.quantities) {
            for (const std::string& name : names.names) {
                if (letters_of(name).size() < 3 || letters_of(name) != stem) continue;
                if (names.quantity == Quantity::level && stem == "elev") continue;  // of CAESAR
                return {names.quantity, model.name == "others" ? "" : model.name, model.dry,
                        "the name of its files"};
            }
        }
    }
    return {};
}

RawTimes times_of(const std::vector<NumberedFile>& series, const ForeignQuery& query) {
    RawTimes times;
    double factor = 1.0;
    if (!query.time_unit.empty()) {
        const auto seconds = unit_conversion(query.time_unit, "s");
        if (!seconds)
            throw InputError(
                fmt::format("--time-unit {} is not a unit of time; write s, min, h, d or "
                            "yr",
                            query.time_unit));
        factor = seconds->factor;
    }
    for (const NumberedFile& one : series) times.values.push_back(one.number * factor);
    if (!query.time_pattern.empty()) {
        times.origin = 0;
    } else if (query.time_unit.empty()) {
        times.counted = true;
        times.note = "times are the numbers in the files' names; --time-unit says what they count";
    }
    return times;
}

}  // namespace

ForeignRun read_raster_series(const std::string& name, const std::vector<fs::path>& files,
                              const ForeignQuery& query) {
    ForeignRun run;
    run.name = name;
    const std::vector<NumberedFile> series = in_order(files, query.time_pattern);
    std::vector<fs::path> ordered;
    for (const NumberedFile& one : series) {
        ordered.push_back(one.file);
        run.numbers.push_back(one.number);
    }
    const SeriesKind kind = kind_of(ordered.front());
    run.times = run_times(times_of(series, query), name);
    run.model = kind.model;
    run.dry = kind.dry;
    const RasterFile first = read_raster_file(ordered.front(), "", kind.quantity, query.cell_size);
    run.nx = first.values.nx();
    run.ny = first.values.ny();
    run.scale = first.scale;
    if (!first.note.empty()) run.notes.push_back(first.note);
    if (!run.times.note.empty()) run.notes.push_back(run.times.note);
    run.title = fs::path(name).stem().string();
    std::erase_if(run.title, [](char letter) { return letter == '*' || letter == '?'; });
    while (!run.title.empty() && std::ispunct(static_cast<unsigned char>(run.title.back())) != 0)
        run.title.pop_back();
    ForeignField field{kind.quantity, name, "", "", kind.reason, ordered.size() > 1, false, {}};
    field.read = [ordered, quantity = kind.quantity,
                  cell_size = query.cell_size](std::size_t record) {
        return read_raster_file(ordered.at(record), "", quantity, cell_size).values;
    };
    run.fields.push_back(std::move(field));
    run.files = ordered;
    for (const std::string& scalar : query.scalars)
        if (scalar != "water_depth" && scalar != "concentration")
            throw InputError(
                fmt::format("{}: has no map \"{}\" to colour by; a series of rasters "
                            "has the fields water_depth and concentration alone",
                            name, scalar));
    for (const std::string& text : query.fields) {
        const FieldRequest request = field_request(text);
        if (run.find(request.quantity) != nullptr)
            throw InputError(fmt::format("--field {}: {} is the {} already", text, name,
                                         facts_of(request.quantity).name));
        if (!is_file_request(request.source))
            throw InputError(fmt::format(
                "--field {}: rasters have no variables; name a file or a pattern of files", text));
        add_field_of_file(run, request.quantity, request.source, query);
    }
    const bool has_both =
        run.find(Quantity::depth) != nullptr && run.find(Quantity::level) != nullptr;
    if (run.find(Quantity::bed) == nullptr && !has_both)
        throw InputError(fmt::format("{}: holds {}s and no bed; name one by --field bed=FILE", name,
                                     facts_of(kind.quantity).name));
    return run;
}

}  // namespace fumon
