#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/compensated_sum.h"
#include "base/grid.h"
#include "base/snapshot.h"
#include "base/state_archive.h"
#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"
#include "models/water/watched_faces.h"

namespace fumon {

/// Gauges in the water, each some numbers of a snapshot, whose names end in their unit:
///
///   a point   NAME_depth_m, NAME_level_m (of the surface over the bed's zero; the bed where dry),
///             NAME_unit_discharge_m2s = h |u|, of the cell in which it lies
///   a line    NAME_volume_m3: what has passed the cells' faces along it since the start, from its
///             right to its left seen from its first end, so that it is positive downstream;
///             NAME_discharge_m3s: what passed in the last step of the model, over its seconds
///   a side    the same of the faces on it, positive outward; likewise all sides together with the
///             borders of cells without data
///
/// The volumes are those by which the scheme changes the depths. A line follows the corners of
/// cells next to it, from that next to its first end to that next to its last one.
class Gauges {
  public:
    /// Throws KeyError, of the gauge's key, where a name is none or there twice, a place lies
    /// outside the grid or its data, both or neither of point and side are said, or no face of a
    /// cell with data lies there.
    Gauges(const GullyParameters& parameters, const WaterDomain& domain, const WorldScale& scale,
           int nx, int ny);

    /// The faces that a scheme has to watch; null where there are none.
    [[nodiscard]] WatchedFaces* faces() { return faces_.rows.empty() ? nullptr : &faces_; }
    /// A step of the model begins.
    void begin_step();
    /// Takes what passed the faces in a sub-step.
    void end_sub_step();

    /// What the gauges read, in their order; `bed` in metres.
    [[nodiscard]] std::vector<SnapshotNumber> read(const Water& water, const Grid& bed) const;

    /// Saves or restores what has passed.
    void serialise(StateArchive& archive);

  private:
    struct Gauge {
        std::string name;
        bool is_point = false;
        int x = 0;  ///< of a point
        int y = 0;
        CompensatedSum volume{};   ///< m³
        double step_volume = 0.0;  ///< m³, of the last step
    };

    [[nodiscard]] bool has_data(int x, int y) const;
    bool watch(int x, int y, GridSide side, double sign);
    bool watch_line(std::array<double, 2> from, std::array<double, 2> to);
    bool watch_side(GridSide side);
    bool watch_all();

    const WaterDomain& domain_;
    int nx_;
    int ny_;
    double time_step_;  ///< s
    std::vector<Gauge> gauges_;
    WatchedFaces faces_;
};

}  // namespace fumon
