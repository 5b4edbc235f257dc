#pragma once

#include <cstdint>

namespace fumon {

// Sizes that fumon accepts, stated once.
inline constexpr double largest_grid_side = 4194304;           // cells; a profile may be that long
inline constexpr std::int64_t largest_grid_cells = 1LL << 27;  // 1 GiB per field: 11,585 × 11,585
inline constexpr double largest_step = 1e15;                   // whole and exact in a double
inline constexpr double smallest_picture_side = 16;            // pixels
inline constexpr double largest_picture_side = 16384;          // pixels

// Numbers for which pictures are made, stated once: keys, files, Python, couplings and checkpoints
// keep to them, and a snapshot beyond them is not drawn (base/snapshots/ground_range.h). The guide
// tells them (assets/guide/units.md). Down and up alike where one number stands for both.
inline constexpr double largest_height = 1e6;         // m; model heights where they have no metres
inline constexpr double smallest_cell_size = 1e-6;    // m
inline constexpr double largest_cell_size = 1e7;      // m
inline constexpr double smallest_height_unit = 1e-9;  // m per model height
inline constexpr double largest_height_unit = 1e7;    // m per model height
inline constexpr double largest_coordinate = 1e9;     // m or sites: of cameras, lines and windows
inline constexpr double largest_colour_value = 1e15;  // in the unit of what the colours mean
inline constexpr double largest_field_value = 1e30;   // of what a model has besides its bed
inline constexpr double largest_time = 1e15;          // in the model's unit of time

}  // namespace fumon
