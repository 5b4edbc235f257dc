#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fumon {

/// A coordinate reference system as CF 1.8 tells it (its appendix F): the name of the projection
/// and its attributes, angles in degrees and lengths in metres.
struct GridMapping {
    std::string name;  ///< "transverse_mercator" …
    std::vector<std::pair<std::string, std::vector<double>>> attributes;
};

/// That of a system's well-known text of version 1 or 2: geographic, and projected by transverse
/// Mercator (UTM, Gauss-Krüger), Lambert's conformal cone, polar stereography, Lambert's equal-area
/// azimuth, Albers' cone and Mercator. Nothing for another projection, for one whose numbers CF has
/// no attribute for, and for a text that cannot be read.
std::optional<GridMapping> grid_mapping_of(std::string_view wkt);

}  // namespace fumon
