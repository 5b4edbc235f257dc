#include "foreign/netcdf_run.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.h"
#include "files/netcdf/netcdf_input.h"
#include "files/terrain/wanted_unit.h"
#include "files/unit_conversion.h"
#include "foreign/field_choice.h"
#include "foreign/field_files.h"
#include "foreign/netcdf_place.h"
#include "foreign/netcdf_times.h"
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
};

void refuse_other_layouts(const NetcdfInput& input) {
    for (int variable = 0; variable < input.variables(); ++variable) {
        if (input.text(variable, "cf_role").value_or("") == "mesh_topology")
            input.refuse("holds polygons (UGRID), which are not read",
                         "lay them on a raster first (xugrid: "
                         "OverlapRegridder; Delft3D FM: output of maps on a grid)");
    }
    if (input.find_variable("volumes") && input.find_variable("xllcorner") == std::nullopt &&
        input.find_variable("elevation") && input.find_variable("stage"))
        input.refuse("holds ANUGA's triangles, which are not read",
                     "write rasters of it by anuga.sww2dem and open them as a series");
    if (input.variables() > 0) return;
    int groups = 0;
    check_netcdf(nc_inq_grps(input.id(), &groups, nullptr));
    input.refuse(groups > 0 ? "is HDF5 with groups, and no map in its root" : "holds no variable",
                 "write the maps as NetCDF; of HEC-RAS export depth and terrain as GeoTIFF (RAS "
                 "Mapper: Results, Export Layer) and open them as a series");
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

/// From the file's numbers to fumon's, of an unpacked map.
UnitConversion conversion_of(const NetcdfInput& input, const ChosenMap& chosen) {
    const QuantityFacts& facts = facts_of(chosen.quantity);
    const std::string& unit = chosen.map.unit;
    UnitConversion conversion;
    if (!unit.empty() && unit != "-" && unit != "?" && unit != "1") {
        std::optional<UnitConversion> known;
        if (facts.unit == "m") {
            if (const auto metres = metres_per_height(unit)) known = UnitConversion{*metres};
        } else {
            known = unit_conversion(unit, facts.unit);
        }
        if (!known)
            input.refuse(fmt::format("{} is in \"{}\", and cannot be its {}",
                                     chosen.map.variable.name, unit, facts.name),
                         fmt::format("a {} becomes {}; name another by --field {}=NAME", facts.name,
                                     facts.unit, facts.key));
        conversion = *known;
    }
    const int variable = chosen.map.variable.variable;
    const std::string positive = input.text(variable, "positive").value_or("");
    const bool down =
        chosen.quantity == Quantity::bed && (grows_downward(positive, chosen.map.standard_name) ||
                                             (positive.empty() && chosen.grows_downward));
    if (down) {
        conversion.factor = -conversion.factor;
        conversion.offset = -conversion.offset;
    }
    return conversion;
}

/// Reads a chosen map; one that does not change is kept.
std::function<Grid(std::size_t)> reader_of(const std::shared_ptr<const RunRecords>& records,
                                           const ChosenMap& chosen, const NetcdfPlace& place,
                                           const UnitConversion& conversion) {
    const auto read = [records, place, conversion, name = chosen.map.variable.name,
                       has_records = chosen.map.variable.has_records,
                       over_time = chosen.map.over_time](std::size_t number) {
        const RecordPlace at = over_time ? records->places.at(number) : RecordPlace{};
        const fs::path& file = records->files[at.file];
        return reading(file, [&] {
            const NetcdfInput input(file);
            const auto record = static_cast<std::int64_t>(at.record) + 1;
            Grid values = read_map(
                input, choose_bed_variable(input, name, {has_records ? record : 0}), place);
            for (double& value : values.values()) value = conversion(value);
            return values;
        });
    };
    if (chosen.map.over_time) return read;
    return [read, kept = std::make_shared<Grid>()](std::size_t number) {
        if (kept->empty()) *kept = read(number);
        return *kept;
    };
}

/// Times and records of all files, in the order of their times.
RawTimes all_times(const std::vector<fs::path>& files, RunRecords& records) {
    struct Part {
        RawTimes times;
        std::size_t file;
    };
    std::vector<Part> parts;
    for (std::size_t file = 0; file < files.size(); ++file) {
        parts.push_back({reading(files[file],
                                 [&] {
                                     const NetcdfInput input(files[file]);
                                     const int dimension = dimension_of_records(input);
                                     if (dimension < 0) return RawTimes{{0.0}, true, {}, {}, {}};
                                     const bool own = input.find_variable("bed_height") &&
                                                      input.find_variable("step");
                                     return netcdf_times(input, dimension, own ? "time" : "");
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
    const RawTimes times = all_times(files, *records);
    if (times.values.empty())
        throw InputError(fmt::format("{}: has no record yet; let the run write one first", name));
    run.times = run_times(times, name);
    reading(files.front(), [&] {
        const NetcdfInput input(files.front());
        refuse_other_layouts(input);
        const std::vector<ForeignMap> maps = maps_of(input, dimension_of_records(input));
        const ForeignModel* model = model_of_file(input, maps);
        run.title = title_of(input, files.front());
        if (files.size() == 1) take_own_steps(input, run.times);
        if (model != nullptr) {
            run.dry = model->dry;
            if (model->name != "others") run.model = model->name;
        }
        const std::vector<ChosenMap> chosen =
            choose_maps(input, maps, model, named.variables, named.files.contains(Quantity::bed));
        const ForeignMap& sides = chosen.empty() ? maps.front() : chosen.front().map;
        const NetcdfPlace place = place_of_maps(input, sides.variable);
        run.scale = place.scale;
        if (!place.note.empty()) run.notes.push_back(place.note);
        run.nx = place.nx;
        run.ny = place.ny;
        for (const ChosenMap& one : chosen) {
            if (one.map.variable.x != sides.variable.x || one.map.variable.y != sides.variable.y)
                input.refuse(
                    fmt::format("{} ({}) and {} ({}) lie on different grids", sides.variable.name,
                                sides.dimensions, one.map.variable.name, one.map.dimensions),
                    "all fields of a run need the same grid");
            run.fields.push_back({one.quantity, one.map.variable.name, one.map.unit,
                                  one.map.dimensions, one.reason, one.map.over_time,
                                  reader_of(records, one, place, conversion_of(input, one))});
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
