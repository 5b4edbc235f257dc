#pragma once

#include "models/water/gully_parameters.h"
#include "models/water/shallow_water.h"
#include "models/water/water_edges.h"

namespace fumon::examination {

/// Shallow water of first order, as one writes it first, to compare with: constant states, the
/// hydrostatic reconstruction of Audusse et al. (2004), fluxes of Harten, Lax and van Leer (1983),
/// one explicit step, friction implicit. Cells without data there are none; walls and periodic
/// edges, and those of WaterEdges.
class FirstOrder {
  public:
    FirstOrder(const GullyParameters& parameters, const WaterDomain& domain, Grid bed, Water water);

    [[nodiscard]] double step_at_courant_one() const;
    /// `time` is that at which edges are taken.
    void advance(double time, double dt);
    [[nodiscard]] const Water& water() const { return water_; }

  private:
    struct Cell {
        double h, u, v, z;  ///< u across the face
    };
    struct Flux {
        double mass, left, right, along;
    };

    [[nodiscard]] Flux face(const Cell& left, const Cell& right) const;
    [[nodiscard]] Flux at_edge(const Cell& inside, GridSide side, int cell) const;
    [[nodiscard]] Cell cell(int x, int y, bool across_x) const;
    [[nodiscard]] Flux face_west_of(int x, int y) const;
    [[nodiscard]] Flux face_south_of(int x, int y) const;

    GullyParameters parameters_;
    WaterDomain domain_;
    Grid bed_;
    Water water_;
    Water next_;
    WaterEdges edges_;
};

}  // namespace fumon::examination
