#pragma once

#include "base/grid.h"
#include "models/dunes/setup/dunes_parameters.h"
#include "models/dunes/wind/wind_schedule.h"
#include "models/dunes/wind/wind_shadow.h"

namespace fumon {

class Plants;
class WorkerPool;
struct RowTraversal;

/// How plants slow the wind at the ground, among and behind them: the friction velocity u*s there
/// in parts of that without plants.
///
/// Under a cover ρ of plants, after Raupach, Gillette & Leys (1993) with the constants of Durán &
/// Moore (2013), Γ = mβ/σ = 16, and bare ground between the plants:
///
///     (u*s / u*)² = 1 / (1 + Γ ρ)
///
/// Behind a plant of the height h, at a distance x downwind of it, after Okin (2008), with c = 4.8:
///
///     u*s / u* = r0 + (1 − r0) (1 − exp(−x / (c h)))
///
/// where r0 is u*s / u* under the plant (Okin's own is .32, that of a cover of .55). Plants of a
/// cover ρ are h = √ρ of their full height high (Durán & Moore 2013); of two species the higher
/// one counts. Where several plants shelter a cell, the lowest u*s holds; of the wakes that a line
/// along the wind carries on, that of the lower u*s.
///
/// A wind moves sand as its stress less that of the threshold, so that under (u*s / u*)² it lifts
///
///     max(f (u*s/u*)² − (1 − (u*s/u*)²) t / (1 − t), 0),   t = (u*t / u*)²,
///
/// where it would lift f: none where u*s is below the threshold on level ground.
///
/// Lines follow the wind as those of WindShadow do. In a periodic bed they begin 7 c h upwind, at
/// most one time round. They are independent of one another, so threads share them.
class PlantShelter {
  public:
    PlantShelter(const DunesParameters& parameters, const DuneGround& ground, WorkerPool& pool);

    /// Takes the plants as they are now.
    void set_plants(const Plants& plants);

    void find(const BlowingWind& wind);

    /// (u*s / u*)² in each cell, as last found.
    [[nodiscard]] const Grid& stress() const { return stress_; }

    /// What a wind lifts of `lifted` under a share `stress` of its stress.
    static double lifted_under(double lifted, double stress, const BlowingWind& wind) {
        if (stress >= 1.0) return lifted;
        const double below = (1.0 - stress) * (wind.threshold / (1.0 - wind.threshold));
        const double left = stress * lifted - below;
        return left > 0.0 ? left : 0.0;
    }

  private:
    void follow_lines(const RowTraversal& traversal, int rows_before, int first, int last);

    DuneGround ground_;
    WorkerPool& pool_;
    bool has_wakes_;
    double drag_;          ///< Γ
    double grass_length_;  ///< c h of a whole cover, m
    double shrub_length_;
    Grid deficit_;  ///< 1 − r0 under the plants of each cell
    Grid reach_;    ///< that times c h, m
    Grid stress_;
};

/// Throws KeyError where there are no plants, or no continuous transport, whose wind they slow.
void check_plant_shelter(const DunesParameters& parameters);

}  // namespace fumon
