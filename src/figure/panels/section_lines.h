#pragma once

#include <string>
#include <vector>

#include "base/snapshot.h"
#include "figure/panels/axis_units.h"
#include "figure/plot/plot.h"

namespace fumon {

/// The shear stress along the bed, in Pa, and the cosine fitted to it, where the snapshot has the
/// numbers of the fit. `unit` is what lengths are shown in.
Plot stress_plot(const Snapshot& snapshot, const LengthUnit& unit);

/// The flight length over the launch place, per launch angle.
Plot flights_plot(const Snapshot& snapshot, const LengthUnit& unit);

/// The flight length over the bed's height at the launch place, per launch angle, with the law
/// l = a^h - 1 (Terada 2025, section 4; millimetres) where the snapshot has the number "hop_base".
Plot flight_law_plot(const Snapshot& snapshot, const LengthUnit& unit);

/// The curves of that prefix: "flight_length_" …
std::vector<const SectionCurve*> section_curves(const SnapshotSection& section,
                                                const std::string& prefix);

/// The height of the bed's highest point, metres.
double highest_bed(const Snapshot& snapshot);

}  // namespace fumon
