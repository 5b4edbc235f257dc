#pragma once

#include <cstdint>
#include <optional>

#include "base/grid.h"
#include "base/snapshot.h"

namespace fumon {

/// What grows or lies on a cell, each 0 … 255: how green its grass is, how much grass, bare rock
/// and snow there is.
struct CellCover {
    std::uint8_t green = 0;
    std::uint8_t grass = 0;
    std::uint8_t rock = 0;
    std::uint8_t snow = 0;
};

/// A cover of land by rule, for its looks alone: nobody surveyed it.
///
/// Rock lies bare where the ground is steeper than 0.35 to 0.62, within these where the steepest
/// twelfth of the land begins. Grass grows where it is less steep, more of it and greener where the
/// topographic wetness index ln(a / tan β) is high (Beven & Kirkby 1979) and where slopes face
/// north, and dries up on those that face south. Snow lies above `snow_line`, in the heights of the
/// bed, metres, lower on slopes that face north, and slides off steep ground. Nothing outside the
/// bed, and under water of decimetres.
Field<CellCover> land_cover(const Snapshot& snapshot, std::optional<double> snow_line);

}  // namespace fumon
