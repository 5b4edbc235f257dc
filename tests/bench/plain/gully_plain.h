#pragma once

#include <vector>

#include "base/grid.h"
#include "models/water/gully_parameters.h"

namespace fumon::plain {

/// The gully model by CIP with incision on gentle relief (fumon's CipScheme, Sediment and
/// BedDiffusion) as plain loops on one thread, as one writes them first: what fumon's rates are
/// measured against. Periodic, cells of 1 m; the same bytes as fumon's.
class Gully {
  public:
    Gully(const GullyParameters& parameters, Grid bed);

    void step();
    [[nodiscard]] const Grid& bed() const { return z_; }
    [[nodiscard]] const Grid& depth() const { return h_; }

  private:
    struct Carried {
        double value, gradient_x, gradient_y;
    };

    [[nodiscard]] double courant_rate() const;
    void advect_and_accelerate(double dt);
    void turn(double dt, const Grid& gained, Grid& gradient_x, Grid& gradient_y) const;
    void transport_depth(double dt);
    void incise(double dt);
    void diffuse(double dt);
    [[nodiscard]] int before(int i) const { return i == 0 ? n_ - 1 : i - 1; }
    [[nodiscard]] int after(int i) const { return i == n_ - 1 ? 0 : i + 1; }

    GullyParameters parameters_;
    int n_;
    double slope_;
    Grid z_, h_, u_, v_, ux_, uy_, vx_, vy_;
    Grid next_h_, next_u_, next_v_, next_ux_, next_uy_, next_vx_, next_vy_;
    Grid gained_u_, gained_v_, east_, north_, half_way_;
};

}  // namespace fumon::plain
