#pragma once

#include "base/grid.h"

namespace fumon::plain {

/// The finite-volume shallow water of fumon's FiniteVolumeScheme as plain loops on one thread, as
/// one writes them first: what fumon's rates are measured against. Periodic, cells of 1 m, without
/// cells outside the domain; the same bytes as fumon's.
class FiniteVolume {
  public:
    /// A film of `depth` m that flows at `speed` m/s down a plane of this slope.
    FiniteVolume(Grid bed, double slope, double depth, double speed);

    /// A sub-step of that Courant number under `rain` m/s.
    void step(double courant_number, double rain);
    [[nodiscard]] const Grid& depth() const { return now_.h; }
    [[nodiscard]] const Grid& velocity_y() const { return now_.v; }

  private:
    struct Flow {
        Grid h, u, v;
    };
    struct Slopes {
        Grid h, surface, u, v, bed;
    };
    struct Fluxes {
        Grid mass, left, right, transverse;
    };

    [[nodiscard]] double longest_step() const;
    void compute_slopes(const Flow& flow);
    void compute_fluxes(const Flow& flow);
    void cut_fluxes(const Flow& flow, double dt);
    void update(const Flow& from, const Flow* start, double dt, double rain, Flow& to);
    [[nodiscard]] int before(int i) const { return i == 0 ? n_ - 1 : i - 1; }
    [[nodiscard]] int after(int i) const { return i == n_ - 1 ? 0 : i + 1; }

    int n_;
    double slope_;
    Grid z_;
    Flow now_, between_;
    Slopes along_x_, along_y_;
    Fluxes east_, north_;
    Grid share_;
};

}  // namespace fumon::plain
