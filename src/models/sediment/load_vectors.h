#pragma once

namespace fumon::loads {

/// Grains of water thinner than this settle, and none are taken up, m.
inline constexpr double thin_water = 1e-6;
/// Less of a load settles at once, m. It is nothing next to any other, but where the water brings
/// no grains the load fades for ever, and a processor is a hundred times slower at numbers below
/// 1e-308 than at others.
inline constexpr double least_load = 1e-100;

/// C = hC / h of a row; of thin water as if it were thin_water deep.
void concentrate_row(const double* load, const double* depth, int count, double* concentration);

/// A stage of water's load in a row: concentrations of the cells and their neighbours (west and
/// east beside `here`), and the water through their faces, m²/s.
struct AdvectedRow {
    const double* here;
    const double* south;
    const double* north;
    const double* flow_west;
    const double* flow_east;
    const double* flow_south;
    const double* flow_north;
};

/// load − dt ∇·(flow · C of the cell upstream), averaged with `before` where that is not null.
void advect_load_row(const AdvectedRow& row, const double* load, const double* before, double dt_dx,
                     double dt_dy, int count, double* carried);

/// How flow over the bed moves it.
struct PickUpLaw {
    bool manning = false;     ///< τ/ρ = friction · U² / h^(1/3), not friction · U²
    double per_stress = 0.0;  ///< θ over τ/ρ
    double critical = 0.0;    ///< θ_c on a level bed
    double unit = 0.0;        ///< √((s − 1) g d³), m²/s; 0: no bed load
    double slope_x = 0.0;  ///< of the mean plane: ∂z/∂x and ∂z/∂y of what the bed departs from
    double slope_y = 0.0;
    double half_per_x = 0.0;  ///< 1 / 2dx
    double half_per_y = 0.0;
    double per_tangent = 0.0;             ///< 1 / tan of the angle of repose
    double turning = 0.0;                 ///< r
    double entrainment = 0.0;             ///< M over the grains' density, m/s; 0: none
    double per_entrainment_stress = 0.0;  ///< 1 / (τ_e/ρ)
    bool ashida_michiue = false;
};

struct PickUpRow {
    const double* depth;
    const double* u;
    const double* v;
    const double* friction;
    const double* bed;  ///< with cells beside it
    const double* bed_south;
    const double* bed_north;
};

/// What a row of cells gives to the flow.
struct PickedUp {
    double* along_x;  ///< bed load with the flow, m²/s
    double* along_y;
    double* down_slope;   ///< bed load per slope, m²/s
    double* entrainment;  ///< m/s
    double* bed_rate;  ///< of the bed: (3 |q_b| / h) · per_length + 2 · down_slope · per_area +
                       ///< E / (h + 0.1 / per_length), 1/s
};

/// `per_length` = 1/dx + 1/dy and `per_area` = 1/dx² + 1/dy². Writes along_x … down_slope where the
/// law has bed load, and entrainment where it has that.
void pick_up_row(const PickUpLaw& law, const PickUpRow& row, double per_length, double per_area,
                 int count, const PickedUp& out);

/// Cuts a row's entrainment to `per_height` times what lies above the floor.
void hold_above_row(const double* floor, const double* bed, double per_height, int count,
                    double* entrainment);

/// The largest of a row, 0 at least.
double largest_bed_rate(const double* bed_rate, int count);

/// Bed load through the faces between cells `low` and `high` along one axis: what goes with the
/// flow comes from the cell upstream; what turns down the slope is the mean of both.
struct FaceRow {
    const double* along_low;
    const double* along_high;
    const double* down_low;
    const double* down_high;
    const double* bed_low;
    const double* bed_high;
};
void face_row(const FaceRow& row, double per_length, double mean_slope, int count, double* flux);

/// What the faces and the water do to a row of the bed.
struct SettledRow {
    const double* depth;
    const double* entrainment;  ///< or null
    const double* west;         ///< bed load through the faces, or null
    const double* east;
    const double* south;
    const double* north;
};
struct SettlingFactors {
    double dt = 0.0;
    double dt_dx = 0.0;
    double dt_dy = 0.0;
    double settling = 0.0;    ///< α w_s, m/s
    double bed_factor = 1.0;  ///< height of the bed that a height of grains makes
};

/// Settles and takes up, settling implicit: `load` becomes that after the sub-step; the bed changes
/// by bed_factor times what it gains of grains.
void settle_row(const SettledRow& row, const SettlingFactors& factors, int count, double* load,
                double* bed);

}  // namespace fumon::loads
