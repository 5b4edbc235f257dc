#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/gdal/gdal_types.h"

namespace fumon {

/// A length of a coordinate reference system, as it names it.
struct NamedLength {
    double metres = 1.0;
    std::string name{};
};

/// A coordinate reference system as PROJ knows it through GDAL, longitude or easting first. A
/// GdalSession is held meanwhile.
class SpatialReference {
  public:
    /// From WKT of any kind (also a .prj file's), "EPSG:32613", or a PROJ string.
    explicit SpatialReference(const std::string& text);
    /// From the lines of words of an ARC/INFO projection file ("Projection    UTM").
    explicit SpatialReference(std::vector<std::string> lines);
    ~SpatialReference();
    SpatialReference(const SpatialReference&) = delete;
    SpatialReference& operator=(const SpatialReference&) = delete;

    [[nodiscard]] OGRSpatialReferenceH get() const { return handle_; }
    [[nodiscard]] bool understood() const { return understood_; }
    [[nodiscard]] bool is_geographic() const;
    [[nodiscard]] bool is_projected() const;
    [[nodiscard]] bool is_local() const;
    /// Degrees per angle of a geographic system.
    [[nodiscard]] double degrees_per_unit() const;
    /// The length that a projected or local system counts.
    [[nodiscard]] NamedLength length() const;
    /// The length that the heights of a compound system count; none in any other.
    [[nodiscard]] std::optional<NamedLength> height_length() const;
    /// Whether the vertical axis of a compound system points down.
    [[nodiscard]] bool heights_point_down() const;
    [[nodiscard]] std::string wkt() const;       ///< WKT 2 (2019); empty where there is none
    [[nodiscard]] std::string esri_wkt() const;  ///< as .prj files have it

    struct Scale {
        double east = 1.0;   ///< true length over length in the projection
        double north = 1.0;  ///< likewise
    };
    /// The scale of a projected system at a point, along its axes: two points a step apart brought
    /// to its ellipsoid (radii of curvature as in Snyder 1987, eqs. 4-18 and 4-19), rounded to
    /// 1e-9; none where the point cannot be transformed. `step` in the unit of the system.
    [[nodiscard]] std::optional<Scale> scale_at(double x, double y, double step) const;

  private:
    [[nodiscard]] std::string exported(const char* format) const;

    OGRSpatialReferenceH handle_;
    bool understood_ = false;
};

}  // namespace fumon
