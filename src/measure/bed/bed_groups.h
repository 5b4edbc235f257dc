#pragma once

#include "measure/bed/bed_findings.h"
#include "measure/shared/measure_group.h"

namespace fumon {

/// Mean, spread and extremes of the heights, and their sum: "total_sand" where a model says that
/// the bed is sand, else "bed_volume".
MeasureGroup statistics_group(const Snapshot& first, const SharedFindings& findings);
/// The three wavelengths and the two heights of waves.
MeasureGroup wave_group(const Snapshot& first, const SharedFindings& findings);
/// Celerity since the row before.
MeasureGroup celerity_group(const Snapshot& first, const SharedFindings& findings);
MeasureGroup slope_group(const Snapshot& first, const SharedFindings& findings);
/// Angle and cover of slip faces, of a model that tells its wind shadow; of others no columns.
MeasureGroup slip_face_group(const Snapshot& first);
/// Orientation and defects of crests.
MeasureGroup crest_group(const Snapshot& first, const SharedFindings& findings);
/// Separate dunes.
MeasureGroup dune_group();
/// Dunes that stand alone, of a model that tells its winds and its sand; of others no columns.
MeasureGroup isolated_dune_group(const Snapshot& first);
/// Which way crests run, and which way theories say that they do under the run's winds, of a model
/// that tells these; of others no columns.
MeasureGroup crest_direction_group(const Snapshot& first, const SharedFindings& findings);
/// What the run's winds move, and on balance (DP, RDP, RDP/DP, RDD), of a model that tells its
/// winds; of others no columns.
MeasureGroup drift_group(const Snapshot& first);

}  // namespace fumon
