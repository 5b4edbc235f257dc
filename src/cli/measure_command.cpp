#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "base/error.h"
#include "base/limits.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "cli/snapshot_argument.h"
#include "files/avalanche_table.h"
#include "files/csv_table.h"
#include "files/netcdf/netcdf_record.h"
#include "files/terrain/terrain_format.h"
#include "foreign/file_numbers.h"
#include "foreign/open_run.h"
#include "measure/pile/avalanche_report.h"
#include "measure/suite.h"
#include "run/inputs/scene_argument.h"
#include "run/inputs/standard_input.h"

namespace fumon {

namespace {

struct MeasureOptions {
    std::string bed;
    std::string heights;      ///< "low:high", metres of black and white of a PNG terrain
    std::string as;           ///< "bed", "profile", "pile"; empty: by the bed's rows
    bool open_edges = false;  ///< the bed ends at its edges
    std::vector<int> drop;    ///< x and y of a pile's drop site; empty: its middle
    std::string earlier;      ///< a bed of the same run, for celerity
    std::int64_t steps_between = 0;
    std::string window;         ///< "low:high", cells: where avalanche sizes are fitted
    double channel_area = 0.0;  ///< of the network; 0: none
    bool as_json = false;
    ForeignQuery foreign;
    std::vector<std::string> settings;
};

void declare(CLI::App& command, MeasureOptions& options) {
    command
        .add_option("BED", options.bed,
                    terrain_titles() +
                        " (a run's fields.nc: its last record, water too); or a run's "
                        "avalanches.csv; - is terrain on standard input; of the results of another "
                        "model (NetCDF, or 'PATTERN*' of files) with several records a row each")
        ->required();
    command.add_flag("--json", options.as_json, "as JSON");
    add_word(command, "--as", options.as, {"bed", "profile", "pile"},
             "bed, profile or pile (default: one row is a profile; a fields.nc shows "
             "whether it is water or a pile)")
        ->type_name("KIND");
    command.add_flag("--open", options.open_edges,
                     "the bed ends at its edges (default: periodic, as in the sand models)");
    command.add_option("--drop", options.drop, "the cell on which a pile's grains fell")
        ->type_name("X Y")
        ->expected(2)
        ->check([](const std::string& text) {
            return number_fault(text, true, 0, largest_grid_side - 1);
        });
    auto* earlier = command
                        .add_option("--earlier", options.earlier,
                                    "a bed of the same run before this one: for celerity")
                        ->type_name("BED");
    add_number(command, "--steps", options.steps_between, 1, largest_step,
               "steps between the two beds")
        ->type_name("N")
        ->needs(earlier);
    command
        .add_option("--window", options.window,
                    "sizes over which avalanches.csv is fitted (default 10:100)")
        ->type_name("LOW:HIGH");
    constexpr double largest_area = 1e15;
    add_number(command, "--channel-area", options.channel_area, 0, largest_area,
               "also the network of channels through which at least this area drains, m2")
        ->type_name("AREA");
    add_heights(command, options.heights);
    add_foreign_options(command, options.foreign);
    add_settings(command, options.settings,
                 "override a scene key, as grid.cell_size or bed.nodata (repeatable)");
    add_examples(
        command,
        {{"fumon measure out/run/fields.nc", "the last record of a run"},
         {"fumon measure terrain.asc --open --json", "a terrain file, for a program"},
         {"fumon measure terrain.asc --channel-area 1e6", "its streams: orders, spacing, density"},
         {"fumon measure late.asc --earlier early.asc --steps 100", "how fast crests move"},
         {"fumon measure flood.nc", "the results of another model, a row a record"},
         {"fumon measure out/run/avalanches.csv --window 10:100",
          "how avalanche sizes are spread"}},
        "Lengths are in metres where the file has them, else in sites; \"undefined\" is what has "
        "no "
        "meaning\nfor this bed. `fumon run` writes the same measures over time into "
        "measurements.csv.");
}

Snapshot read_bed(const MeasureOptions& options, const std::string& file) {
    Snapshot snapshot = read_snapshot(terrain_argument(file), options.heights, options.settings);
    snapshot.periodic = snapshot.periodic && !options.open_edges;
    return snapshot;
}

Landform landform(const MeasureOptions& options, const Snapshot& snapshot) {
    if (options.as == "pile") return Landform::pile;
    if (options.as == "bed") return Landform::bed;
    if (options.as == "profile") {
        if (snapshot.bed.ny() == 1) return Landform::profile;
        throw InputError(fmt::format("--as profile: {} has {} rows; a profile has one", options.bed,
                                     snapshot.bed.ny()));
    }
    return measured_landform(snapshot);
}

void place_drop_site(const MeasureOptions& options, Snapshot& snapshot) {
    if (options.drop.empty()) return;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const int cells = axis == 0 ? snapshot.bed.nx() : snapshot.bed.ny();
        if (options.drop[axis] >= cells) {
            throw InputError(fmt::format("--drop {} {} lies outside the {} x {} cells of {}",
                                         options.drop[0], options.drop[1], snapshot.bed.nx(),
                                         snapshot.bed.ny(), options.bed));
        }
    }
    std::erase_if(snapshot.numbers, [](const SnapshotNumber& number) {
        return number.name == "drop_x" || number.name == "drop_y";
    });
    snapshot.numbers.push_back({"drop_x", "cells", static_cast<double>(options.drop[0])});
    snapshot.numbers.push_back({"drop_y", "cells", static_cast<double>(options.drop[1])});
}

std::vector<MeasuredValue> measured(const MeasureOptions& options) {
    Snapshot bed = read_bed(options, options.bed);
    place_drop_site(options, bed);
    const Landform measured_as = landform(options, bed);
    if (!options.as.empty()) bed.landform = measured_as;
    MeasureSuite suite(measured_as, bed, {options.channel_area});
    std::vector<double> values;
    if (options.earlier.empty()) {
        values = suite.row(bed);
    } else {
        const Snapshot earlier = read_bed(options, options.earlier);
        if (earlier.bed.nx() != bed.bed.nx() || earlier.bed.ny() != bed.bed.ny()) {
            throw InputError(
                fmt::format("{} has {} x {} cells and {} has {} x {}; celerity needs "
                            "two beds of the same size",
                            options.earlier, earlier.bed.nx(), earlier.bed.ny(), options.bed,
                            bed.bed.nx(), bed.bed.ny()));
        }
        static_cast<void>(suite.row(earlier));
        bed.step = options.steps_between;
        values = suite.row(bed);
    }
    std::vector<MeasuredValue> all;
    for (std::size_t k = 0; k < values.size(); ++k)
        all.push_back(in_world_units({suite.columns()[k], values[k]}, bed.scale));
    return all;
}

std::string as_text(const std::vector<MeasuredValue>& all) {
    std::string text;
    for (const MeasuredValue& one : all) {
        const std::string value =
            std::isnan(one.value) ? "undefined" : fmt::format("{:.6g}", one.value);
        text += fmt::format("{:<32} {:>12} {:<16} {}\n", one.column.name, value, one.column.unit,
                            one.column.help);
    }
    return text;
}

std::string as_json(const MeasureOptions& options, const std::vector<MeasuredValue>& all) {
    nlohmann::ordered_json json;
    json["file"] = options.bed;
    json["measures"] = nlohmann::ordered_json::array();
    for (const MeasuredValue& one : all) {
        json["measures"].push_back(
            {{"name", one.column.name},
             {"value", std::isnan(one.value) ? nlohmann::ordered_json(nullptr)
                                             : nlohmann::ordered_json(one.value)},
             {"unit", one.column.unit},
             {"help", one.column.help}});
    }
    return json.dump(2) + "\n";
}

SizeWindow parse_window(const std::string& text) {
    if (text.empty()) return {};
    SizeWindow window;
    char rest = '\0';
    long long low = 0;
    long long high = 0;
    if (std::sscanf(text.c_str(), "%lld:%lld%c", &low, &high, &rest) != 2) {
        throw InputError(fmt::format(
            "--window is \"{}\"; it takes low:high in cells, for example 10:100", text));
    }
    window.low = low;
    window.high = high;
    return window;
}

int measure_avalanches(const MeasureOptions& options) {
    AvalancheSizes sizes;
    sizes.add(read_avalanches(options.bed));
    const AvalancheFits fits = fit_avalanches(sizes, parse_window(options.window));
    const std::string text =
        options.as_json ? avalanche_json(options.bed, sizes, fits) : avalanche_text(sizes, fits);
    std::fputs(text.c_str(), stdout);
    return 0;
}

/// Another model's run of several records, unless options speak of one bed.
std::optional<ForeignRun> foreign_series(const MeasureOptions& options) {
    std::error_code fault;
    const std::string& name = options.bed;
    const bool asked = !options.foreign.fields.empty() || is_pattern(name);
    const bool of_bed = !options.settings.empty() || !options.as.empty() ||
                        !options.earlier.empty() || !options.drop.empty();
    if (!is_foreign_run(name) || (!asked && of_bed)) return std::nullopt;
    if (!asked && std::filesystem::is_regular_file(name, fault) && is_fields_file(name))
        return std::nullopt;
    ForeignRun run = open_foreign_run(name, options.foreign);
    if (!asked && run.times.times.size() == 1 && !run.has_water()) return std::nullopt;
    return run;
}

/// A row a record, as measurements.csv has them, with the date where there is one.
int measure_records(const MeasureOptions& options, const ForeignRun& run) {
    if (options.as_json) throw InputError("--json: is of one bed; records are a table (CSV)");
    const Snapshot first = foreign_snapshot(run, 0);
    MeasureSuite suite(measured_landform(first), first,
                       {options.channel_area, first.scale.in_metres});
    std::vector<std::string> cells{"step", fmt::format("time_{}", run.times.unit)};
    if (run.times.date) cells.emplace_back("date");
    for (const MeasureColumn& column : suite.columns())
        cells.push_back(in_world_units({column, 0.0}, first.scale).column.name);
    std::fputs(csv_line(cells).c_str(), stdout);
    for (std::size_t record = 0; record < run.times.times.size(); ++record) {
        const Snapshot bed = foreign_snapshot(run, record);
        const std::vector<double> values = suite.row(bed);
        cells = {fmt::format("{}", bed.step), csv_number(bed.time)};
        if (run.times.date) cells.push_back(run.times.date(bed.time));
        for (std::size_t k = 0; k < values.size(); ++k)
            cells.push_back(
                csv_number(in_world_units({suite.columns()[k], values[k]}, bed.scale).value));
        std::fputs(csv_line(cells).c_str(), stdout);
    }
    return 0;
}

int perform(const MeasureOptions& asked) {
    MeasureOptions options = asked;
    std::optional<StandardInput> given;
    if (is_standard_input(options.bed)) {
        given.emplace();
        options.bed = given->terrain().string();
    }
    if (std::filesystem::path(options.bed).extension() == ".csv")
        return measure_avalanches(options);
    if (options.earlier.empty() != (options.steps_between == 0)) {
        throw InputError(
            "fumon measure: --earlier and --steps go together: an earlier bed and the steps "
            "between the two");
    }
    if (!given) {
        if (const std::optional<ForeignRun> run = foreign_series(options))
            return measure_records(options, *run);
    }
    const std::vector<MeasuredValue> all = measured(options);
    options.bed = asked.bed;
    std::fputs((options.as_json ? as_json(options, all) : as_text(all)).c_str(), stdout);
    return 0;
}

}  // namespace

Command measure_command() {
    return make_command<MeasureOptions>(
        "measure", "measure a bed: wavelength, crests, dunes, slopes, a pile's cone, water",
        declare, perform);
}

}  // namespace fumon
