#include "render/view/water.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/find_named.h"
#include "base/snapshot_lookup.h"
#include "numerics/percentile.h"

namespace fumon {

namespace {

constexpr double gravity = 9.8;       // m/s²
constexpr double pond_clarity = 0.6;  // of the high depth
constexpr double film_clarity = 3.4;  // more than a pond's, for a film that is as deep everywhere

}  // namespace

const Grid& water_field(const Snapshot& snapshot, std::string_view name) {
    const Grid* field = field_of(snapshot.fields, name);
    if (field == nullptr) throw InputError(fmt::format("there is no {} to show", name));
    return *field;
}

bool has_water(const Snapshot& snapshot) {
    const auto has = [&](const char* name) { return field_of(snapshot.fields, name) != nullptr; };
    return has("water_depth") && has("velocity_x") && has("velocity_y");
}

bool draws_water(const LookSettings& look, const Snapshot& snapshot) {
    return look.water && look.mode == ViewMode::scenic && has_water(snapshot);
}

Mask dry_cells(const Snapshot& snapshot) {
    if (!has_water(snapshot)) return {};
    const Grid& depth = water_field(snapshot, "water_depth");
    Mask dry(depth.nx(), depth.ny());
    for (std::size_t i = 0; i < dry.size(); ++i) {
        const bool outside = !snapshot.nodata.empty() && snapshot.nodata.values()[i] != 0;
        dry.values()[i] = outside || !(depth.values()[i] > least_wet_depth) ? 1 : 0;
    }
    return dry;
}

Field<float> water_depths(const Snapshot& snapshot) {
    const Grid& depth = water_field(snapshot, "water_depth");
    const Mask dry = dry_cells(snapshot);
    Field<float> result(depth.nx(), depth.ny());
    for (std::size_t i = 0; i < result.size(); ++i)
        result.values()[i] = dry.values()[i] != 0 ? 0.0F : static_cast<float>(depth.values()[i]);
    return result;
}

Field<float> water_speed(const Snapshot& snapshot) {
    const Grid& u = water_field(snapshot, "velocity_x");
    const Grid& v = water_field(snapshot, "velocity_y");
    const Mask dry = dry_cells(snapshot);
    Field<float> speed(u.nx(), u.ny());
    for (std::size_t i = 0; i < speed.size(); ++i) {
        if (dry.values()[i] != 0) continue;
        const double x = u.values()[i];
        const double y = v.values()[i];
        speed.values()[i] = static_cast<float>(std::sqrt(x * x + y * y));
    }
    return speed;
}

Field<float> froude_numbers(const Snapshot& snapshot) {
    const Grid& depth = water_field(snapshot, "water_depth");
    const Mask dry = dry_cells(snapshot);
    Field<float> froude = water_speed(snapshot);
    for (std::size_t i = 0; i < froude.size(); ++i) {
        float& number = froude.values()[i];
        if (dry.values()[i] == 0)
            number /= static_cast<float>(std::sqrt(gravity * depth.values()[i]));
    }
    return froude;
}

double closed_depth(const WorldScale& scale) {
    constexpr double closed_depth_at_1_m = 0.004;  // m
    constexpr double none = 1e-12;                 // m
    if (!scale.in_metres) return none;
    return closed_depth_at_1_m * std::sqrt(std::min(scale.dx, scale.dy));
}

WaterStatistics water_statistics(const Snapshot& snapshot) {
    if (!has_water(snapshot)) return {};
    const Grid& depth = water_field(snapshot, "water_depth");
    const Mask dry = dry_cells(snapshot);
    const Field<float> froude = froude_numbers(snapshot);
    std::vector<float> depths;
    std::vector<float> numbers;
    for (std::size_t i = 0; i < dry.size(); ++i) {
        if (dry.values()[i] != 0) continue;
        depths.push_back(static_cast<float>(depth.values()[i]));
        numbers.push_back(froude.values()[i]);
    }
    return {percentile(depths, 0.99), percentile(depths, 0.5), percentile(numbers, 0.5)};
}

double water_clarity(const LookSettings& look, const WaterStatistics& water) {
    if (!look.water_clarity.is_word()) return look.water_clarity.value;
    if (!(water.high_depth > 0.0)) return 1.0;
    const double evenness = water.median_depth / water.high_depth;
    const double squared = evenness * evenness;
    return water.high_depth * (pond_clarity + film_clarity * squared * squared);
}

Field<float> suspended_turbidities(const Snapshot& snapshot) {
    constexpr double half_muddy = 0.0615;  // kg/m³
    const SnapshotField* sediment = find_named(snapshot.fields, "concentration");
    if (sediment == nullptr || sediment->unit != "kg/m3" || !has_water(snapshot)) return {};
    const Mask dry = dry_cells(snapshot);
    Field<float> silt(dry.nx(), dry.ny());
    for (std::size_t i = 0; i < silt.size(); ++i) {
        const double carried = sediment->values.values()[i];
        if (dry.values()[i] == 0 && carried > 0.0)
            silt.values()[i] = static_cast<float>(carried / (carried + half_muddy));
    }
    return silt;
}

double mean_turbidity(const LookSettings& look, const Snapshot& snapshot) {
    const Field<float> silt = suspended_turbidities(snapshot);
    if (silt.empty()) return look.turbidity;
    const Field<float> depth = water_depths(snapshot);
    double water = 0.0;
    double muddy = 0.0;
    for (std::size_t i = 0; i < silt.size(); ++i) {
        water += depth.values()[i];
        muddy += double{depth.values()[i]} * silt.values()[i];
    }
    return std::lerp(look.turbidity, 1.0, water > 0.0 ? muddy / water : 0.0);
}

}  // namespace fumon
