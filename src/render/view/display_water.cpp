#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "base/compensated_sum.h"
#include "base/elementary.h"
#include "numerics/resampling.h"
#include "render/rain/drop_rings.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr double deepest_bank = 0.25;    // of a cell: banks this high over water are alike
constexpr double wetting_rain = 0.0005;  // m: what soil has in its crust while it darkens
constexpr double rained_on = 0.75;       // dampness of ground in lasting rain
constexpr double sheet_begins = 0.25;    // of closed_depth: as in shaders/bed/water.glsl

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

/// Cells that no sheet of water covers.
Mask open_cells(const Snapshot& snapshot, const Mask& dry) {
    const Grid& depth = water_field(snapshot, "water_depth");
    const double least = sheet_begins * closed_depth(snapshot.scale);
    Mask open = dry;
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (dry.values()[i] == 0 && depth.values()[i] < least) open.values()[i] = 1;
    }
    return open;
}

/// The rise of the water's surface to the neighbour `east` and `north` of each cell, by central
/// differences where both neighbours have one, by that to one where only it has; else 0.
Field<float> surface_slopes(const Snapshot& snapshot, const Mask& open, int east, int north,
                            double distance) {
    const Grid& depth = water_field(snapshot, "water_depth");
    const auto level = [&](int x, int y) {
        return snapshot.bed(x, y) * snapshot.scale.height_unit + depth(x, y);
    };
    const auto covered = [&](int x, int y) {
        return x >= 0 && x < open.nx() && y >= 0 && y < open.ny() && open(x, y) == 0;
    };
    Field<float> slopes(open.nx(), open.ny());
    for (int y = 0; y < open.ny(); ++y) {
        for (int x = 0; x < open.nx(); ++x) {
            if (open(x, y) != 0) continue;
            const bool before = covered(x - east, y - north);
            const bool after = covered(x + east, y + north);
            if (!before && !after) continue;
            const double low = before ? level(x - east, y - north) : level(x, y);
            const double high = after ? level(x + east, y + north) : level(x, y);
            slopes(x, y) =
                static_cast<float>((high - low) / (before && after ? 2.0 * distance : distance));
        }
    }
    return slopes;
}

/// Cells in which water does not lie level: its surface falls by more than its depth within them.
Mask sloping_cells(const Mask& open, const Grid& depth, const Field<float>& slope_x,
                   const Field<float>& slope_y, const WorldScale& scale) {
    Mask sloping = open;
    for (std::size_t i = 0; i < sloping.size(); ++i) {
        const double fall = std::max(std::abs(slope_x.values()[i]) * scale.dx,
                                     std::abs(slope_y.values()[i]) * scale.dy);
        if (fall > depth.values()[i]) sloping.values()[i] = 1;
    }
    return sloping;
}

/// Those cells, and the eight around each of them, of which a mask says 0.
Mask grown(const Mask& mask) {
    Mask result(mask.nx(), mask.ny());
    for (int y = 0; y < mask.ny(); ++y) {
        for (int x = 0; x < mask.nx(); ++x) {
            if (mask(x, y) != 0) continue;
            for (int north = std::max(y - 1, 0); north <= std::min(y + 1, mask.ny() - 1); ++north) {
                for (int east = std::max(x - 1, 0); east <= std::min(x + 1, mask.nx() - 1); ++east)
                    result(east, north) = 1;
            }
        }
    }
    return result;
}

/// What streams have, water that is at least `closes` deep, and of what lies beside them the mean
/// of the streams near by; elsewhere what the cell itself has.
Field<float> of_streams(const Field<float>& values, const Field<float>& ground,
                        const Field<float>& level, float closes, const Field<float>& elsewhere) {
    Mask none(ground.nx(), ground.ny());
    for (std::size_t i = 0; i < none.size(); ++i)
        none.values()[i] = level.values()[i] - ground.values()[i] < closes ? 1 : 0;
    constexpr float unreached = -1e30F;
    Field<float> found = values;
    extrapolate_outward(found, none, unreached);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found.values()[i] == unreached) found.values()[i] = elsewhere.values()[i];
    }
    return found;
}

/// 0 … 1: how much of a stream's film is left out where the ground stands so high over the stream,
/// which is so deep, in cells. Between the middles of cells, a film that followed the ground would
/// climb its banks, as a row of shards along a channel one cell wide. Between banks of 1 in 1,
/// whose foot is rounded by the interpolation, as much water as the cell has stands about 0.65 of
/// the root of its depth high.
float climbed(float climb, float depth) {
    constexpr float least = 0.1F;
    constexpr float fades = 0.06F;  // above and below
    const float stands = std::max(0.65F * std::sqrt(std::max(depth, 0.0F)), least);
    const float share = std::clamp((climb - stands + fades) / (2.0F * fades), 0.0F, 1.0F);
    return share * share * (3.0F - 2.0F * share);
}

/// Whether ground stands over a cell's level on both sides of it.
bool is_narrow(const Field<float>& ground, float level, int x, int y) {
    const auto beside = [&](int u, int v) {
        return u >= 0 && v >= 0 && u < ground.nx() && v < ground.ny() && ground(u, v) > level;
    };
    return (beside(x - 1, y) && beside(x + 1, y)) || (beside(x, y - 1) && beside(x, y + 1));
}

/// The depth on a display bed's cells. Water that lies level ends where its level meets the ground
/// between the cells, so that it does not climb its banks; on slopes it follows the ground, but
/// not up the banks of a stream. Banks have the depth to which the level lies below them, so that
/// between cells of both a shore is where the level meets the ground.
Field<float> shown_depths(const Snapshot& snapshot, const Mask& dry, const Mask& sloping,
                          int refinement) {
    const Grid& depth = water_field(snapshot, "water_depth");
    const double unit = snapshot.scale.height_unit;
    const auto known = [&](std::size_t i) {
        return snapshot.nodata.empty() || snapshot.nodata.values()[i] == 0;
    };
    double lowest = std::numeric_limits<double>::max();  // from which single precision counts
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (known(i)) lowest = std::min(lowest, snapshot.bed.values()[i] * unit);
    }
    constexpr float unreached = -1e30F;
    const auto least = static_cast<float>(sheet_begins * closed_depth(snapshot.scale));
    const auto closes = static_cast<float>(0.5 * closed_depth(snapshot.scale));
    Field<float> ground(depth.nx(), depth.ny());
    Field<float> film(depth.nx(), depth.ny());
    Field<float> level(depth.nx(), depth.ny());
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (known(i))
            ground.values()[i] = static_cast<float>(snapshot.bed.values()[i] * unit - lowest);
        const float water = dry.values()[i] != 0 ? 0.0F : static_cast<float>(depth.values()[i]);
        film.values()[i] = water;
        level.values()[i] = ground.values()[i] + water;
    }
    if (!snapshot.nodata.empty()) {
        extrapolate_outward(ground, snapshot.nodata, 0.0F);
        extrapolate_outward(level, snapshot.nodata, 0.0F);
    }
    for (int y = 0; y < film.ny(); ++y) {
        for (int x = 0; x < film.nx(); ++x) {
            if (sloping(x, y) == 0 && !is_narrow(ground, level(x, y), x, y))
                film(x, y) = std::min(film(x, y), least);
        }
    }
    Field<float> lake = level;
    extrapolate_outward(lake, sloping, unreached);
    for (std::size_t i = 0; i < lake.size(); ++i) {
        float& there = lake.values()[i];
        if (there == unreached || there > level.values()[i]) there = level.values()[i];
    }
    Field<float> shown = refined(lake, refinement);
    const Field<float> below = refined(ground, refinement);
    const Field<float> films = refined(film, refinement);
    const Field<float> depths = refined(of_streams(film, ground, level, closes, film), refinement);
    for (float& water : film.values()) water = std::min(water, closes);
    const Field<float> thin = refined(film, refinement);
    const Field<float> streams =
        refined(of_streams(level, ground, level, closes, ground), refinement);
    const auto dx = static_cast<float>(snapshot.scale.dx);
    const Mask near_lake = refined(grown(sloping), refinement);
    const auto highest = static_cast<float>(deepest_bank * snapshot.scale.dx);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const float climb = (below.values()[i] - streams.values()[i]) / dx;
        const float wets =
            std::max({films.values()[i] * (1.0F - climbed(climb, depths.values()[i] / dx)),
                      thin.values()[i], 0.0F});
        if (near_lake.values()[i] == 0) {
            shown.values()[i] = wets;
            continue;
        }
        const float lies = shown.values()[i] - below.values()[i];
        const bool is_bank = lies < 0.0F && wets < closes;
        shown.values()[i] = is_bank ? std::max(lies, -highest) : std::max(lies, wets);
    }
    return shown;
}

/// The rain of the last `seconds`, m: of every cell, or one value for all; 0 where nothing is known
/// of it, or lengths are in sites.
Grid rain_of_last(const Snapshot& snapshot, double seconds) {
    if (!snapshot.rain || !snapshot.scale.in_metres) return Grid(1, 1);
    return snapshot.rain(std::max(snapshot.time - seconds, 0.0), snapshot.time);
}

/// Ground is as wet as the rain of the last hour has made it, if nothing lies on it.
void wet_by_rain(const Snapshot& snapshot, int refinement, Field<float>& damp) {
    constexpr double hour = 3600.0;  // s
    const Grid fallen = rain_of_last(snapshot, hour);
    Field<float> wet(fallen.nx(), fallen.ny());
    for (std::size_t i = 0; i < wet.size(); ++i)
        wet.values()[i] = static_cast<float>(
            rained_on * (1.0 - elementary::exp(-fallen.values()[i] / wetting_rain)));
    if (wet.size() > 1) wet = refined(wet, refinement);
    for (std::size_t i = 0; i < damp.size(); ++i)
        damp.values()[i] = std::max(damp.values()[i], wet.values()[wet.size() > 1 ? i : 0]);
}

/// Rings of drops on the water, by the rain of the second before.
void add_rings(const Snapshot& snapshot, int refinement, DisplayWater& water) {
    constexpr double to_rate = 1000.0 * 3600.0;  // m in a second to mm/h
    const Grid fallen = rain_of_last(snapshot, 1.0);
    const double most = *std::ranges::max_element(fallen.values());
    if (!(most > 0.0)) return;
    water.rings = ring_tile_levels(snapshot.time, most * to_rate);
    if (fallen.size() == 1) return;
    Field<float> steep(fallen.nx(), fallen.ny());
    for (std::size_t i = 0; i < steep.size(); ++i)
        steep.values()[i] = static_cast<float>(std::sqrt(fallen.values()[i] / most));
    water.ringed = refined(steep, refinement);
}
}  // namespace

DisplayWater display_water(const Snapshot& snapshot, int refinement, WorkerPool& pool) {
    const Mask dry = dry_cells(snapshot);
    const Mask open = open_cells(snapshot, dry);
    const auto beyond_shores = [&](Field<float> coarse) {
        extrapolate_outward(coarse, dry, 0.0F);
        return refined(coarse, refinement);
    };
    const auto shown = [&](std::string_view name) {
        const Grid& values = water_field(snapshot, name);
        Field<float> coarse(values.nx(), values.ny());
        for (std::size_t i = 0; i < coarse.size(); ++i)
            coarse.values()[i] =
                dry.values()[i] != 0 ? 0.0F : static_cast<float>(values.values()[i]);
        return beyond_shores(std::move(coarse));
    };
    Field<float> slope_x = surface_slopes(snapshot, open, 1, 0, snapshot.scale.dx);
    Field<float> slope_y = surface_slopes(snapshot, open, 0, 1, snapshot.scale.dy);
    DisplayWater water;
    const auto show_depths_and_rings = [&] {
        const Mask sloping = sloping_cells(open, water_field(snapshot, "water_depth"), slope_x,
                                           slope_y, snapshot.scale);
        water.depth = shown_depths(snapshot, dry, sloping, refinement);
        add_rings(snapshot, refinement, water);
    };
    const auto show_the_rest = [&] {
        water.velocity_x = shown("velocity_x");
        water.velocity_y = shown("velocity_y");
        for (const auto& [coarse, fine] :
             {std::pair(&slope_x, &water.slope_x), std::pair(&slope_y, &water.slope_y)}) {
            Field<float> slopes = *coarse;
            extrapolate_outward(slopes, open, 0.0F);
            *fine = refined(averaged(averaged(slopes)), refinement);
        }
        const Grid& depth = water_field(snapshot, "water_depth");
        water.damp = refined(dampness(depth, dry, closed_depth(snapshot.scale)), refinement);
        for (float& damp : water.damp.values()) damp = std::clamp(damp, 0.0F, 1.0F);
        wet_by_rain(snapshot, refinement, water.damp);
        if (Field<float> silt = suspended_turbidities(snapshot); !silt.empty())
            water.silt = beyond_shores(std::move(silt));
    };
    pool.for_ranges(2, [&](int begin, int end) {  // about as long each
        if (begin == 0) show_depths_and_rings();
        if (end == 2) show_the_rest();
    });
    return water;
}

Field<float> worked_bed(const Snapshot& snapshot, const Snapshot& first, double whole,
                        int refinement) {
    const Grid& bed = snapshot.bed;
    Field<float> worked(bed.nx(), bed.ny());
    if (first.bed.nx() != bed.nx() || first.bed.ny() != bed.ny())
        return refined(worked, refinement);
    const auto known = [&](std::size_t i) {
        return snapshot.nodata.empty() || snapshot.nodata.values()[i] == 0;
    };
    const auto change = [&](std::size_t i) {
        return (bed.values()[i] - first.bed.values()[i]) * snapshot.scale.height_unit;
    };
    CompensatedSum sum;
    std::size_t count = 0;
    for (std::size_t i = 0; i < bed.size(); ++i) {
        if (!known(i)) continue;
        sum.add(change(i));
        ++count;
    }
    if (count == 0) return refined(worked, refinement);
    const double mean = sum.value() / static_cast<double>(count);
    for (std::size_t i = 0; i < bed.size(); ++i) {
        if (known(i))
            worked.values()[i] =
                static_cast<float>(std::clamp((change(i) - mean) / whole, -1.0, 1.0));
    }
    return refined(worked, refinement);
}
}  // namespace fumon
