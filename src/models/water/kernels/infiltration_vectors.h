#pragma once

namespace fumon::infiltration {

/// Takes up to `most` m from each depth of a row; `taken` gets what was there to take.
void take_row(double most, int count, double* depth, double* taken);

/// By Green & Ampt (1911): what the ground takes in a sub-step from F on, implicit, so that
/// F1 = F + K dt (1 + S / F1). `conductivity` is K dt (m), `suction` S = ψ Δθ (m), `total` F (m),
/// which grows by what was there to take.
void green_ampt_row(double conductivity, double suction, int count, double* depth, double* total,
                    double* taken);

}  // namespace fumon::infiltration
