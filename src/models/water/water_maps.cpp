#include "models/water/water_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/compensated_sum.h"
#include "base/error.h"

namespace fumon {

namespace {

std::string map_key(std::size_t number, const char* key) {
    return fmt::format("map.{}.{}", number, key);
}

bool is_inside(const WaterDomain& domain, std::size_t cell) {
    return domain.nodata.empty() || domain.nodata.values()[cell] == 0;
}

/// The map of a quantity, of which there is at most one; or nullptr.
const CellMap* find_map(const GullyParameters& parameters, const std::vector<CellMap>& maps,
                        MapQuantity quantity) {
    for (std::size_t n = 0; n < maps.size(); ++n) {
        if (parameters.maps[n].quantity == quantity) return &maps[n];
    }
    return nullptr;
}

/// What a quantity may be, and what it is called.
struct Bounds {
    double low = 0.0;
    double high = 0.0;
    bool above = false;  ///< more than `low`
    const char* unit = "";
};

Bounds bounds_of(const GullyParameters& parameters, MapQuantity quantity) {
    constexpr double fastest = 1e3;
    constexpr double highest = 1e5;
    constexpr double deepest = 1e4;
    const bool chezy = parameters.friction == FrictionLaw::chezy;
    switch (quantity) {
        case MapQuantity::rain:
            return {0.0, highest, false, " mm/h"};
        case MapQuantity::roughness:
            return {0.0, chezy ? deepest : 10.0, chezy, ""};
        case MapQuantity::infiltration_rate:
            return {0.0, highest, false, " mm/h"};
        case MapQuantity::infiltration_start:
            return {0.0, fastest * fastest, false, " mm/h"};
        case MapQuantity::suction_head:
            return {0.0, 100.0, false, " m"};
        case MapQuantity::moisture_deficit:
            return {0.0, 1.0, false, ""};
        case MapQuantity::depth:
            return {0.0, deepest, false, " m"};
        case MapQuantity::level:
            return {-highest, highest, false, " m"};
        case MapQuantity::velocity_x:
        case MapQuantity::velocity_y:
            return {-fastest, fastest, false, " m/s"};
    }
    return {};
}

/// Whether a map says what is there at the start, which cells without data leave as it is.
bool is_of_start(MapQuantity quantity) {
    return quantity == MapQuantity::depth || quantity == MapQuantity::level ||
           quantity == MapQuantity::velocity_x || quantity == MapQuantity::velocity_y;
}

/// Throws KeyError where a map says of the soil what the law of infiltration does not ask for.
void check_soil(const GullyParameters& parameters, std::size_t n) {
    const InfiltrationLaw law = parameters.infiltration;
    const char* of = nullptr;
    switch (parameters.maps[n].quantity) {
        case MapQuantity::infiltration_rate:
            if (law == InfiltrationLaw::none) of = "\"constant\", \"horton\" or \"green-ampt\"";
            break;
        case MapQuantity::infiltration_start:
            if (law != InfiltrationLaw::horton) of = "\"horton\"";
            break;
        case MapQuantity::suction_head:
        case MapQuantity::moisture_deficit:
            if (law != InfiltrationLaw::green_ampt) of = "\"green-ampt\"";
            break;
        default:
            break;
    }
    if (of == nullptr) return;
    throw KeyError(
        map_key(n, "quantity"),
        fmt::format("belongs to another kind of infiltration; write model.infiltration = {}", of));
}

void check_values(const GullyParameters& parameters, const WaterDomain& domain, std::size_t n,
                  const CellMap& map) {
    const MapQuantity quantity = parameters.maps[n].quantity;
    const bool everywhere = !is_of_start(quantity);
    const Bounds bounds = bounds_of(parameters, quantity);
    const auto nx = static_cast<std::size_t>(map.values.nx());
    for (std::size_t cell = 0; cell < map.values.size(); ++cell) {
        if (!is_inside(domain, cell)) continue;
        if (!map.has(cell)) {
            if (!everywhere) continue;
            throw KeyError(map_key(n, "file"),
                           fmt::format("has no value for cell ({}, {}) of the bed; fill its gaps, "
                                       "or take a file that covers the bed",
                                       cell % nx, cell / nx));
        }
        const double value = map.values.values()[cell];
        const bool allowed =
            value >= bounds.low && value <= bounds.high && !(bounds.above && value == bounds.low);
        if (allowed) continue;
        throw KeyError(
            map_key(n, "file"),
            fmt::format("is {:g}{} in cell ({}, {}) of the bed; it must be {} {:g} and "
                        "at most {:g}{}",
                        value, bounds.unit, cell % nx, cell / nx,
                        bounds.above ? "above" : "at least", bounds.low, bounds.high, bounds.unit));
    }
}

}  // namespace

bool has_map(const GullyParameters& parameters, MapQuantity quantity) {
    return std::ranges::any_of(parameters.maps,
                               [&](const MapSettings& map) { return map.quantity == quantity; });
}

void check_maps(const GullyParameters& parameters, const WaterDomain& domain,
                const std::vector<CellMap>& maps) {
    if (maps.size() != parameters.maps.size())
        throw Error("the setup has no grids for the maps of the parameters");
    const MapSettings* rain_before = nullptr;
    for (std::size_t n = 0; n < maps.size(); ++n) {
        const MapSettings& map = parameters.maps[n];
        if (map.quantity == MapQuantity::rain) {
            if (rain_before != nullptr && !(map.from > rain_before->from)) {
                throw KeyError(
                    map_key(n, "from"),
                    fmt::format("this rain must begin after the rain of the map before, at {:g} s",
                                rain_before->from));
            }
            rain_before = &map;
        } else if (map.from != 0.0) {
            throw KeyError(map_key(n, "from"), "only maps of rain have a start; leave the key out");
        }
        for (std::size_t other = 0; other < n; ++other) {
            const MapQuantity first = parameters.maps[other].quantity;
            const bool both_deep =
                (first == MapQuantity::depth && map.quantity == MapQuantity::level) ||
                (first == MapQuantity::level && map.quantity == MapQuantity::depth);
            if (both_deep || (first == map.quantity && map.quantity != MapQuantity::rain)) {
                throw KeyError(
                    map_key(n, "quantity"),
                    fmt::format("map.{} already sets this quantity; leave one of them out", other));
            }
        }
        check_soil(parameters, n);
        check_values(parameters, domain, n, maps[n]);
    }
    if (rain_before == nullptr) return;
    if (parameters.rain > 0.0 || !parameters.rain_times.empty()) {
        throw KeyError(parameters.rain > 0.0 ? "model.rain" : "model.rain_times",
                       "a [[map]] already sets the rain; leave one of them out");
    }
}

void fill_from_maps(const GullyParameters& parameters, const WaterDomain& domain, const Grid& bed,
                    const std::vector<CellMap>& maps, Water& water) {
    const CellMap* depths = find_map(parameters, maps, MapQuantity::depth);
    const CellMap* levels = find_map(parameters, maps, MapQuantity::level);
    const CellMap* eastward = find_map(parameters, maps, MapQuantity::velocity_x);
    const CellMap* northward = find_map(parameters, maps, MapQuantity::velocity_y);
    const auto has = [](const CellMap* map, std::size_t cell) {
        return map != nullptr && map->has(cell);
    };
    for (std::size_t cell = 0; cell < bed.size(); ++cell) {
        if (!is_inside(domain, cell)) continue;
        double& depth = water.depth.values()[cell];
        double& u = water.velocity_x.values()[cell];
        double& v = water.velocity_y.values()[cell];
        if (has(depths, cell)) depth = depths->values.values()[cell];
        if (has(levels, cell))
            depth = std::max(levels->values.values()[cell] - bed.values()[cell], 0.0);
        if (has(eastward, cell)) u = eastward->values.values()[cell];
        if (has(northward, cell)) v = northward->values.values()[cell];
        if (!(depth > 0.0)) u = v = 0.0;
    }
}

Grid roughness_of(const GullyParameters& parameters, const WaterDomain& domain,
                  const std::vector<CellMap>& maps) {
    const CellMap* map = find_map(parameters, maps, MapQuantity::roughness);
    if (map == nullptr) return {};
    Grid roughness = map->values;
    for (std::size_t cell = 0; cell < roughness.size(); ++cell) {
        if (!is_inside(domain, cell)) roughness.values()[cell] = 1.0;  // where no water is
    }
    return roughness;
}

Soil soil_of(const GullyParameters& parameters, const WaterDomain& domain,
             const std::vector<CellMap>& maps) {
    const auto of_cells = [&](MapQuantity quantity, double unit) {
        const CellMap* map = find_map(parameters, maps, quantity);
        if (map == nullptr) return Grid();
        Grid values = map->values;
        for (std::size_t cell = 0; cell < values.size(); ++cell) {
            double& value = values.values()[cell];
            value = is_inside(domain, cell) ? value * unit : 0.0;
        }
        return values;
    };
    Soil soil{of_cells(MapQuantity::infiltration_rate, millimetre_per_hour),
              of_cells(MapQuantity::infiltration_start, millimetre_per_hour),
              of_cells(MapQuantity::suction_head, 1.0)};
    const Grid deficit = of_cells(MapQuantity::moisture_deficit, 1.0);
    if (deficit.empty()) {
        for (double& head : soil.suction.values()) head *= parameters.moisture_deficit;
    } else if (soil.suction.empty()) {
        soil.suction = deficit;
        for (double& suction : soil.suction.values()) suction = parameters.suction_head * suction;
    } else {
        for (std::size_t cell = 0; cell < deficit.size(); ++cell)
            soil.suction.values()[cell] *= deficit.values()[cell];
    }
    return soil;
}

std::vector<RainMap> rain_maps_of(const GullyParameters& parameters, const WaterDomain& domain,
                                  const std::vector<CellMap>& maps) {
    std::vector<RainMap> rains;
    for (std::size_t n = 0; n < maps.size(); ++n) {
        if (parameters.maps[n].quantity != MapQuantity::rain) continue;
        RainMap rain{parameters.maps[n].from, maps[n].values, 0.0};
        CompensatedSum sum;
        for (std::size_t cell = 0; cell < rain.rate.size(); ++cell) {
            double& rate = rain.rate.values()[cell];
            rate = is_inside(domain, cell) ? rate * millimetre_per_hour : 0.0;
            sum.add(rate);
        }
        rain.volume = domain.dx * domain.dy * sum.value();
        rains.push_back(std::move(rain));
    }
    return rains;
}

}  // namespace fumon
