#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/grid.h"
#include "base/snapshot.h"
#include "base/worker_pool.h"
#include "scene/scene.h"

namespace fumon {

/// Depth from which a cell is wet, metres.
inline constexpr double least_wet_depth = 1e-5;

/// A field of water by its name. Throws InputError where the snapshot has none of it.
const Grid& water_field(const Snapshot& snapshot, std::string_view name);

/// Whether a snapshot has water: the fields "water_depth" (m), "velocity_x" and "velocity_y" (m/s).
bool has_water(const Snapshot& snapshot);

/// Whether a picture shows water as water: over the bed, by its own looks. A figure does not.
bool draws_water(const LookSettings& look, const Snapshot& snapshot);

/// 1 where a cell is dry or lies outside the domain. Empty without water.
Mask dry_cells(const Snapshot& snapshot);

/// The depth in metres of every cell, 0 where it is dry. Throws InputError without water, as do the
/// two below.
Field<float> water_depths(const Snapshot& snapshot);

/// The magnitude of the velocity, m/s; 0 where it is dry.
Field<float> water_speed(const Snapshot& snapshot);

/// The Froude number |u|/√(g h) with g = 9.8 m/s²; 0 where it is dry.
Field<float> froude_numbers(const Snapshot& snapshot);

/// The depth from which water lies over the ground as a closed sheet, metres; what is thinner runs
/// between the stones and tufts that a cell does not show, and only darkens the ground. Natural
/// ground is rough at all lengths, its heights growing with the root of the length (Sayles & Thomas
/// 1978): 4 mm for cells of 1 m, 34 mm for cells of 70 m. Next to nothing where lengths are in
/// sites.
double closed_depth(const WorldScale& scale);

/// What is usual in a snapshot's wet cells; all 0 where none is wet.
struct WaterStatistics {
    double high_depth = 0.0;    ///< 99th percentile, metres
    double median_depth = 0.0;  ///< metres
    double median_froude = 0.0;
};

WaterStatistics water_statistics(const Snapshot& snapshot);

/// The depth at which the bed is half hidden, metres: look.water_clarity or, if that is "auto",
/// high_depth · (0.6 + 3.4 (median_depth/high_depth)⁴), so that ponds hide their deepest ground and
/// a film that is as deep everywhere stays transparent.
double water_clarity(const LookSettings& look, const WaterStatistics& water);

/// Water on the cells of a display bed. Cells without data are dry.
struct DisplayWater {
    /// Metres; below 0 on a bank, as far as the level beside it lies below it.
    Field<float> depth;
    Field<float> velocity_x;  ///< m/s
    Field<float> velocity_y;
    /// Of the ground: the root of depth over closed_depth, at most 1, in wet cells, falling to 0
    /// within two cells around them; in rain all ground is damp.
    Field<float> damp;
    /// The slopes of its surface eastward and northward, from neighbours that are under a closed
    /// sheet too: across a channel of one cell, whose banks have a film of rain, it lies level.
    Field<float> slope_x;
    Field<float> slope_y;
    /// The rings that the drops of the last second have left, as ring_tile_levels() has them for
    /// the heaviest rain on any cell; empty where none fell, or lengths are in sites.
    std::vector<std::vector<std::uint8_t>> rings;
    /// How steep they are on each cell, of the tile's: the root of its share of that rain. Empty
    /// where it is even.
    Field<float> ringed;
    /// What suspended sediment adds to the water's turbidity, as suspended_turbidities() has it.
    /// Empty where nothing is known of sediment.
    Field<float> silt;
};

/// How far suspended sediment takes each cell's water from look.turbidity (0) to muddy (1), by the
/// field "concentration" in kg/m³: S/(S + 0.0615 kg/m³), the brightness that water with so much
/// sediment S has in red light over the most that it can have (Nechad, Ruddick & Park 2010,
/// equation 12 without offset, A = 355.85 g/m³ and C = 0.1728 at 665 nm). 0 where a cell is dry or
/// has no value; empty without such a field in kg/m³.
Field<float> suspended_turbidities(const Snapshot& snapshot);

/// The turbidity of all the water of a snapshot, 0 clear … 1 muddy: look.turbidity, and with
/// suspended sediment the mean by volume.
double mean_turbidity(const LookSettings& look, const Snapshot& snapshot);

DisplayWater display_water(const Snapshot& snapshot, int refinement, WorkerPool& pool);

/// What the water has done to a bed since `first`, −1 worn … 1 laid down, whole from `whole` metres
/// on; less what the bed has sunk or risen in the mean. All 0 where the grids differ.
Field<float> worked_bed(const Snapshot& snapshot, const Snapshot& first, double whole,
                        int refinement);

}  // namespace fumon
