#include "foreign/foreign_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/find_named.h"
#include "base/limits.h"
#include "base/snapshots/ground_range.h"

namespace fumon {

namespace {

/// NaN, where a file has no value, as 0.
void clear_missing(Grid& values) {
    for (double& value : values.values())
        if (!std::isfinite(value)) value = 0.0;
}

void check_size(const ForeignRun& run, const std::string& name, const Grid& values) {
    if (values.nx() == run.nx && values.ny() == run.ny) return;
    throw InputError(
        fmt::format("{}: {} has {} x {} cells, the bed {} x {}; all fields of a run "
                    "need the same grid",
                    run.name, name, values.nx(), values.ny(), run.nx, run.ny));
}

Grid read_of(const ForeignRun& run, Quantity quantity, std::size_t record) {
    const ForeignField& field = *run.find(quantity);
    Grid values = field.read(record);
    check_size(run, field.name, values);
    return values;
}

/// The depth of a record; NaN where the file has none.
Grid depth_of(const ForeignRun& run, const Grid& bed, std::size_t record) {
    if (run.find(Quantity::depth) != nullptr) return read_of(run, Quantity::depth, record);
    Grid depth = read_of(run, Quantity::level, record);
    for (std::size_t i = 0; i < depth.size(); ++i) depth.values()[i] -= bed.values()[i];
    return depth;
}

/// A velocity, or the discharge per width over the depth.
Grid velocity_of(const ForeignRun& run, Quantity velocity, Quantity flux, const Grid& depth,
                 std::size_t record) {
    const bool known = run.find(velocity) != nullptr;
    if (!known && run.find(flux) == nullptr) return {depth.nx(), depth.ny()};
    Grid values = read_of(run, known ? velocity : flux, record);
    for (std::size_t i = 0; i < values.size(); ++i) {
        double& value = values.values()[i];
        const double water = depth.values()[i];
        if (!(water > 0.0)) {
            value = 0.0;
        } else if (!known) {
            value /= water;
        }
    }
    clear_missing(values);
    return values;
}

void negate(Grid& values) {
    for (double& value : values.values()) value = -value;
}

/// Turns velocities toward the east and north, or along the file's own columns and rows, to those
/// along the columns and rows of a turned grid.
void turn_to_sides(const ForeignRun& run, Grid& u, Grid& v) {
    const auto by_compass = [&](Quantity quantity) {
        const ForeignField* field = run.find(quantity);
        return field != nullptr && field->by_compass;
    };
    if (run.turn == 0.0) return;
    if (!by_compass(Quantity::velocity_x) && !by_compass(Quantity::velocity_y)) {
        if (run.swapped) std::swap(u, v);
        if (run.columns_fall) negate(u);
        if (run.rows_fall) negate(v);
        return;
    }
    if (!by_compass(Quantity::velocity_x) || !by_compass(Quantity::velocity_y)) return;
    const double cosine = elementary::cos(run.turn);
    const double sine = elementary::sin(run.turn);
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double east = u.values()[i];
        const double north = v.values()[i];
        u.values()[i] = cosine * east + sine * north;
        v.values()[i] = cosine * north - sine * east;
    }
}

Grid bed_values(const ForeignRun& run, std::size_t record) {
    if (run.find(Quantity::bed) != nullptr) return read_of(run, Quantity::bed, record);
    Grid bed = read_of(run, Quantity::level, record);
    const Grid depth = read_of(run, Quantity::depth, record);
    for (std::size_t i = 0; i < bed.size(); ++i) bed.values()[i] -= depth.values()[i];
    return bed;
}

void add_water(const ForeignRun& run, std::size_t record, Snapshot& snapshot) {
    Grid depth = depth_of(run, snapshot.bed, record);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const bool outside = !snapshot.nodata.empty() && snapshot.nodata.values()[i] != 0;
        if (outside || !(depth.values()[i] > run.dry)) depth.values()[i] = 0.0;
    }
    Grid u = velocity_of(run, Quantity::velocity_x, Quantity::flux_x, depth, record);
    Grid v = velocity_of(run, Quantity::velocity_y, Quantity::flux_y, depth, record);
    turn_to_sides(run, u, v);
    snapshot.fields.push_back({"water_depth", "depth of the water", "m", std::move(depth)});
    snapshot.fields.push_back({"velocity_x", "velocity along x", "m/s", std::move(u)});
    snapshot.fields.push_back({"velocity_y", "velocity along y", "m/s", std::move(v)});
}

/// Refuses fill values that the file does not name as such.
void check_range(const ForeignRun& run, const Snapshot& snapshot, std::size_t record) {
    if (const std::string fault = beyond_ground(snapshot); !fault.empty())
        throw InputError(fmt::format("{}: record {}: {}", run.name, record + 1, fault));
}

}  // namespace

const ForeignField* ForeignRun::find(Quantity quantity) const {
    const auto found = std::ranges::find(fields, quantity, &ForeignField::quantity);
    return found == fields.end() ? nullptr : &*found;
}

bool ForeignRun::has_water() const {
    return find(Quantity::depth) != nullptr || find(Quantity::level) != nullptr;
}

Snapshot foreign_bed(const ForeignRun& run, std::size_t record) {
    Snapshot snapshot;
    snapshot.step = run.times.steps.at(record);
    snapshot.time = run.times.times.at(record);
    snapshot.time_unit = run.times.unit;
    snapshot.date = run.times.date;
    snapshot.scale = run.scale;
    snapshot.landform = run.has_water() ? Landform::water : Landform::terrain;
    snapshot.bed = bed_values(run, record);
    std::size_t missing = 0;
    for (double& height : snapshot.bed.values()) {
        if (std::isfinite(height)) continue;
        if (snapshot.nodata.empty()) snapshot.nodata = Mask(run.nx, run.ny);
        const auto cell = static_cast<std::size_t>(&height - snapshot.bed.data());
        snapshot.nodata.values()[cell] = 1;
        height = 0.0;
        ++missing;
    }
    if (missing == snapshot.bed.size())
        throw InputError(fmt::format("{}: record {} has no bed in any cell; is it cut short?",
                                     run.name, record + 1));
    check_range(run, snapshot, record);
    return snapshot;
}

Snapshot foreign_snapshot(const ForeignRun& run, std::size_t record) {
    Snapshot snapshot = foreign_bed(run, record);
    if (run.has_water()) add_water(run, record, snapshot);
    if (run.find(Quantity::concentration) != nullptr) {
        // It may colour the ground alone: no file is refused for what it holds in dry cells.
        Grid concentration = read_of(run, Quantity::concentration, record);
        for (double& value : concentration.values())
            if (!(std::abs(value) <= largest_field_value))
                value = std::numeric_limits<double>::quiet_NaN();
        snapshot.fields.push_back(
            {"concentration", "sediment in the water", "kg/m3", std::move(concentration)});
    }
    for (const ForeignScalar& scalar : run.scalars) {
        if (find_named(snapshot.fields, scalar.name) != nullptr) continue;
        Grid values = scalar.read(record);
        check_size(run, scalar.name, values);
        snapshot.fields.push_back({scalar.name, scalar.long_name,
                                   scalar.unit.empty() ? "1" : scalar.unit, std::move(values)});
    }
    check_range(run, snapshot, record);
    return snapshot;
}

}  // namespace fumon
