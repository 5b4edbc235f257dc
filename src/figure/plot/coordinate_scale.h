#pragma once

#include <string>

#include "base/grid.h"
#include "figure/plot/ticks.h"

namespace fumon {

/// The coordinates of a bed's file along one of its sides: of a place so many metres (or sites)
/// from the south-west corner, in the unit of the file's reference system. A bed that lies nowhere
/// counts metres, or sites, from that corner.
class CoordinateScale {
  public:
    enum class Axis { east, north };

    CoordinateScale(const WorldScale& scale, Axis axis);

    /// Metres or sites from the corner of a coordinate.
    [[nodiscard]] double place_of(double coordinate) const;
    [[nodiscard]] double coordinate_at(double place) const;

    /// The coordinates as an axis beside a map says them, from the corner to `length` metres or
    /// sites from it: "easting (km)", "latitude (°)", "x (m)" of a bed that lies nowhere.
    struct Range {
        double low;
        double high;
        std::string name;
        std::string unit;
    };
    [[nodiscard]] Range range(double length) const;

    /// Marks at round coordinates between the corner and `length` metres or sites from it, at most
    /// `most` (2 or more). Each says its unit: "476.5 km E", "4431 km N", "105.4° W", "120 m".
    [[nodiscard]] Ticks ticks(double length, int most) const;

  private:
    enum class Unit { sites, metres, feet, degrees };

    [[nodiscard]] std::string label(double coordinate, const RoundStep& step,
                                    bool in_kilometres) const;

    Axis axis_;
    Unit unit_;
    bool lies_somewhere_;
    double begin_;       ///< coordinate of the corner
    double per_length_;  ///< of a metre or site
};

}  // namespace fumon
