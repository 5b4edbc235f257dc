#include "files/netcdf/grid_mapping.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/find_named.h"
#include "files/wkt.h"

namespace fumon {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// The letters and digits of a name, in small letters: "Lambert_Conformal_Conic_2SP" and "Lambert
/// Conic Conformal (2SP)" differ in their words alone.
std::string plain(std::string_view name) {
    std::string letters;
    for (const char letter : name) {
        if (letter >= 'A' && letter <= 'Z') letters += static_cast<char>(letter - 'A' + 'a');
        if ((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9')) letters += letter;
    }
    return letters;
}

enum class Parameter { latitude, longitude, parallel_1, parallel_2, scale, easting, northing };

using Parameters = std::map<Parameter, double>;

std::optional<Parameter> parameter_of(const std::string& name) {
    using Known = std::pair<std::string_view, Parameter>;
    constexpr std::array<Known, 22> known{{
        {"latitudeofnaturalorigin", Parameter::latitude},
        {"latitudeoforigin", Parameter::latitude},
        {"latitudeoffalseorigin", Parameter::latitude},
        {"latitudeofcenter", Parameter::latitude},
        {"latitudeofcentre", Parameter::latitude},
        {"longitudeofnaturalorigin", Parameter::longitude},
        {"longitudeoforigin", Parameter::longitude},
        {"longitudeoffalseorigin", Parameter::longitude},
        {"longitudeofcenter", Parameter::longitude},
        {"longitudeofcentre", Parameter::longitude},
        {"centralmeridian", Parameter::longitude},
        {"latitudeof1ststandardparallel", Parameter::parallel_1},
        {"latitudeofstandardparallel", Parameter::parallel_1},
        {"standardparallel1", Parameter::parallel_1},
        {"latitudeof2ndstandardparallel", Parameter::parallel_2},
        {"standardparallel2", Parameter::parallel_2},
        {"scalefactoratnaturalorigin", Parameter::scale},
        {"scalefactor", Parameter::scale},
        {"falseeasting", Parameter::easting},
        {"eastingatfalseorigin", Parameter::easting},
        {"falsenorthing", Parameter::northing},
        {"northingatfalseorigin", Parameter::northing},
    }};
    const auto* found = find_by(known, &Known::first, std::string_view(name));
    if (found == nullptr) return std::nullopt;
    return found->second;
}

double unit_of(const WktNode* node, double otherwise) {
    if (node == nullptr) return otherwise;
    const WktNode* unit = node->child({"ANGLEUNIT", "LENGTHUNIT", "SCALEUNIT", "UNIT"});
    return unit == nullptr ? otherwise : unit->number(1).value_or(otherwise);
}

/// The parameters in degrees and metres. Version 1 states their units once for all of them, version
/// 2 with each. Nothing where one of them is unknown, since it may move the map.
std::optional<Parameters> parameters_of(const WktNode& system) {
    const WktNode* conversion = system.child({"CONVERSION"});
    const double angle =
        unit_of(system.find({"GEOGCS", "BASEGEOGCRS", "BASEGEODCRS"}), radians_per_degree);
    const double length = conversion == nullptr ? unit_of(&system, 1.0) : 1.0;
    Parameters parameters;
    for (const WktNode& node : (conversion == nullptr ? system : *conversion).children) {
        if (node.keyword != "PARAMETER") continue;
        const auto value = node.number(1);
        if (!value) return std::nullopt;
        const auto parameter = parameter_of(plain(node.values.front()));
        if (!parameter) {
            if (*value != 0.0) return std::nullopt;
            continue;
        }
        double& kept = parameters[*parameter];
        if (*parameter == Parameter::scale) {
            kept = *value;
        } else if (*parameter == Parameter::easting || *parameter == Parameter::northing) {
            kept = *value * unit_of(&node, length);
        } else {
            const double factor = unit_of(&node, angle) / radians_per_degree;
            kept = std::abs(factor - 1.0) < 1e-9 ? *value : *value * factor;
        }
    }
    return parameters;
}

/// Gathers the attributes of a projection.
class Mapping {
  public:
    Mapping(std::string name, const Parameters& parameters) : parameters_(parameters) {
        mapping_.name = std::move(name);
    }

    [[nodiscard]] double value(Parameter parameter, double otherwise = 0.0) const {
        const auto found = parameters_.find(parameter);
        return found == parameters_.end() ? otherwise : found->second;
    }
    [[nodiscard]] bool has(Parameter parameter) const { return parameters_.contains(parameter); }

    Mapping& put(const char* attribute, Parameter parameter, double otherwise = 0.0) {
        return put(attribute, std::vector{value(parameter, otherwise)});
    }
    Mapping& put(const char* attribute, std::vector<double> values) {
        mapping_.attributes.emplace_back(attribute, std::move(values));
        return *this;
    }
    GridMapping done() {
        put("false_easting", Parameter::easting).put("false_northing", Parameter::northing);
        return std::move(mapping_);
    }

  private:
    const Parameters& parameters_;
    GridMapping mapping_;
};

GridMapping transverse_mercator(const Parameters& parameters) {
    return Mapping("transverse_mercator", parameters)
        .put("longitude_of_central_meridian", Parameter::longitude)
        .put("latitude_of_projection_origin", Parameter::latitude)
        .put("scale_factor_at_central_meridian", Parameter::scale, 1.0)
        .done();
}

/// With one standard parallel, which is then the origin's, or with two.
std::optional<GridMapping> lambert_conformal_conic(const Parameters& parameters) {
    Mapping mapping("lambert_conformal_conic", parameters);
    if (mapping.value(Parameter::scale, 1.0) != 1.0) return std::nullopt;
    std::vector parallels{mapping.value(Parameter::parallel_1, mapping.value(Parameter::latitude))};
    if (mapping.has(Parameter::parallel_2))
        parallels.push_back(mapping.value(Parameter::parallel_2));
    return mapping.put("standard_parallel", std::move(parallels))
        .put("longitude_of_central_meridian", Parameter::longitude)
        .put("latitude_of_projection_origin", Parameter::latitude)
        .done();
}

/// The pole is that of the standard parallel, which version 1 calls latitude_of_origin; at the pole
/// itself it is a scale that tells the size.
GridMapping polar_stereographic(const Parameters& parameters) {
    constexpr double pole = 90.0;
    Mapping mapping("polar_stereographic", parameters);
    const double parallel =
        mapping.value(Parameter::parallel_1, mapping.value(Parameter::latitude));
    mapping.put("straight_vertical_longitude_from_pole", Parameter::longitude)
        .put("latitude_of_projection_origin", std::vector{std::copysign(pole, parallel)});
    if (std::abs(parallel) == pole) {
        mapping.put("scale_factor_at_projection_origin", Parameter::scale, 1.0);
    } else {
        mapping.put("standard_parallel", std::vector{parallel});
    }
    return mapping.done();
}

GridMapping lambert_azimuthal_equal_area(const Parameters& parameters) {
    return Mapping("lambert_azimuthal_equal_area", parameters)
        .put("longitude_of_projection_origin", Parameter::longitude)
        .put("latitude_of_projection_origin", Parameter::latitude)
        .done();
}

GridMapping albers(const Parameters& parameters) {
    Mapping mapping("albers_conical_equal_area", parameters);
    return mapping
        .put("standard_parallel", std::vector{mapping.value(Parameter::parallel_1),
                                              mapping.value(Parameter::parallel_2)})
        .put("longitude_of_central_meridian", Parameter::longitude)
        .put("latitude_of_projection_origin", Parameter::latitude)
        .done();
}

std::optional<GridMapping> mercator(const Parameters& parameters) {
    Mapping mapping("mercator", parameters);
    if (mapping.value(Parameter::latitude) != 0.0) return std::nullopt;
    mapping.put("longitude_of_projection_origin", Parameter::longitude);
    if (mapping.has(Parameter::parallel_1)) {
        mapping.put("standard_parallel", Parameter::parallel_1);
    } else {
        mapping.put("scale_factor_at_projection_origin", Parameter::scale, 1.0);
    }
    return mapping.done();
}

std::optional<GridMapping> projection_of(const WktNode& system) {
    const WktNode* method = system.find({"METHOD", "PROJECTION"});
    const auto parameters = parameters_of(system);
    if (method == nullptr || method->values.empty() || !parameters) return std::nullopt;
    const std::string name = plain(method->values.front());
    if (name == "transversemercator" || name == "gausskruger")
        return transverse_mercator(*parameters);
    if (name.starts_with("lambertconicconformal") || name.starts_with("lambertconformalconic"))
        return lambert_conformal_conic(*parameters);
    if (name.starts_with("polarstereographic") || name == "stereographicnorthpole" ||
        name == "stereographicsouthpole")
        return polar_stereographic(*parameters);
    if (name == "lambertazimuthalequalarea") return lambert_azimuthal_equal_area(*parameters);
    if (name == "albersequalarea" || name == "albers" || name == "albersconicequalarea")
        return albers(*parameters);
    if (name == "mercatorvarianta" || name == "mercatorvariantb" || name == "mercator1sp" ||
        name == "mercator2sp" || name == "mercator" ||
        name == "popularvisualisationpseudomercator" || name == "mercatorauxiliarysphere")
        return mercator(*parameters);
    return std::nullopt;
}

/// Whether a Mercator map takes the ellipsoid's latitudes for those of a sphere, as EPSG:3857 does.
bool is_on_a_sphere(const WktNode& system) {
    const WktNode* method = system.find({"METHOD", "PROJECTION"});
    const std::string name =
        method == nullptr || method->values.empty() ? "" : plain(method->values.front());
    if (name == "popularvisualisationpseudomercator" || name == "mercatorauxiliarysphere")
        return true;
    const WktNode* extension = system.child({"EXTENSION"});
    return extension != nullptr && extension->values.size() > 1 &&
           extension->values[1].find("+b=6378137 ") != std::string::npos;
}

void put_figure_of_the_earth(GridMapping& mapping, const WktNode& system) {
    const WktNode* ellipsoid = system.find({"ELLIPSOID", "SPHEROID"});
    if (ellipsoid != nullptr && ellipsoid->number(1)) {
        const double axis = *ellipsoid->number(1) * unit_of(ellipsoid, 1.0);
        const double flattening = ellipsoid->number(2).value_or(0.0);
        mapping.attributes.push_back({"semi_major_axis", {axis}});
        if (flattening == 0.0 || is_on_a_sphere(system)) {
            mapping.attributes.push_back({"semi_minor_axis", {axis}});
        } else {
            mapping.attributes.push_back({"inverse_flattening", {flattening}});
        }
    }
    const WktNode* meridian = system.find({"PRIMEM", "PRIMEMERIDIAN"});
    const double longitude = meridian == nullptr ? 0.0 : meridian->number(1).value_or(0.0);
    const double factor = unit_of(meridian, unit_of(system.find({"GEOGCS"}), radians_per_degree)) /
                          radians_per_degree;
    mapping.attributes.push_back({"longitude_of_prime_meridian", {longitude * factor}});
}

}  // namespace

std::optional<GridMapping> grid_mapping_of(std::string_view wkt) {
    const auto root = parse_wkt(wkt);
    if (!root) return std::nullopt;
    std::optional<GridMapping> mapping;
    const WktNode* system = root->find({"PROJCRS", "PROJECTEDCRS", "PROJCS"});
    if (system != nullptr) {
        mapping = projection_of(*system);
    } else if ((system = root->find(
                    {"GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS", "GEOGCS"})) != nullptr) {
        mapping.emplace().name = "latitude_longitude";
    }
    if (mapping) put_figure_of_the_earth(*mapping, *system);
    return mapping;
}

}  // namespace fumon
