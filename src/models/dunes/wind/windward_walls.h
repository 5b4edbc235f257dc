#pragma once

#include <vector>

#include "base/grid.h"
#include "models/dunes/setup/dune_bed.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class WorkerPool;

/// The wind before steep walls, which turns back at their foot and lets sand fall before it: echo
/// dunes. After Tsoar (1983), who saw them before walls of 55 degrees and more, and the regions of
/// Nilles, Günther & Müller (2024).
///
/// Where the ground rises along the wind by more than the tangent of an angle from one cell to the
/// next, it is a wall, up to where it rises by less than 30 degrees. In a cell at a distance d
/// upwind of its foot, over which it stands H high, the wind is
///
///     u = (s − 0.4) / 1.6 for 0.4 ≤ s < 2,   u = (s / 0.4 − 1) / 2 for s < 0.4,   s = d / H,
///
/// in parts of what it would be: hops reach u times as far, back where u < 0. The least u of all
/// walls holds.
///
/// The eddy at the foot leaves a wall round its ends, as a horseshoe vortex, and takes sand along:
/// with y the place along the feet that touch one another, −1 and 1 at their ends, the wind also
/// blows outward along the wall with
///
///     v = a min(|4 y|, 1) min((1 − s) / 0.6, 1),   s < 1,
///
/// in parts of the wind. Feet that close round a periodic bed have no ends, and v is 0.
class WindwardWalls {
  public:
    /// `drift`: a.
    WindwardWalls(const DuneGround& ground, double tangent, double drift, WorkerPool& pool);

    void find(const FixedPointGrid& surface, const BlowingWind& wind);

    /// u, −0.5 … 1.
    [[nodiscard]] const Grid& wind() const { return wind_; }
    /// v, to the left of the wind, −a … a; empty where a is 0.
    [[nodiscard]] const Grid& aside() const { return aside_; }

  private:
    struct Line {
        double x;         ///< cells for each cell along
        double y;         ///< likewise
        double distance;  ///< m for each cell along
    };

    void find_feet(const FixedPointGrid& surface, const Line& line, int y);
    void slacken_before(const FixedPointGrid& surface, const Line& line, int x, int y);
    /// v / a at the foot of each wall, by cell.
    void find_outflow_directions(const BlowingWind& wind);
    void follow_wall(int x, int y, const BlowingWind& wind);
    /// The height n cells along from (x, y), 2⁻³² m; false beyond an open edge.
    bool height_at(const FixedPointGrid& surface, const Line& line, int x, int y, int n,
                   std::int64_t& height) const;
    bool place(const Line& line, int x, int y, int n, int& to_x, int& to_y) const;

    DuneGround ground_;
    double tangent_;
    double drift_;
    WorkerPool& pool_;
    std::vector<std::vector<int>> feet_;  ///< of each row, where walls begin
    Grid wind_;
    Grid aside_;
    Grid outward_;         ///< of feet
    Field<char> waiting_;  ///< feet whose wall was not followed yet
};

}  // namespace fumon
