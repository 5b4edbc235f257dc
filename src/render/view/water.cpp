#include "render/view/water.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "numerics/percentile.h"
#include "numerics/resampling.h"

namespace fumon {

namespace {

constexpr double gravity = 9.8;       // m/s²
constexpr double pond_clarity = 0.6;  // of the high depth
constexpr double film_clarity = 3.4;  // more than a pond's, for a film that is as deep everywhere

const Grid& values_of(const Snapshot& snapshot, std::string_view name) {
    const Grid* field = field_of(snapshot.fields, name);
    if (field == nullptr) throw InputError(fmt::format("there is no {} to show", name));
    return *field;
}

/// Each value averaged with its eight neighbours; beyond the border the edge cells are repeated.
Field<float> averaged(const Field<float>& values) {
    const int nx = values.nx();
    const int ny = values.ny();
    Field<float> along(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            along(x, y) = (values(std::max(x - 1, 0), y) + values(x, y) +
                           values(std::min(x + 1, nx - 1), y)) /
                          3.0F;
        }
    }
    Field<float> result(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            result(x, y) =
                (along(x, std::max(y - 1, 0)) + along(x, y) + along(x, std::min(y + 1, ny - 1))) /
                3.0F;
        }
    }
    return result;
}

Field<float> dampness(const Grid& depth, const Mask& dry, double closed) {
    Field<float> wet(dry.nx(), dry.ny());
    for (std::size_t i = 0; i < wet.size(); ++i) {
        if (dry.values()[i] != 0) continue;
        const double share = depth.values()[i] / closed;
        wet.values()[i] = share < 1.0 ? static_cast<float>(std::sqrt(share)) : 1.0F;
    }
    Field<float> damp = averaged(averaged(wet));
    for (std::size_t i = 0; i < damp.size(); ++i)
        damp.values()[i] = std::max(damp.values()[i], wet.values()[i]);
    return damp;
}

}  // namespace

bool has_water(const Snapshot& snapshot) {
    const auto has = [&](const char* name) { return field_of(snapshot.fields, name) != nullptr; };
    return has("water_depth") && has("velocity_x") && has("velocity_y");
}

bool draws_water(const LookSettings& look, const Snapshot& snapshot) {
    return look.water && look.mode == ViewMode::scenic && has_water(snapshot);
}

Mask dry_cells(const Snapshot& snapshot) {
    if (!has_water(snapshot)) return {};
    const Grid& depth = values_of(snapshot, "water_depth");
    Mask dry(depth.nx(), depth.ny());
    for (std::size_t i = 0; i < dry.size(); ++i) {
        const bool outside = !snapshot.nodata.empty() && snapshot.nodata.values()[i] != 0;
        dry.values()[i] = outside || !(depth.values()[i] > least_wet_depth) ? 1 : 0;
    }
    return dry;
}

Field<float> water_depths(const Snapshot& snapshot) {
    const Grid& depth = values_of(snapshot, "water_depth");
    const Mask dry = dry_cells(snapshot);
    Field<float> result(depth.nx(), depth.ny());
    for (std::size_t i = 0; i < result.size(); ++i)
        result.values()[i] = dry.values()[i] != 0 ? 0.0F : static_cast<float>(depth.values()[i]);
    return result;
}

Field<float> water_speed(const Snapshot& snapshot) {
    const Grid& u = values_of(snapshot, "velocity_x");
    const Grid& v = values_of(snapshot, "velocity_y");
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
    const Grid& depth = values_of(snapshot, "water_depth");
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
    constexpr double of_a_metre = 0.004;  // m
    constexpr double none = 1e-12;        // m
    if (!scale.in_metres) return none;
    return of_a_metre * std::sqrt(std::min(scale.dx, scale.dy));
}

WaterStatistics water_statistics(const Snapshot& snapshot) {
    if (!has_water(snapshot)) return {};
    const Grid& depth = values_of(snapshot, "water_depth");
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

DisplayWater display_water(const Snapshot& snapshot, int refinement) {
    const Mask dry = dry_cells(snapshot);
    const auto shown = [&](std::string_view name, bool into_dry) {
        const Grid& values = values_of(snapshot, name);
        Field<float> coarse(values.nx(), values.ny());
        for (std::size_t i = 0; i < coarse.size(); ++i)
            coarse.values()[i] =
                dry.values()[i] != 0 ? 0.0F : static_cast<float>(values.values()[i]);
        if (into_dry) continue_outward(coarse, dry, 0.0F);
        return refined(coarse, refinement);
    };
    DisplayWater water{
        shown("water_depth", false), shown("velocity_x", true), shown("velocity_y", true), {}};
    water.damp =
        refined(dampness(values_of(snapshot, "water_depth"), dry, closed_depth(snapshot.scale)),
                refinement);
    for (float& depth : water.depth.values()) depth = std::max(depth, 0.0F);
    for (float& damp : water.damp.values()) damp = std::clamp(damp, 0.0F, 1.0F);
    return water;
}

}  // namespace fumon
