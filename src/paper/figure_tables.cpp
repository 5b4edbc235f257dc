#include "paper/figure_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <any>
#include <array>
#include <limits>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "base/worker_pool.h"
#include "files/avalanche_table.h"
#include "files/input_file.h"
#include "measure/pile/avalanche_sizes.h"
#include "measure/shared/undefined.h"
#include "measure/suite.h"
#include "models/air/airflow_parameters.h"
#include "models/air/grain_flight.h"
#include "models/registry.h"
#include "paper/store/results.h"
#include "scene/uses_metres.h"

namespace fumon {

namespace {

std::string length_name(const WorldScale& scale) {
    return scale.in_metres ? "m" : "sites";
}

Table columns(const std::vector<std::pair<std::string, std::string>>& names) {
    Table table;
    for (const auto& [name, unit] : names) table.columns.push_back({name, unit});
    return table;
}

Table measurement_columns(const Scene& scene, const Snapshot& first) {
    Table table =
        columns({{"step", ""}, {"time", first.time_unit == "steps" ? "" : first.time_unit}});
    const MeasureSuite suite(measured_landform(first), first,
                             {scene.output.channel_area, uses_metres(scene)});
    for (const MeasureColumn& column : suite.columns())
        table.columns.push_back({column.name, column.unit});
    return table;
}

Table section_columns(const Snapshot& first) {
    if (!first.section)
        throw InputError(
            fmt::format("needs a model with a section ({})", models_of(Landform::air)));
    Table table = columns({{"x", "m"}});
    for (const SectionCurve& curve : first.section->curves)
        table.columns.push_back({curve.name, curve.unit == "1" ? "" : curve.unit});
    return table;
}

Table profile_columns(const Snapshot& first) {
    Table table = columns(
        {{"x", length_name(first.scale)}, {"height", first.scale.in_metres ? "m" : "heights"}});
    for (const SnapshotField& field : first.fields)
        table.columns.push_back({field.name, field.unit == "1" ? "" : field.unit});
    if (field_of(first.fields, "water_depth") != nullptr)
        table.columns.push_back({"water_level", "m"});
    return table;
}

Table avalanche_columns(const Snapshot& first, CurveTable table) {
    if (first.landform != Landform::pile)
        throw InputError(
            fmt::format("needs a model with avalanches ({})", models_of(Landform::pile)));
    if (table == CurveTable::avalanche_sizes)
        return columns({{"size", "cells"}, {"avalanches", ""}, {"share", ""}});
    return columns(
        {{"grain", ""}, {"size", "cells"}, {"duration", ""}, {"topplings", ""}, {"lost", ""}});
}

std::vector<Avalanche> avalanches_of(const RunStore& store, const StoredRun& run) {
    if (!std::filesystem::exists(store.avalanches(run))) return {};  // there was none
    return read_avalanches(store.avalanches(run));
}

Table avalanche_rows(const std::vector<Avalanche>& avalanches, Table table) {
    for (const Avalanche& avalanche : avalanches) {
        const std::array<std::int64_t, 5> cells{avalanche.grain, avalanche.size, avalanche.duration,
                                                avalanche.topplings, avalanche.lost};
        for (std::size_t k = 0; k < cells.size(); ++k)
            table.columns[k].values.push_back(static_cast<double>(cells[k]));
    }
    return table;
}

Table size_rows(const AvalancheSizes& sizes, Table table) {
    for (const SizeBin& bin : sizes.bins()) {
        table.columns[0].values.push_back(static_cast<double>(bin.size));
        table.columns[1].values.push_back(static_cast<double>(bin.count));
        table.columns[2].values.push_back(bin.share);
    }
    return table;
}

Table profile_rows(const Snapshot& snapshot, Table table) {
    const int middle = snapshot.bed.ny() / 2;
    const auto row = snapshot.bed.row(middle);
    for (std::size_t i = 0; i < row.size(); ++i) {
        table.columns[0].values.push_back((static_cast<double>(i) + 0.5) * snapshot.scale.dx);
        table.columns[1].values.push_back(row[i] * snapshot.scale.height_unit);
    }
    for (std::size_t k = 0; k < snapshot.fields.size(); ++k) {
        const auto values = snapshot.fields[k].values.row(middle);
        table.columns[k + 2].values.assign(values.begin(), values.end());
    }
    if (const Grid* depth = field_of(snapshot.fields, "water_depth")) {
        std::vector<double>& levels = table.columns.back().values;
        levels = table.columns[1].values;
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i] += depth->row(middle)[i];
    }
    if (snapshot.nodata.empty()) return table;
    const auto outside = snapshot.nodata.row(middle);
    for (std::size_t k = 1; k < table.columns.size(); ++k) {
        for (std::size_t i = 0; i < outside.size(); ++i) {
            if (outside[i] != 0) table.columns[k].values[i] = undefined;
        }
    }
    return table;
}

Table section_rows(const Snapshot& snapshot, Table table) {
    const SnapshotSection& section = *snapshot.section;
    for (int i = 0; i < snapshot.bed.nx(); ++i) table.columns[0].values.push_back(i * section.dx);
    for (std::size_t k = 1; k < table.columns.size(); ++k)
        table.columns[k].values = section.curves[k - 1].values;
    return table;
}

Table flight_rows(const Snapshot& snapshot, const AirflowParameters& parameters, Table table) {
    WorkerPool pool(1);
    const GrainFlights grains(*snapshot.section, parameters.flight,
                              {parameters.density, parameters.viscosity}, pool);
    const std::vector<Flight> flights =
        grains.fly(grains.every_column(parameters.flight.launch_angles));
    double lowest = std::numeric_limits<double>::infinity();
    for (const Flight& flight : flights) lowest = std::min(lowest, flight.height);
    for (const Flight& flight : flights) {
        const std::array<double, 8> cells{flight.x,     flight.height,  flight.height - lowest,
                                          flight.slope, flight.angle,   flight.length,
                                          flight.time,  flight.reynolds};
        for (std::size_t k = 0; k < cells.size(); ++k) table.columns[k].values.push_back(cells[k]);
    }
    return table;
}

/// Measurements, with the columns of `known` in their order.
Table measurement_rows(const std::filesystem::path& file, const Table& known) {
    const std::string text = read_input_file(file);
    Table read = parse_csv_table({file.string(), text});
    if (read.names() != known.names())
        throw InputError(
            fmt::format("{}: has other columns than this run; delete its folder", file.string()));
    for (std::size_t k = 0; k < read.columns.size(); ++k)
        read.columns[k].unit = known.columns[k].unit;
    return read;
}

/// The snapshot of a run at the curve's step.
Table snapshot_rows(const CurvePlan& curve, const StoredRun& run, const RunStore& store,
                    const Table& known) {
    const Snapshot snapshot = store.snapshot(run, curve.step);
    switch (curve.settings.table) {
        case CurveTable::section:
            return section_rows(snapshot, known);
        case CurveTable::flights:
            return flight_rows(snapshot,
                               std::any_cast<const AirflowParameters&>(run.scene.model.parameters),
                               known);
        default:
            return profile_rows(snapshot, known);
    }
}

Table rows_of(const CurvePlan& curve, const StoredRun& run, const RunStore& store,
              const Table& known) {
    switch (curve.settings.table) {
        case CurveTable::measurements:
            return measurement_rows(store.measurements(run), known);
        case CurveTable::avalanches:
            return avalanche_rows(avalanches_of(store, run), known);
        default:
            return snapshot_rows(curve, run, store, known);
    }
}

bool is_of_combination(const SweepPlan& plan, std::size_t run, std::size_t first) {
    return run < plan.runs.size() && plan.runs[run].combination == plan.runs[first].combination;
}

}  // namespace

Table curve_columns(CurveTable table, const Scene& scene, const Snapshot& first) {
    switch (table) {
        case CurveTable::measurements:
            return measurement_columns(scene, first);
        case CurveTable::avalanches:
        case CurveTable::avalanche_sizes:
            return avalanche_columns(first, table);
        case CurveTable::section:
            return section_columns(first);
        case CurveTable::flights:
            section_columns(first);
            return columns({{"x", "m"},
                            {"height", "m"},
                            {"height_above_lowest", "m"},
                            {"slope", ""},
                            {"angle", "degrees"},
                            {"length", "m"},
                            {"time", "s"},
                            {"reynolds", ""}});
        default:
            return profile_columns(first);
    }
}

Table results_table(CurveTable table, const Scene& scene, const ForeignRun& results,
                    std::int64_t step) {
    if (table == CurveTable::profile) {
        const Snapshot snapshot = snapshot_of_results(results, step);
        return profile_rows(snapshot, profile_columns(snapshot));
    }
    if (table != CurveTable::measurements)
        throw InputError("results of other models have measurements and profiles alone");
    const Snapshot first = foreign_snapshot(results, 0);
    Table rows =
        columns({{"step", ""}, {"time", first.time_unit == "steps" ? "" : first.time_unit}});
    MeasureSuite suite(measured_landform(first), first,
                       {scene.output.channel_area, first.scale.in_metres});
    for (const MeasureColumn& column : suite.columns())
        rows.columns.push_back({column.name, column.unit});
    for (std::size_t record = 0; record < results.times.steps.size(); ++record) {
        const std::vector<double> values = suite.row(foreign_snapshot(results, record));
        rows.columns[0].values.push_back(static_cast<double>(results.times.steps[record]));
        rows.columns[1].values.push_back(results.times.times[record]);
        for (std::size_t k = 0; k < values.size(); ++k)
            rows.columns[k + 2].values.push_back(values[k]);
    }
    return rows;
}

Table curve_table(const CurvePlan& curve, const FigureRuns& runs, const RunStore& store) {
    if (!curve.sweep) return curve.table;
    const SweepPlan& plan = *curve.sweep;
    const std::vector<std::string> keys = varied_keys(plan);
    Table known = curve.table;  // without the columns that stand before a run's own
    known.columns.erase(known.columns.begin(),
                        known.columns.begin() + static_cast<std::ptrdiff_t>(keys.size() + 1));
    const bool pools = curve.settings.table == CurveTable::avalanche_sizes;
    Table all;
    for (std::size_t k = 0; k < plan.runs.size(); ++k) {
        const std::size_t first = k;
        Table rows;
        if (pools) {
            AvalancheSizes sizes;
            for (k = first; is_of_combination(plan, k, first); ++k)
                sizes.add(avalanches_of(store, runs[curve.runs[k]]));
            rows = size_rows(sizes, known);
            --k;
        } else {
            rows = rows_of(curve, runs[curve.runs[k]], store, known);
        }
        const std::vector<std::string> values = values_of(plan, plan.runs[k]);
        Table part;
        for (std::size_t key = 0; key < keys.size(); ++key) {
            part.columns.push_back(even_column(keys[key], values[key], rows.rows()));
            part.columns.back().unit = curve.table.columns[key].unit;
        }
        const std::string seeds =
            k == first ? fmt::format("{}", plan.runs[k].seed)
                       : fmt::format("{}:{}", plan.runs[first].seed, plan.runs[k].seed);
        part.columns.push_back(even_column("seed", seeds, rows.rows()));
        part.columns.insert(part.columns.end(), rows.columns.begin(), rows.columns.end());
        all.append(part);
    }
    return all;
}

}  // namespace fumon
