#pragma once

#include <string>
#include <vector>

#include "keys/keys.h"

namespace fumon {

enum class GridSide { west, east, south, north };
enum class EdgeFlow { wall, open, discharge, level };

/// A stretch of an edge of the grid that has a kind of its own: [[edge]].
struct EdgeSettings {
    GridSide side = GridSide::west;
    double from = 0.0;  ///< m along the side, from its south or west end
    double to = 0.0;    ///< m; 0: to the other end
    EdgeFlow kind = EdgeFlow::open;
    double value = 0.0;          ///< m³/s or m
    std::vector<double> times;   ///< s, rising; empty: `value` at all times
    std::vector<double> values;  ///< at these times
    std::string table;           ///< a file that has them
    double depth = 0.0;          ///< m, of supercritical inflow; 0: critical
};

/// Water at the start where it is otherwise than elsewhere: [[water]].
struct RegionSettings {
    std::vector<double> window;  ///< m: west, south, east, north; empty: all
    WordOrReal depth{"none", 0.0};
    WordOrReal level{"none", 0.0};
    double velocity_x = 0.0;  ///< m/s
    double velocity_y = 0.0;
};

enum class GaugeSide { none, west, east, south, north, all };
enum class GaugeCoordinates { grid, map };

/// Where a run notes the water: at a point, through a line across a stream, over a side of the
/// grid, or all that leaves: [[gauge]].
struct GaugeSettings {
    std::string name;        ///< begins its columns; empty: "gauge_1" by its place in the list
    std::vector<double> at;  ///< x, y of the point, or of the line's left end; empty: a side's
    std::vector<double> to;  ///< x, y of the line's right end, seen downstream; empty: a point
    GaugeCoordinates coordinates = GaugeCoordinates::grid;
    GaugeSide side = GaugeSide::none;
};

enum class MapQuantity {
    rain,
    roughness,
    infiltration_rate,
    infiltration_start,
    suction_head,
    moisture_deficit,
    depth,
    level,
    velocity_x,
    velocity_y
};

/// A quantity that a file gives cell by cell: [[map]]. The setup brings it to the grid's cells.
struct MapSettings {
    MapQuantity quantity = MapQuantity::rain;
    std::string file;
    std::string variable;     ///< of a NetCDF file; empty: its only one
    std::int64_t band = 0;    ///< of a GeoTIFF, from 1; 0: its only or first one
    std::int64_t record = 0;  ///< of a NetCDF variable over time, from 1; 0: its only or last one
    double from = 0.0;        ///< s, when this rain begins
};

void list_map(MapSettings& map, const std::string& path, KeyTable& table);
void list_gauge(GaugeSettings& gauge, const std::string& path, KeyTable& table);
void list_edge(EdgeSettings& edge, const std::string& path, KeyTable& table);
void list_region(RegionSettings& region, const std::string& path, KeyTable& table);

}  // namespace fumon
