#include "models/water/water_settings.h"

#include "base/limits.h"

namespace fumon {

namespace {

constexpr std::size_t longest_table = 100000;
constexpr double farthest = 1e7;  // m

}  // namespace

void list_edge(EdgeSettings& edge, const std::string& path, KeyTable& table) {
    table.choice(path + ".side", edge.side,
                 {{GridSide::west, "west", "x = 0"},
                  {GridSide::east, "east", "the largest x"},
                  {GridSide::south, "south", "y = 0"},
                  {GridSide::north, "north", "the largest y"}},
                 {.help = "the side of the grid on which the stretch lies"});
    table.real(path + ".from", edge.from,
               {.unit = "m",
                .range = {0, farthest},
                .help = "where the stretch begins, from the side's south or west end"});
    table.real(
        path + ".to", edge.to,
        {.unit = "m", .range = {0, farthest}, .help = "where it ends; 0: at the side's end"});
    table.choice(
        path + ".kind", edge.kind,
        {{EdgeFlow::open, "open", "a fall: water leaves freely, none comes in"},
         {EdgeFlow::wall, "wall", "nothing passes"},
         {EdgeFlow::discharge, "discharge",
          "this discharge comes in, spread evenly along the stretch"},
         {EdgeFlow::level, "level", "the water stands at this level: it comes in or leaves"}},
        {.help = "what passes the stretch; elsewhere model.edges_x, model.edges_y hold"});
    table.real(path + ".value", edge.value,
               {.unit = "m^3/s, or m",
                .range = {-1e5, 1e9},
                .help = "the discharge of the whole stretch, or the level, as heights of the bed"});
    table.real_list(path + ".times", edge.times, 0, longest_table,
                    {.unit = "s",
                     .range = {-largest_time, largest_time},
                     .help = "of edge.values, rising; in between the value changes evenly, before "
                             "and after it stays; empty: edge.value at all times"});
    table.real_list(path + ".values", edge.values, 0, longest_table,
                    {.unit = "m^3/s, or m",
                     .range = {-1e5, 1e9},
                     .help = "discharges or levels at edge.times: a hydrograph"});
    table.text(path + ".table", edge.table,
               {.help = "a CSV file of two columns, seconds and discharge or level, for edge.times "
                        "and edge.values"});
    table.real(path + ".depth", edge.depth,
               {.unit = "m",
                .range = {0, 1e4},
                .help = "of a discharge that comes in faster than its waves; 0: critical depth "
                        "where the water inside leaves it free"});
}

void list_gauge(GaugeSettings& gauge, const std::string& path, KeyTable& table) {
    table.text(path + ".name", gauge.name,
               {.help = "begins the gauge's columns: a letter, then letters, digits and "
                        "underscores; empty: gauge_1, gauge_2 …"});
    table.real_list(path + ".at", gauge.at, 0, 2,
                    {.unit = "m, or degrees",
                     .range = {-largest_coordinate, largest_coordinate},
                     .help = "[x, y] of the point, or of the left end of a line across the "
                             "stream, seen downstream"});
    table.real_list(path + ".to", gauge.to, 0, 2,
                    {.unit = "m, or degrees",
                     .range = {-largest_coordinate, largest_coordinate},
                     .help = "[x, y] of the line's right end: what passes the cells' faces along "
                             "the line is noted then; empty: a point"});
    table.choice(path + ".coordinates", gauge.coordinates,
                 {{GaugeCoordinates::grid, "grid", "m from the grid's south-west corner"},
                  {GaugeCoordinates::map, "map",
                   "those of the terrain file: metres of its reference system, or longitude and "
                   "latitude where it has degrees"}},
                 {.help = "of gauge.at and gauge.to"});
    table.choice(path + ".side", gauge.side,
                 {{GaugeSide::none, "none", "gauge.at says where"},
                  {GaugeSide::west, "west", "x = 0"},
                  {GaugeSide::east, "east", "the largest x"},
                  {GaugeSide::south, "south", "y = 0"},
                  {GaugeSide::north, "north", "the largest y"},
                  {GaugeSide::all, "all",
                   "every side that is not periodic, and the borders of cells without data: all "
                   "that leaves, less what comes in"}},
                 {.help = "the side of the grid over which the discharge outward is noted: the "
                          "mean over the last step, and the volume since the start"});
}

void list_map(MapSettings& map, const std::string& path, KeyTable& table) {
    table.choice(
        path + ".quantity", map.quantity,
        {{MapQuantity::rain, "rain", "mm/h, from map.from on until the next map of rain begins",
          "mm/h"},
         {MapQuantity::roughness, "roughness",
          "the coefficient of model.friction: n (s/m^(1/3)), C (m^(1/2)/s) or C_f"},
         {MapQuantity::infiltration_rate, "infiltration_rate",
          "mm/h, instead of model.infiltration_rate", "mm/h"},
         {MapQuantity::infiltration_start, "infiltration_start",
          "mm/h, instead of model.infiltration_start", "mm/h"},
         {MapQuantity::suction_head, "suction_head", "m, instead of model.suction_head", "m"},
         {MapQuantity::moisture_deficit, "moisture_deficit",
          "0 to 1, instead of model.moisture_deficit", "1"},
         {MapQuantity::depth, "depth", "h at the start, m", "m"},
         {MapQuantity::level, "level",
          "height of the water's surface at the start, m; higher ground is dry", "m"},
         {MapQuantity::velocity_x, "velocity_x", "eastward at the start, m/s", "m/s"},
         {MapQuantity::velocity_y, "velocity_y", "northward at the start, m/s", "m/s"}},
        {.help = "what the file gives for each cell"});
    table.text(
        path + ".file", map.file,
        {.help =
             "a grid as bed.file reads it (no PNG), in the quantity's unit or, where it names its "
             "own, in one that converts to that: brought to the bed's cells, linear "
             "in between, where both say where they lie, else with as many cells as "
             "the bed"});
    table.text(path + ".variable", map.variable,
               {.help = "the variable of a NetCDF file; empty: its only one"});
    table.integer(path + ".band", map.band,
                  {.range = {0, 100000}, .help = "the band of a GeoTIFF; 0: its only or first"});
    table.integer(path + ".record", map.record,
                  {.range = {0, 1000000000},
                   .help = "of a NetCDF variable over (time, y, x), from 1; 0: its last one, of "
                           "rain its only one"});
    table.real(path + ".from", map.from,
               {.unit = "s", .range = {0, 1e12}, .help = "when this rain begins"});
}

void list_region(RegionSettings& region, const std::string& path, KeyTable& table) {
    table.real_list(path + ".window", region.window, 0, 4,
                    {.unit = "m",
                     .range = {-largest_coordinate, largest_coordinate},
                     .help = "[west, south, east, north], from the grid's south-west corner: the "
                             "cells whose middles lie in it; empty: all"});
    table.word_or_real(path + ".depth", region.depth, {{"none", "water.level says it"}},
                       {.unit = "m", .range = {0, 1e4}, .help = "h at the start"});
    table.word_or_real(
        path + ".level", region.level, {{"none", "water.depth says it"}},
        {.unit = "m",
         .range = {-1e5, 1e5},
         .help = "height of the water's surface at the start; higher ground is dry"});
    table.real(path + ".velocity_x", region.velocity_x,
               {.unit = "m/s", .range = {-1e3, 1e3}, .help = "eastward, at the start"});
    table.real(path + ".velocity_y", region.velocity_y,
               {.unit = "m/s", .range = {-1e3, 1e3}, .help = "northward, at the start"});
}

}  // namespace fumon
