#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fumon {

/// What a field of another model's run is to fumon.
enum class Quantity { bed, depth, level, velocity_x, velocity_y, flux_x, flux_y, concentration };

inline constexpr std::size_t quantity_count = 8;

/// A quantity as options, tables and messages call it.
struct QuantityFacts {
    Quantity quantity;
    std::string_view key;   ///< "depth", of --field and of variables.toml
    std::string_view name;  ///< "water depth"
    std::string_view unit;  ///< in fumon, as UDUNITS writes it
};

/// All of them, in their order.
const std::array<QuantityFacts, quantity_count>& quantities();

const QuantityFacts& facts_of(Quantity quantity);

/// The quantity of a key; nothing where it is none.
std::optional<Quantity> quantity_of_key(std::string_view key);

/// The quantity that a CF standard name means, or a name in their style that files have
/// ("water_depth", "water_surface_altitude", "sea_surface_elevation"); nothing for others.
std::optional<Quantity> quantity_of_standard_name(std::string_view name);

/// "bed, depth, level, u, v, qx, qy and concentration".
std::string quantity_keys();

}  // namespace fumon
