#include "foreign/netcdf_run.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "files/netcdf/netcdf_input.h"
#include "files/unit_conversion.h"
#include "foreign/field_choice.h"
#include "foreign/field_files.h"
#include "foreign/mesh_maps.h"
#include "foreign/mesh_volume.h"
#include "foreign/netcdf_place.h"
#include "foreign/netcdf_times.h"
#include "foreign/records_ahead.h"
#include "foreign/run_times.h"
#include "foreign/variable_names.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// The library's failure as a fault of the file.
template <class Work>
auto reading(const fs::path& file, const Work& work) {
    const NetcdfLock lock;
    try {
        return work();
    } catch (const NetcdfFault& fault) {
        throw InputError(fmt::format(
            "{}: cannot be read as NetCDF: {}; it may be cut short, damaged, or still being "
            "written: copy it again",
            file.string(), fault.what()));
    }
}

/// Where a run's records lie.
struct RecordPlace {
    std::size_t file = 0;
    std::size_t record = 0;  ///< of the file, from 0
};

struct RunRecords {
    std::vector<fs::path> files;
    std::vector<RecordPlace> places;
    std::vector<std::uintmax_t> sizes{};  ///< of the files when they were opened, bytes
};

std::uintmax_t size_of(const fs::path& file) {
    std::error_code fault;
    return fs::file_size(file, fault);
}

/// Refuses a file that its model still writes.
void check_unchanged(const RunRecords& records, std::size_t file) {
    const std::uintmax_t now = size_of(records.files[file]);
    if (now == records.sizes[file]) return;
    throw InputError(fmt::format(
        "{}: had {} bytes when it was opened and has {} now; let its run end, or copy the file and "
        "take the copy",
        records.files[file].string(), records.sizes[file], now));
}

void refuse_other_layouts(const NetcdfInput& input) {
    if (input.variables() > 0) return;
    int groups = 0;
    check_netcdf(nc_inq_grps(input.id(), &groups, nullptr));
    input.refuse(groups > 0 ? "is HDF5 with groups, and no map in its root" : "holds no variable",
                 "write the maps as NetCDF; of HEC-RAS export depth and terrain as GeoTIFF (RAS "
                 "Mapper: Results, Export Layer) and open them as a series");
}

/// What of a file may be a field.
struct FileMaps {
    std::optional<MeshLayout> mesh;
    int records = -1;  ///< the dimension of its records
    std::vector<ForeignMap> maps;
};

FileMaps maps_of_file(const NetcdfInput& input) {
    FileMaps file{find_mesh(input), -1, {}};
    file.records = file.mesh ? records_of_mesh(input, *file.mesh) : dimension_of_records(input);
    file.maps =
        file.mesh ? maps_of_mesh(input, *file.mesh, file.records) : maps_of(input, file.records);
    return file;
}

RawTimes times_of_file(const NetcdfInput& input, const std::string& unit) {
    const std::optional<MeshLayout> mesh = find_mesh(input);
    const int records = mesh ? records_of_mesh(input, *mesh) : dimension_of_records(input);
    if (records < 0) return RawTimes{{0.0}, true, {}, {}, {}};
    if (mesh) return times_of_mesh(input, *mesh, records, unit);
    const bool own = input.find_variable("bed_height") && input.find_variable("step");
    return netcdf_times(input, records, own ? "time" : "", unit);
}

/// What a user named for each quantity: variables of the file, and other files.
struct NamedFields {
    std::map<Quantity, std::string> variables;
    std::map<Quantity, std::string> files;
};

NamedFields named_fields(const ForeignQuery& query) {
    NamedFields named;
    for (const std::string& text : query.fields) {
        const FieldRequest request = field_request(text);
        (is_file_request(request.source) ? named.files : named.variables)[request.quantity] =
            request.source;
    }
    return named;
}

/// Where the maps of a run lie: on cells of their own, or on a mesh.
struct MapsPlace {
    NetcdfPlace cells;
    std::shared_ptr<const LaidMesh> mesh{};
};

/// Heights that stand for none in most rasters, whether a file says so or not: Landlab keeps those
/// of the raster that it began with.
void clear_usual_fill(std::span<double> values) {
    for (double& value : values)
        if (value == -9999.0 || value == -99999.0) value = std::numeric_limits<double>::quiet_NaN();
}

/// A record of a file's map in its own numbers.
Grid read_record(const NetcdfInput& input, const ForeignMap& map, bool is_bed,
                 const MapsPlace& place, std::size_t record, RecordsAhead& ahead) {
    if (place.mesh) {
        std::vector<double> values = place.mesh->values(input, map, record);
        if (is_bed) clear_usual_fill(values);
        return place.mesh->laid(map, values);
    }
    const std::int64_t number =
        map.variable.has_records ? static_cast<std::int64_t>(record) + 1 : 0;
    const BedVariable chosen = choose_bed_variable(input, map.variable.name, {number});
    Grid values = read_map(
        input, chosen, place.cells,
        [&](std::span<const std::size_t> start, std::span<const std::size_t> count, double* cells) {
            ahead.read(input, chosen.variable, chosen.records, start, count, cells);
        });
    if (is_bed) clear_usual_fill(values.values());
    return values;
}

/// Reads a chosen map; one that does not change is kept.
std::function<Grid(std::size_t)> reader_of(const std::shared_ptr<const RunRecords>& records,
                                           const ChosenMap& chosen, const MapsPlace& place,
                                           const UnitConversion& conversion) {
    const ForeignMap& map = chosen.map;
    const bool is_bed = chosen.quantity == Quantity::bed;
    const auto ahead = std::make_shared<RecordsAhead>();
    const auto read = [records, place, conversion, map, is_bed, ahead](std::size_t number) {
        const RecordPlace at = map.over_time ? records->places.at(number) : RecordPlace{};
        const fs::path& file = records->files[at.file];
        check_unchanged(*records, at.file);
        return reading(file, [&] {
            const NetcdfInput input(file);
            Grid values = read_record(input, map, is_bed, place, at.record, *ahead);
            for (double& value : values.values()) value = conversion(value);
            return values;
        });
    };
    if (map.over_time) return read;
    return [read, kept = std::make_shared<Grid>()](std::size_t number) {
        if (kept->empty()) *kept = read(number);
        return *kept;
    };
}

/// Times and records of all files, in the order of their times.
RawTimes all_times(const std::vector<fs::path>& files, const std::string& unit,
                   RunRecords& records) {
    struct Part {
        RawTimes times;
        std::size_t file;
    };
    std::vector<Part> parts;
    for (std::size_t file = 0; file < files.size(); ++file) {
        parts.push_back({reading(files[file],
                                 [&] {
                                     const NetcdfInput input(files[file]);
                                     return times_of_file(input, unit);
                                 }),
                         file});
    }
    RawTimes all = parts.front().times;
    all.values.clear();
    const bool counted = std::ranges::any_of(parts, [](const Part& p) { return p.times.counted; });
    const auto start_of = [&](const Part& part) {
        const double origin = static_cast<double>(part.times.origin.value_or(0));
        return part.times.values.empty() ? origin : origin + part.times.values.front();
    };
    if (!counted) std::ranges::stable_sort(parts, {}, start_of);
    for (std::size_t i = 1; i < parts.size() && !counted; ++i) {
        if (start_of(parts[i]) != start_of(parts[i - 1])) continue;
        throw InputError(fmt::format(
            "{}: begins at the time at which {} does; parts of one mesh have to be joined first "
            "(dfmoutput mapmerge), and runs side by side are named one by one",
            files[parts[i].file].string(), files[parts[i - 1].file].string()));
    }
    for (const Part& part : parts) {
        const bool dated = all.origin && part.times.origin;
        const double shift = dated ? static_cast<double>(*part.times.origin - *all.origin) : 0.0;
        const double base =
            counted && !all.values.empty() && files.size() > 1 ? all.values.back() + 1.0 : 0.0;
        for (std::size_t i = 0; i < part.times.values.size(); ++i) {
            all.values.push_back(counted && files.size() > 1 ? base + static_cast<double>(i)
                                                             : part.times.values[i] + shift);
            records.places.push_back({part.file, i});
        }
    }
    all.counted = counted;
    if (counted) all.origin.reset();
    return all;
}

/// The steps of fumon's own records.
void take_own_steps(const NetcdfInput& input, ForeignTimes& times) {
    const auto variable = input.find_variable("step");
    const int records = dimension_of_records(input);
    if (!variable || !input.find_variable("bed_height") || records < 0 ||
        !input.is_numeric(*variable) || input.dimensions(*variable) != std::vector<int>{records} ||
        input.dimension_length(records) != times.steps.size())
        return;
    std::vector<long long> steps(times.steps.size());
    check_netcdf(nc_get_var_longlong(input.id(), *variable, steps.data()));
    if (std::ranges::adjacent_find(steps, std::greater_equal<>()) != steps.end()) return;
    times.steps.assign(steps.begin(), steps.end());
}

bool is_by_compass(const ForeignMap& map) {
    return map.standard_name.find("eastward") != std::string::npos ||
           map.standard_name.find("northward") != std::string::npos;
}

/// "bed shear stress" of a variable's long_name, else of its own name.
std::string words_of_map(const NetcdfInput& input, const ForeignMap& map) {
    constexpr std::size_t longest = 60;
    std::string words = input.text(map.variable.variable, "long_name").value_or("");
    if (words.empty() || words.size() > longest) words = map.variable.name;
    std::string spaced;
    for (const char letter : words) {
        const bool space = letter == '_' || letter == ' ';
        if (!space || (!spaced.empty() && spaced.back() != ' ')) spaced += space ? ' ' : letter;
    }
    return spaced;
}

/// The map of a name that a user wants to see. Throws InputError, with those that there are.
const ForeignMap& scalar_map(const NetcdfInput& input, const std::vector<ForeignMap>& maps,
                             const std::string& name) {
    std::vector<std::string> known;
    for (const ForeignMap& map : maps) {
        if (map.variable.name == name) return map;
        known.push_back(map.variable.name);
    }
    throw InputError(fmt::format("{}: has no map \"{}\" to colour by; {}", input.name(), name,
                                 suggestion(name, known)));
}

/// Fields that a run with these quantities has by fumon's own names.
bool is_own_field(const std::string& name, const ForeignRun& run) {
    const bool of_water = name == "water_depth" || name == "velocity_x" || name == "velocity_y";
    return (of_water && run.has_water()) ||
           (name == "concentration" && run.find(Quantity::concentration) != nullptr);
}

MapsPlace cells_place(const NetcdfInput& input, const ForeignMap& sides, ForeignRun& run) {
    MapsPlace place{place_of_maps(input, sides.variable)};
    run.scale = place.cells.scale;
    run.turn = place.cells.turn;
    run.swapped = place.cells.swapped;
    run.columns_fall = place.cells.columns_fall;
    run.rows_fall = place.cells.rows_fall;
    run.nx = place.cells.nx;
    run.ny = place.cells.ny;
    if (!place.cells.note.empty()) run.notes.push_back(place.cells.note);
    return place;
}

MapsPlace mesh_place(const NetcdfInput& input, const MeshLayout& mesh, double cell,
                     ForeignRun& run) {
    MapsPlace place{{}, lay_mesh(input, mesh, cell)};
    run.scale = place.mesh->scale;
    run.nx = place.mesh->grid.nx();
    run.ny = place.mesh->grid.ny();
    run.notes = place.mesh->notes;
    return place;
}

std::string title_of(const NetcdfInput& input, const fs::path& file) {
    std::string title = input.text(NC_GLOBAL, "title").value_or("");
    constexpr std::size_t longest = 80;
    return title.empty() || title.size() > longest ? file.stem().string() : title;
}

}  // namespace

ForeignRun read_netcdf_run(const std::string& name, std::vector<fs::path> files,
                           const ForeignQuery& query) {
    ForeignRun run;
    run.name = name;
    const NamedFields named = named_fields(query);
    const auto records = std::make_shared<RunRecords>();
    records->files = files;
    for (const fs::path& file : files) records->sizes.push_back(size_of(file));
    const RawTimes times = all_times(files, query.time_unit, *records);
    if (times.values.empty())
        throw InputError(fmt::format("{}: has no record yet; let the run write one first", name));
    run.times = run_times(times, name);
    reading(files.front(), [&] {
        const NetcdfInput input(files.front());
        refuse_other_layouts(input);
        const FileMaps file = maps_of_file(input);
        const std::vector<ForeignMap>& maps = file.maps;
        std::string words = words_of_file(input);
        if (file.mesh) words += file.mesh->anuga ? " anuga" : " " + file.mesh->name;
        const ForeignModel* model = model_of_maps(words, maps);
        run.title = title_of(input, files.front());
        if (files.size() == 1 && !file.mesh) take_own_steps(input, run.times);
        if (model != nullptr) {
            run.dry = model->dry;
            if (model->name != "others") run.model = model->name;
        }
        const std::vector<ChosenMap> chosen = choose_maps(
            input.name(), maps, model, named.variables, named.files.contains(Quantity::bed));
        const ForeignMap& sides = chosen.empty() ? maps.front() : chosen.front().map;
        const MapsPlace place = file.mesh ? mesh_place(input, *file.mesh, query.cell_size, run)
                                          : cells_place(input, sides, run);
        for (const ChosenMap& one : chosen) {
            if (!file.mesh &&
                (one.map.variable.x != sides.variable.x || one.map.variable.y != sides.variable.y))
                input.refuse(
                    fmt::format("{} ({}) and {} ({}) lie on different grids", sides.variable.name,
                                sides.dimensions, one.map.variable.name, one.map.dimensions),
                    "all fields of a run need the same grid");
            run.fields.push_back(
                {one.quantity, one.map.variable.name, one.map.unit, one.map.dimensions, one.reason,
                 one.map.over_time, is_by_compass(one.map),
                 reader_of(records, one, place, conversion_of(input.name(), one))});
        }
        if (place.mesh) {
            std::size_t last = 0;
            for (const RecordPlace& at : records->places)
                if (at.file == 0) last = std::max(last, at.record);
            const std::string error =
                volume_note(*place.mesh, chosen, last, [&](const ChosenMap& one) {
                    std::vector<double> values =
                        place.mesh->values(input, one.map, one.map.over_time ? last : 0);
                    if (one.quantity == Quantity::bed) clear_usual_fill(values);
                    const UnitConversion conversion = conversion_of(input.name(), one);
                    for (double& value : values) value = conversion(value);
                    return values;
                });
            if (!error.empty()) run.notes.push_back(error);
        }
        for (const std::string& name : query.scalars) {
            if (is_own_field(name, run)) continue;
            const ForeignMap& map = scalar_map(input, maps, name);
            if (!file.mesh &&
                (map.variable.x != sides.variable.x || map.variable.y != sides.variable.y))
                input.refuse(
                    fmt::format("{} ({}) and {} ({}) lie on different grids", sides.variable.name,
                                sides.dimensions, name, map.dimensions),
                    "all fields of a run need the same grid");
            ChosenMap one;
            one.quantity = Quantity::concentration;  // any but the bed
            one.map = map;
            run.scalars.push_back({name, words_of_map(input, map), map.unit, map.over_time,
                                   reader_of(records, one, place, UnitConversion{})});
        }
        for (const ForeignMap& map : maps) {
            if (std::ranges::none_of(chosen, [&](const ChosenMap& one) {
                    return one.map.variable.name == map.variable.name;
                }))
                run.others.push_back(fmt::format("{} ({})", map.variable.name, map.dimensions));
        }
        return 0;
    });
    run.files = std::move(files);
    if (!run.times.note.empty()) run.notes.push_back(run.times.note);
    for (const auto& [quantity, source] : named.files)
        add_field_of_file(run, quantity, source, query);
    return run;
}

}  // namespace fumon
