#include "render/colour/colouring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "base/random.h"
#include "base/rounding.h"
#include "measure/network/flow_routing.h"
#include "numerics/percentile.h"
#include "render/view/water.h"

namespace fumon {

namespace {

/// The arc tangent of x ≥ 0 in degrees, within 1e-3.
double degrees_of_slope(double x) {
    const double arc = elementary::rough_atan(std::min(x, 1.0) / std::max(x, 1.0));
    return (x > 1.0 ? 0.5 * std::numbers::pi - arc : arc) * 180.0 / std::numbers::pi;
}

Field<float> slopes(const Snapshot& snapshot) {
    const Grid& bed = snapshot.bed;
    const auto known = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < bed.nx() && y < bed.ny() &&
               (snapshot.nodata.empty() || snapshot.nodata(x, y) == 0);
    };
    // Central differences; one-sided next to the border and to cells without data.
    const auto derivative = [&](int x, int y, int step_x, int step_y, double spacing) {
        const bool ahead = known(x + step_x, y + step_y);
        const bool behind = known(x - step_x, y - step_y);
        const double high = ahead ? bed(x + step_x, y + step_y) : bed(x, y);
        const double low = behind ? bed(x - step_x, y - step_y) : bed(x, y);
        const int cells = (ahead ? 1 : 0) + (behind ? 1 : 0);
        return cells == 0 ? 0.0 : (high - low) / (cells * spacing);
    };
    Field<float> result(bed.nx(), bed.ny());
    for (int y = 0; y < bed.ny(); ++y) {
        for (int x = 0; x < bed.nx(); ++x) {
            const double p = derivative(x, y, 1, 0, snapshot.scale.dx);
            const double q = derivative(x, y, 0, 1, snapshot.scale.dy);
            result(x, y) = static_cast<float>(
                degrees_of_slope(snapshot.scale.height_unit * std::sqrt(p * p + q * q)));
        }
    }
    return result;
}

/// Decimal logarithms of the areas that drain through the cells; of cells without data, of one
/// cell.
Field<float> drained_areas(const Snapshot& snapshot) {
    constexpr double ln10 = 2.302585092994046;
    const double cell = snapshot.scale.dx * snapshot.scale.dy;
    const Grid area = drainage_area(route_flow(snapshot));
    Field<float> result(area.nx(), area.ny());
    std::ranges::transform(area.values(), result.values().begin(), [&](double value) {
        return static_cast<float>(elementary::log(std::max(value, cell)) / ln10);
    });
    return result;
}

}  // namespace

bool colours_water(Colouring colour_by) {
    return colour_by == Colouring::water_depth || colour_by == Colouring::speed ||
           colour_by == Colouring::froude;
}

bool colours_field(Colouring colour_by) {
    return colour_by == Colouring::field || colour_by == Colouring::field_change;
}

bool leaves_cells_uncoloured(Colouring colour_by) {
    return colours_water(colour_by) || colours_field(colour_by);
}

const SnapshotField& coloured_field(const LookSettings& look, const Snapshot& snapshot) {
    if (const SnapshotField* field = find_named(snapshot.fields, look.field)) return *field;
    std::vector<std::string> known;
    for (const SnapshotField& field : snapshot.fields) known.push_back(field.name);
    throw InputError(
        fmt::format("look.field = \"{}\": the run has no field of this name; {}", look.field,
                    known.empty() ? std::string("it has none") : suggestion(look.field, known)));
}

Mask uncoloured_cells(const LookSettings& look, const Snapshot& snapshot, const Snapshot& first) {
    if (colours_water(look.colour_by)) return dry_cells(snapshot);
    if (!colours_field(look.colour_by)) return snapshot.nodata;
    Mask without = snapshot.nodata;
    const auto add_gaps = [&](const Grid& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::isfinite(values.values()[i])) continue;
            if (without.empty()) without = Mask(values.nx(), values.ny());
            without.values()[i] = 1;
        }
    };
    add_gaps(coloured_field(look, snapshot).values);
    if (look.colour_by == Colouring::field_change) add_gaps(coloured_field(look, first).values);
    return without;
}

Mask uncoloured_cells(const LookSettings& look, const Snapshot& snapshot) {
    return uncoloured_cells(look, snapshot, snapshot);
}

namespace {

Field<float> field_values(const LookSettings& look, const Snapshot& snapshot,
                          const Snapshot& first) {
    const Grid& values = coloured_field(look, snapshot).values;
    const bool change = look.colour_by == Colouring::field_change;
    const Grid* reference = change ? &coloured_field(look, first).values : nullptr;
    Field<float> result(values.nx(), values.ny());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double value =
            values.values()[i] - (reference != nullptr ? reference->values()[i] : 0.0);
        result.values()[i] = std::isfinite(value) ? static_cast<float>(value)
                                                  : std::numeric_limits<float>::quiet_NaN();
    }
    return result;
}

}  // namespace

Field<float> coloured_values(const LookSettings& look, const Snapshot& snapshot,
                             const Snapshot& first) {
    const Colouring colour_by = look.colour_by;
    if (colours_field(colour_by)) return field_values(look, snapshot, first);
    if (colour_by == Colouring::slope) return slopes(snapshot);
    if (colour_by == Colouring::speed) return water_speed(snapshot);
    if (colour_by == Colouring::froude) return froude_numbers(snapshot);
    if (colour_by == Colouring::water_depth) return water_depths(snapshot);
    if (colour_by == Colouring::drainage) return drained_areas(snapshot);
    Field<float> result(snapshot.bed.nx(), snapshot.bed.ny());
    const bool change = colour_by == Colouring::change;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double reference = change ? first.bed.values()[i] : 0.0;
        result.values()[i] = static_cast<float>(snapshot.bed.values()[i] - reference);
    }
    return result;
}

bool ranges_by_values(const LookSettings& look) {
    return look.colour_by != Colouring::natural && (look.low.is_word() || look.high.is_word());
}

namespace {

/// The values of the cells that are coloured.
std::vector<float> known_values(const LookSettings& look, const Snapshot& snapshot,
                                const Field<float>& values) {
    std::vector<float> known;
    known.reserve(values.size());
    const bool by_field = colours_field(look.colour_by);  // whose gaps are NaN among the values
    const Mask without = by_field ? snapshot.nodata : uncoloured_cells(look, snapshot);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!without.empty() && without.values()[i] != 0) continue;
        if (!std::isnan(values.values()[i])) known.push_back(values.values()[i]);
    }
    return known;
}

/// The ends of the range, in no order where the values do not differ.
std::pair<double, double> ends_of_known(const LookSettings& look, std::vector<float> known,
                                        const RangeTails& tails) {
    double low = percentile(known, tails.low);
    double high = percentile(known, 1.0 - tails.high);
    if (look.colour_by == Colouring::slope) low = 0.0;
    if (look.colour_by == Colouring::change || look.colour_by == Colouring::field_change) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    if (!look.low.is_word()) low = look.low.value;
    if (!look.high.is_word()) high = look.high.value;
    return {low, high};
}

std::pair<double, double> ends_of_values(const LookSettings& look, const Snapshot& snapshot,
                                         const Field<float>& values, const RangeTails& tails) {
    return ends_of_known(look, known_values(look, snapshot, values), tails);
}

/// Of a flat bed, any range that holds its one value in the middle.
std::pair<double, double> widened(std::pair<double, double> ends) {
    if (ends.second > ends.first) return ends;
    const double middle = 0.5 * (ends.first + ends.second);
    return {middle - 0.5, middle + 0.5};
}

}  // namespace

std::pair<double, double> colour_range(const LookSettings& look, const Snapshot& snapshot,
                                       const Field<float>& values, const RangeTails& tails) {
    if (!look.low.is_word() && !look.high.is_word()) return {look.low.value, look.high.value};
    return widened(ends_of_values(look, snapshot, values, tails));
}

std::pair<double, double> joined_colour_range(const LookSettings& look,
                                              std::span<const Snapshot> snapshots,
                                              std::span<const Field<float>> values,
                                              const RangeTails& tails) {
    if (!look.low.is_word() && !look.high.is_word()) return {look.low.value, look.high.value};
    std::optional<std::pair<double, double>> joined;
    for (std::size_t k = 0; k < snapshots.size(); ++k) {
        std::vector<float> known = known_values(look, snapshots[k], values[k]);
        if (known.empty()) continue;
        const auto [low, high] = ends_of_known(look, std::move(known), tails);
        joined = joined ? std::pair{std::min(joined->first, low), std::max(joined->second, high)}
                        : std::pair{low, high};
    }
    return joined ? widened(*joined) : colour_range(look, snapshots.front(), values.front(), tails);
}

FrameColourRange frame_colour_range(const LookSettings& look, const Snapshot& snapshot,
                                    const Field<float>& values, const FrameColourRange& previous,
                                    bool keeps) {
    FrameColourRange drawn = previous;
    if (!previous.kept) {
        const auto [low, high] = colour_range(look, snapshot, values);
        drawn = {low, high};
    }
    if (look.colour_by == Colouring::natural || look.range == ColourSpan::frame) return drawn;
    LookSettings alone = look;
    alone.low = {"auto", 0.0};
    alone.high = {"auto", 0.0};
    const auto [low, high] = ends_of_values(alone, snapshot, values, {});
    const bool differ = high > low;
    drawn.values_below = differ && low < drawn.low;
    drawn.values_above = differ && high > drawn.high;
    drawn.kept = previous.kept || (keeps && differ && ranges_by_values(look));
    return drawn;
}

Palette chosen_palette(const LookSettings& look) {
    Palette palette = read_palette(look.palette);
    if (look.palette_reversed) std::reverse(palette.begin(), palette.end());
    return palette;
}

Field<std::uint16_t> palette_coordinates(const Field<float>& values,
                                         std::pair<double, double> range) {
    Field<std::uint16_t> positions(values.nx(), values.ny());
    const auto low = static_cast<float>(range.first);
    const float scale = 65535.0F / static_cast<float>(range.second - range.first);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float position = (values.values()[i] - low) * scale;
        positions.values()[i] =
            static_cast<std::uint16_t>(nearest(std::min(std::max(position, 0.0F), 65535.0F)));
    }
    return positions;
}

namespace {

/// The mean of each cell and its neighbours along both axes, with weights 1 : 2 : 1, so that
/// outlines do not show the cells.
Grid softened(const Grid& field, bool periodic) {
    const auto position = [&](int cell, int count) {
        if (cell >= 0 && cell < count) return cell;
        return periodic ? (cell + count) % count : std::clamp(cell, 0, count - 1);
    };
    Grid along(field.nx(), field.ny());
    for (int y = 0; y < field.ny(); ++y) {
        for (int x = 0; x < field.nx(); ++x) {
            along(x, y) = 0.5 * field(x, y) + 0.25 * (field(position(x - 1, field.nx()), y) +
                                                      field(position(x + 1, field.nx()), y));
        }
    }
    Grid both(field.nx(), field.ny());
    for (int y = 0; y < field.ny(); ++y) {
        for (int x = 0; x < field.nx(); ++x) {
            both(x, y) = 0.5 * along(x, y) + 0.25 * (along(x, position(y - 1, field.ny())) +
                                                     along(x, position(y + 1, field.ny())));
        }
    }
    return both;
}

/// By what part plants stand less dense in a cell than its cover says, since they grow in tufts and
/// patches: 0 … 0.6, the same at any time.
Grid tufts(int nx, int ny, bool periodic) {
    constexpr double in_patches = 2.5;
    constexpr double least_dense = 0.6;
    Grid noise(nx, ny);
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const auto bits = philox4x32(
                {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0}, {0, 0});
            noise(x, y) = static_cast<double>(bits[0]) / 4294967295.0;
        }
    }
    Grid patches = softened(noise, periodic);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const double patch = 0.5 + in_patches * (patches.values()[i] - 0.5);
        patches.values()[i] = least_dense * std::clamp(patch, 0.0, 1.0);
    }
    return patches;
}

/// Plants as parts above 0, rock as parts below.
Field<std::uint8_t> ground_texels(const Snapshot& snapshot) {
    constexpr double hidden = 0.03;  // m of sand, under which no rock is seen
    constexpr double bare_sand = 128.0;
    const SnapshotField* sand = find_named(snapshot.fields, "sand");
    const SnapshotField* cover = find_named(snapshot.fields, "cover");
    Grid ground(snapshot.bed.nx(), snapshot.bed.ny());
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double thickness = sand != nullptr ? sand->values.values()[i] : hidden;
        const double plants = cover != nullptr ? cover->values.values()[i] : 0.0;
        const double rock = (1.0 - plants) * std::clamp(1.0 - thickness / hidden, 0.0, 1.0);
        ground.values()[i] = bare_sand + 127.0 * plants - 128.0 * rock;
    }
    // Twice, so that the edge of rock does not show the cells.
    ground = softened(softened(ground, snapshot.periodic), snapshot.periodic);
    const Grid sparse = tufts(ground.nx(), ground.ny(), snapshot.periodic);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double plants = ground.values()[i] - bare_sand;
        if (plants > 0.0) ground.values()[i] = bare_sand + plants * (1.0 - sparse.values()[i]);
    }
    Field<std::uint8_t> texels(ground.nx(), ground.ny());
    std::ranges::transform(ground.values(), texels.values().begin(), [](double value) {
        return static_cast<std::uint8_t>(nearest(static_cast<float>(value)));
    });
    return texels;
}

}  // namespace

float mark_number(Marking mark) {
    switch (mark) {
        case Marking::none:
            return 0.0F;
        case Marking::last_avalanche:
            return 1.0F;
        case Marking::ground:
            return 2.0F;
    }
    return 0.0F;
}

const SnapshotField* marked_field(Marking mark, const Snapshot& snapshot) {
    if (mark == Marking::none) return nullptr;
    return find_named(snapshot.fields, mark == Marking::ground ? "sand" : "last_avalanche");
}

Field<std::uint8_t> mark_texels(Marking mark, const Snapshot& snapshot) {
    if (mark == Marking::none) return {1, 1, 0};
    if (mark == Marking::ground) return ground_texels(snapshot);
    Field<std::uint8_t> texels(snapshot.bed.nx(), snapshot.bed.ny());
    const SnapshotField* field = marked_field(mark, snapshot);
    if (field == nullptr) return texels;
    constexpr std::uint8_t received = 120;
    constexpr std::uint8_t toppled = 235;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const double value = field->values.values()[i];
        if (value > 0.0) texels.values()[i] = value > 1.0 ? toppled : received;
    }
    return texels;
}

}  // namespace fumon
