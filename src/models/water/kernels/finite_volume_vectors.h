#pragma once

namespace fumon::finite_volume {

/// Thinner water rests, but is kept, m.
inline constexpr double dry_depth = 1e-9;

/// A row of cells as the kernels see it: what lies outside the domain holds no water.
struct CellRow {
    const double* depth;       ///< h, m
    const double* surface;     ///< h + z, m
    const double* normal;      ///< velocity across the faces in question, m/s
    const double* transverse;  ///< velocity along them, m/s
    const double* inside;      ///< 1, or 0 outside the domain
};

/// Half the limited slope over a cell, so that a face's value is the cell's plus or minus it.
struct HalfSlopes {
    double* depth;
    double* surface;
    double* normal;
    double* transverse;
    double* bed;  ///< or null: then every step of the reconstruction stops water
};

/// What passes the faces of a row, per metre of face.
struct Fluxes {
    double* mass;        ///< m²/s, from left to right
    double* left;        ///< momentum that the cell on the left loses, its own pressure taken off
    double* right;       ///< momentum that the cell on the right gains, likewise
    double* transverse;  ///< momentum along the face
};

/// A row of the fields as they are kept.
struct SourceRow {
    const double* depth;
    const double* bed;
    const double* velocity_x;
    const double* velocity_y;
};

struct LoadedRow {
    double* depth;
    double* surface;
    double* velocity_x;
    double* velocity_y;
    double* inside;
};

/// Cells inside the domain, their velocity along y times a sign.
void load_cells(const SourceRow& from, double sign_y, const LoadedRow& to, int count);

/// Fluxes through the faces between the cells `left` and `right`: values at the face from the half
/// slopes, hydrostatic reconstruction of the bed's step (Audusse et al. 2004, by the intermediate
/// height of Chen & Noelle 2017, which lets thin water fall down a step at its full weight), then
/// HLLC with the two-rarefaction wave speeds and exact fronts next to dry ground (Toro 2001).
/// Water that runs against a step of more than half its depth loses there the momentum of what does
/// not pass: a step of the bed's own slopes, for the limited ones of depth and surface leave steps
/// on a resolved slope too, which a shore climbs. (Without slopes of the bed: against any step.)
/// Beyond a face to the outside is a dry step of equal height, over which water leaves.
/// With cells that are `partly_wet` (shore_vectors.h) water climbs from a face into a dry cell as
/// far as its velocity head reaches; otherwise to where its level stands over the cell's middle.
/// Of the water that falls over a step no more weighs on a cell than its own at its deepest, 2 h:
/// such a cell may be much deeper at its face.
void face_fluxes(const CellRow& left, const HalfSlopes& left_slopes, const CellRow& right,
                 const HalfSlopes& right_slopes, double gravity, bool partly_wet, const Fluxes& out,
                 int count);

/// The share of its outward fluxes that each cell can pay for in one sub-step; 1 nearly everywhere.
/// Returns whether any cell cannot pay in full; the shares are then written.
bool payable_shares(const double* depth, const double* mass_west, const double* mass_east,
                    const double* mass_south, const double* mass_north, double dt_dx, double dt_dy,
                    double* shares, int count);

/// Cuts the fluxes to what the cell they come from can pay.
void cut_to_shares(const Fluxes& fluxes, const double* left_shares, const double* right_shares,
                   int count);

/// The largest (|u| + √(g h))/dx + (|v| + √(g h))/dy of a row, 1/s.
double fastest(const double* depth, const double* velocity_x, const double* velocity_y,
               double gravity, double dx, double dy, int count);

}  // namespace fumon::finite_volume
