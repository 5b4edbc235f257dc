#pragma once

namespace fumon::infiltration {

/// How fast the ground takes water in a sub-step: f + (f0 − f) · fallen, m/s.
struct Rates {
    const double* rate;   ///< f
    const double* start;  ///< f0
    double fallen;
    double dt;  ///< s
};

/// Takes what the ground can from each depth of a row; `taken` gets what was there to take.
void take_row(const Rates& rates, int count, double* depth, double* taken);

/// Of the law of Horton by what a cell has taken: f and f0 (m/s) of each cell.
struct Capacity {
    const double* rate;
    const double* start;
    double decay;  ///< k, 1/s
    double falls;  ///< e^(−k dt)
    double lasts;  ///< (1 − e^(−k dt)) / k, s
    double stays;  ///< e^(−r dt), r the recovery
    double dt;     ///< s
};

/// Takes from each depth up to ∫ (f + (f0 − f) c e^(−k t)) dt over the sub-step. c is `fallen`, and
/// falls by the time in which the ground could have taken what it took; where there was nothing,
/// 1 − c falls by the recovery.
void horton_row(const Capacity& capacity, int count, double* depth, double* fallen, double* taken);

/// Of the law of Green & Ampt: K (m/s) and S = ψ Δθ (m) of each cell.
struct WettingFront {
    const double* conductivity;
    const double* suction;
    double dt;  ///< s
};

/// By Green & Ampt (1911): what the ground takes in a sub-step from F on, implicit, so that
/// F1 = F + K dt (1 + S / F1). `total` is F (m), which grows by what was there to take.
void green_ampt_row(const WettingFront& front, int count, double* depth, double* total,
                    double* taken);

}  // namespace fumon::infiltration
