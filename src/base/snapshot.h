#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/grid.h"
#include "base/landform.h"

namespace fumon {

/// A field that a model shows besides the bed: the cells of the last avalanche, the water depth …
struct SnapshotField {
    std::string name;       ///< as files and scenes call it: "last_avalanche"
    std::string long_name;  ///< what it is, in a few words
    std::string unit;       ///< "1" for a pure number
    Grid values;            ///< nx × ny
};

/// A line along the profile of a section, one value a column: "bed_shear_stress" …
struct SectionCurve {
    std::string name;
    std::string long_name;
    std::string unit;
    std::vector<double> values;  ///< nx
};

/// The path of a grain through the air. x goes on past the section's end where the grain does.
struct GrainPath {
    double launch_angle = 0.0;  ///< to the local bed, degrees
    std::vector<double> x;      ///< metres
    std::vector<double> z;      ///< metres, as many
};

/// The vertical plane over a bed that is a profile, in metres: column i at x = i·dx, node k at
/// z = k·dz. Periodic in x.
struct SnapshotSection {
    double dx = 0.0;
    double dz = 0.0;
    /// nx × nz each: "velocity_x", "velocity_z" (m/s), "pressure" (Pa) …; 0 at and below the bed.
    std::vector<SnapshotField> fields;
    std::vector<SectionCurve> curves;
    std::vector<GrainPath> paths;
};

/// A number that a model keeps besides its fields.
struct SnapshotNumber {
    std::string name;  ///< "lost_grains"
    std::string unit;
    double value = 0.0;
};

/// A wind of a run: where it blows to, and the sand that it moves over flat ground, m²/yr over the
/// whole time.
struct SnapshotWind {
    double x = 1.0;  ///< eastward part of a unit vector
    double y = 0.0;  ///< northward part
    double drift = 0.0;
};

/// An immutable copy of what a model shows between two steps. It is all that the renderer, the
/// measures and the writers ever see of the model. `bed` is in model heights; `scale` relates these
/// to metres.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0.0;
    std::string time_unit;  ///< "steps", "s" …
    Grid bed;
    Mask nodata;  ///< empty when no cell lies outside the domain
    WorldScale scale;
    /// Up to where the model's landforms grow, model heights; 0 where it does not know.
    double highest_expected = 0.0;
    bool periodic = false;  ///< whether the bed goes on past its edges with its other side
    std::vector<SnapshotField> fields{};
    std::vector<SnapshotNumber> numbers{};
    /// What is above a bed of a single row, where the model knows; shared, since it is large.
    std::shared_ptr<const SnapshotSection> section{};
    Landform landform = Landform::bed;  ///< of the model
    std::vector<SnapshotWind> winds{};  ///< of the whole run; empty: one toward +x
    /// What the model's wind drives over each cell of a snapshot of it, in parts of what it drives
    /// over level ground: asked for where it is shown. Empty where no wind moves sand. Throws Error
    /// where the snapshot lacks a field for it.
    std::function<Grid(const Snapshot&)> saltation_flux{};
    /// The rain between two times of the run, metres: of every cell, or one value for all of them.
    /// Asked for where it is shown. Empty where the model knows no rain.
    std::function<Grid(double from, double until)> rain{};
    /// The date of a time of the run, where its times have one: "2019-08-31 14:00 UTC".
    std::function<std::string(double time)> date{};
    /// Metres, of plants of the fields "grass" and "shrubs" where their cover is whole.
    double grass_height = 0.45;
    double shrub_height = 1.1;
};

}  // namespace fumon
