#include "files/gdal/spatial_reference.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/elementary.h"
#include "files/gdal/gdal_functions.h"

namespace fumon {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;
constexpr const char* vertical = "VERT_CS";

/// Metres between two near points of an ellipsoid, longitudes and latitudes in degrees.
double distance(double semi_major, double inverse_flattening, const std::array<double, 2>& x,
                const std::array<double, 2>& y) {
    const double flattening = inverse_flattening == 0.0 ? 0.0 : 1.0 / inverse_flattening;
    const double eccentricity_squared = flattening * (2.0 - flattening);
    const double latitude = 0.5 * (y[0] + y[1]) * radians_per_degree;
    const double sine = elementary::sin(latitude);
    const double w_squared = 1.0 - eccentricity_squared * sine * sine;
    const double prime_vertical = semi_major / std::sqrt(w_squared);
    const double meridian = prime_vertical * (1.0 - eccentricity_squared) / w_squared;
    const double turn = std::remainder(x[1] - x[0], 360.0);
    const double east = prime_vertical * elementary::cos(latitude) * turn * radians_per_degree;
    const double north = meridian * (y[1] - y[0]) * radians_per_degree;
    return std::sqrt(east * east + north * north);
}

double rounded(double scale) {
    constexpr double digits = 1e9;
    return std::round(scale * digits) / digits;
}

}  // namespace

SpatialReference::SpatialReference(const std::string& text)
    : handle_(gdal().OSRNewSpatialReference(nullptr)),
      understood_(gdal().OSRSetFromUserInput(handle_, text.c_str()) == OGRERR_NONE) {
    gdal().OSRSetAxisMappingStrategy(handle_, OAMS_TRADITIONAL_GIS_ORDER);
}

SpatialReference::SpatialReference(std::vector<std::string> lines)
    : handle_(gdal().OSRNewSpatialReference(nullptr)) {
    std::vector<char*> texts;
    texts.reserve(lines.size() + 1);
    for (std::string& line : lines) texts.push_back(line.data());
    texts.push_back(nullptr);
    understood_ = gdal().OSRImportFromESRI(handle_, texts.data()) == OGRERR_NONE;
    gdal().OSRSetAxisMappingStrategy(handle_, OAMS_TRADITIONAL_GIS_ORDER);
}

SpatialReference::~SpatialReference() {
    gdal().OSRDestroySpatialReference(handle_);
}

bool SpatialReference::is_geographic() const {
    return gdal().OSRIsGeographic(handle_) != 0;
}

bool SpatialReference::is_projected() const {
    return gdal().OSRIsProjected(handle_) != 0;
}

bool SpatialReference::is_local() const {
    return gdal().OSRIsLocal(handle_) != 0;
}

double SpatialReference::degrees_per_unit() const {
    return gdal().OSRGetAngularUnits(handle_, nullptr) / radians_per_degree;
}

NamedLength SpatialReference::length() const {
    char* name = nullptr;  // the reference keeps it
    NamedLength length;
    length.metres = gdal().OSRGetLinearUnits(handle_, &name);
    if (name != nullptr) length.name = name;
    return length;
}

std::optional<NamedLength> SpatialReference::height_length() const {
    if (gdal().OSRIsCompound(handle_) == 0) return std::nullopt;
    char* name = nullptr;
    NamedLength length;
    length.metres = gdal().OSRGetTargetLinearUnits(handle_, vertical, &name);
    if (name != nullptr) length.name = name;
    return length;
}

bool SpatialReference::heights_point_down() const {
    if (gdal().OSRIsCompound(handle_) == 0) return false;
    OGRAxisOrientation orientation = OAO_Other;
    return gdal().OSRGetAxis(handle_, vertical, 0, &orientation) != nullptr &&
           orientation == OAO_Down;
}

std::string SpatialReference::exported(const char* format) const {
    const std::array<const char*, 3> form{format, "MULTILINE=NO", nullptr};
    char* text = nullptr;
    std::string result;
    if (gdal().OSRExportToWktEx(handle_, &text, form.data()) == OGRERR_NONE && text != nullptr)
        result = text;
    gdal().VSIFree(text);
    return result;
}

std::string SpatialReference::wkt() const {
    return exported("FORMAT=WKT2_2019");
}

std::string SpatialReference::esri_wkt() const {
    return exported("FORMAT=WKT1_ESRI");
}

std::optional<SpatialReference::Scale> SpatialReference::scale_at(double x, double y,
                                                                  double step) const {
    OGRSpatialReferenceH globe = gdal().OSRCloneGeogCS(handle_);
    if (globe == nullptr) return std::nullopt;
    gdal().OSRSetAxisMappingStrategy(globe, OAMS_TRADITIONAL_GIS_ORDER);
    OGRCoordinateTransformationH way = gdal().OCTNewCoordinateTransformation(handle_, globe);
    std::optional<Scale> scale;
    const double half = 0.5 * step;
    std::array<double, 4> east{x - half, x + half, x, x};
    std::array<double, 4> north{y, y, y - half, y + half};
    std::array<double, 4> height{};
    if (way != nullptr &&
        gdal().OCTTransform(way, 4, east.data(), north.data(), height.data()) != 0) {
        const double unit = gdal().OSRGetAngularUnits(globe, nullptr) / radians_per_degree;
        for (double& angle : east) angle *= unit;
        for (double& angle : north) angle *= unit;
        const double semi_major = gdal().OSRGetSemiMajor(handle_, nullptr);
        const double inverse_flattening = gdal().OSRGetInvFlattening(handle_, nullptr);
        const double length = step * gdal().OSRGetLinearUnits(handle_, nullptr);
        const Scale found{rounded(distance(semi_major, inverse_flattening, {east[0], east[1]},
                                           {north[0], north[1]}) /
                                  length),
                          rounded(distance(semi_major, inverse_flattening, {east[2], east[3]},
                                           {north[2], north[3]}) /
                                  length)};
        if (std::isfinite(found.east * found.north) && found.east > 0.0 && found.north > 0.0)
            scale = found;
    }
    if (way != nullptr) gdal().OCTDestroyCoordinateTransformation(way);
    gdal().OSRDestroySpatialReference(globe);
    return scale;
}

}  // namespace fumon
