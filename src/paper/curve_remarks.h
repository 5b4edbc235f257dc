#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "paper/figure_curve.h"
#include "scene/figure/figure_settings.h"

namespace fumon {

/// The most runs that a point of these curves, those of one curve of the scene, has behind it; 0
/// where they count none.
std::int64_t runs_of_whole_points(const std::vector<CurvePoints>& curves);

/// Adds what a caption says of the points of the panel's curve `number`, from 0: what its bars are,
/// of how many runs its points are where that changes, and where bars are cut. `marked`: it is
/// drawn with markers.
void add_remarks(std::vector<std::string>& remarks, const PanelSettings& panel, std::size_t number,
                 const std::vector<CurvePoints>& curves, bool marked);

}  // namespace fumon
