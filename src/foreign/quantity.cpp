#include "foreign/quantity.h"

#include <algorithm>
#include <utility>

namespace fumon {

namespace {

constexpr std::array<QuantityFacts, quantity_count> all_quantities{{
    {Quantity::bed, "bed", "bed", "m"},
    {Quantity::depth, "depth", "water depth", "m"},
    {Quantity::level, "level", "water level", "m"},
    {Quantity::velocity_x, "u", "velocity along the columns", "m s-1"},
    {Quantity::velocity_y, "v", "velocity along the rows", "m s-1"},
    {Quantity::flux_x, "qx", "discharge per width along the columns", "m2 s-1"},
    {Quantity::flux_y, "qy", "discharge per width along the rows", "m2 s-1"},
    {Quantity::concentration, "concentration", "sediment in the water", "kg m-3"},
}};

using StandardName = std::pair<std::string_view, Quantity>;

constexpr std::array<StandardName, 33> standard_names{{
    {"surface_altitude", Quantity::bed},
    {"altitude", Quantity::bed},
    {"height_above_reference_ellipsoid", Quantity::bed},
    {"height_above_geopotential_datum", Quantity::bed},
    {"height_above_mean_sea_level", Quantity::bed},
    {"bedrock_altitude", Quantity::bed},
    {"ground_level_altitude", Quantity::bed},
    {"sea_floor_depth", Quantity::bed},
    {"sea_floor_depth_below_geoid", Quantity::bed},
    {"sea_floor_depth_below_geopotential_datum", Quantity::bed},
    {"sea_floor_depth_below_mean_sea_level", Quantity::bed},
    {"sea_floor_depth_below_reference_ellipsoid", Quantity::bed},
    {"sea_floor_depth_below_sea_level", Quantity::bed},
    {"flood_water_thickness", Quantity::depth},
    {"sea_floor_depth_below_sea_surface", Quantity::depth},
    {"water_depth", Quantity::depth},
    {"sea_surface_height", Quantity::level},
    {"sea_surface_height_above_geoid", Quantity::level},
    {"sea_surface_height_above_geopotential_datum", Quantity::level},
    {"sea_surface_height_above_mean_sea_level", Quantity::level},
    {"sea_surface_height_above_reference_ellipsoid", Quantity::level},
    {"sea_surface_elevation", Quantity::level},
    {"water_surface_height_above_reference_datum", Quantity::level},
    {"water_surface_altitude", Quantity::level},
    {"sea_water_x_velocity", Quantity::velocity_x},
    {"eastward_sea_water_velocity", Quantity::velocity_x},
    {"barotropic_sea_water_x_velocity", Quantity::velocity_x},
    {"barotropic_eastward_sea_water_velocity", Quantity::velocity_x},
    {"sea_water_y_velocity", Quantity::velocity_y},
    {"northward_sea_water_velocity", Quantity::velocity_y},
    {"barotropic_sea_water_y_velocity", Quantity::velocity_y},
    {"barotropic_northward_sea_water_velocity", Quantity::velocity_y},
    {"mass_concentration_of_suspended_matter_in_sea_water", Quantity::concentration},
}};

}  // namespace

const std::array<QuantityFacts, quantity_count>& quantities() {
    return all_quantities;
}

const QuantityFacts& facts_of(Quantity quantity) {
    return *std::ranges::find(all_quantities, quantity, &QuantityFacts::quantity);
}

std::optional<Quantity> quantity_of_key(std::string_view key) {
    const auto found = std::ranges::find(all_quantities, key, &QuantityFacts::key);
    if (found == all_quantities.end()) return std::nullopt;
    return found->quantity;
}

std::optional<Quantity> quantity_of_standard_name(std::string_view name) {
    const auto found = std::ranges::find(standard_names, name, &StandardName::first);
    if (found == standard_names.end()) return std::nullopt;
    return found->second;
}

std::string quantity_keys() {
    std::string text;
    for (std::size_t i = 0; i < quantity_count; ++i) {
        if (i > 0) text += i + 1 == quantity_count ? " and " : ", ";
        text += all_quantities[i].key;
    }
    return text;
}

}  // namespace fumon
