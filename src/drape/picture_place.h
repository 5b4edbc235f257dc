#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace fumon {

/// Where a picture's pixels lie: column c and row r from its upper left corner, counted to a
/// pixel's edge, are at x = t[0] + c·t[1] + r·t[2], y = t[3] + c·t[4] + r·t[5] of its reference
/// system.
struct PicturePlace {
    std::array<double, 6> transform{0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
    std::string crs{};  ///< as WKT; empty where it is unknown
};

/// By the world file beside a picture (.pgw, .jgw, .wld …) and, for its reference system, the .prj
/// or .aux.xml file there; none where there is no world file. Throws InputError for one that does
/// not hold six numbers.
std::optional<PicturePlace> place_beside(const std::filesystem::path& picture);

}  // namespace fumon
