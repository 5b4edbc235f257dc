#include "base/snapshots/ground_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/limits.h"

namespace fumon {

namespace {

std::string number_text(double value) {
    return std::isnan(value) ? "nan" : fmt::format("{:.12g}", value);
}

/// "water_depth of cell (3, 0) is nan"
std::string cell_text(std::string_view what, const Grid& field, std::size_t cell, double factor) {
    const auto nx = static_cast<std::size_t>(field.nx());
    return fmt::format("{} of cell ({}, {}) is {}", what, cell % nx, cell / nx,
                       number_text(factor * field.values()[cell]));
}

bool within(double value, double low, double high) {
    return value >= low && value <= high;
}

std::string beyond_scale(const WorldScale& scale) {
    for (const double size : {scale.dx, scale.dy}) {
        if (within(size, smallest_cell_size, largest_cell_size)) continue;
        return fmt::format("cells are {} {} wide; a cell has {:g} to {:g}", number_text(size),
                           scale.in_metres ? "m" : "sites", smallest_cell_size, largest_cell_size);
    }
    if (within(scale.height_unit, smallest_height_unit, largest_height_unit)) return {};
    return fmt::format("a model height is {} m; it has {:g} to {:g} m",
                       number_text(scale.height_unit), smallest_height_unit, largest_height_unit);
}

/// Fields that are drawn as water, sand, rock and plants. Others colour the ground, and may have
/// cells without a value (NaN).
constexpr std::array<std::string_view, 11> whole_fields{
    "water_depth", "velocity_x",  "velocity_y",     "sand",  "rock",  "cover",
    "moving_sand", "wind_shadow", "last_avalanche", "grass", "shrubs"};

/// In cells without data a field may hold anything.
std::string beyond_field(const SnapshotField& field, const Mask& nodata) {
    std::size_t cell = first_beyond(field.values, largest_field_value);
    const bool masked = nodata.size() == field.values.size();
    const bool whole = !may_have_gaps(field.name);
    const auto may_be = [&](std::size_t at) {
        const double value = field.values.values()[at];
        return (masked && nodata.values()[at] != 0) || std::abs(value) <= largest_field_value ||
               (!whole && std::isnan(value));
    };
    while ((masked || !whole) && cell < field.values.size() && may_be(cell)) ++cell;
    if (cell == field.values.size()) return {};
    return cell_text(field.name, field.values, cell, 1.0) +
           fmt::format("; it has values up to ±{:g}", largest_field_value);
}

}  // namespace

bool may_have_gaps(std::string_view field) {
    return std::ranges::find(whole_fields, field) == whole_fields.end();
}

std::size_t first_beyond(const Grid& field, double most) {
    // Whether there is one is asked of whole blocks, in a loop without a branch.
    constexpr std::size_t block = 4096;
    const std::span<const double> values = field.values();
    for (std::size_t begin = 0; begin < values.size(); begin += block) {
        const auto part = values.subspan(begin, std::min(block, values.size() - begin));
        std::int64_t beyond = 0;
        for (const double value : part) beyond += std::abs(value) <= most ? 0 : 1;
        if (beyond == 0) continue;
        std::size_t cell = 0;
        while (std::abs(part[cell]) <= most) ++cell;
        return begin + cell;
    }
    return values.size();
}

std::string beyond_ground(const Grid& bed, const WorldScale& scale) {
    if (std::string fault = beyond_scale(scale); !fault.empty()) return fault;
    const double most = largest_height / scale.height_unit;
    const std::size_t cell = first_beyond(bed, most);
    if (cell == bed.size()) return {};
    const char* unit = scale.in_metres ? " m" : "";
    return cell_text("the height", bed, cell, scale.height_unit) +
           fmt::format("{}; heights go to ±{:g}{}", unit, largest_height, unit);
}

std::string beyond_ground(const Snapshot& snapshot) {
    if (std::string fault = beyond_ground(snapshot.bed, snapshot.scale); !fault.empty())
        return fault;
    if (!within(snapshot.time, -largest_time, largest_time)) {
        return fmt::format("the time is {} {}; it goes to {:g}", number_text(snapshot.time),
                           snapshot.time_unit, largest_time);
    }
    for (const SnapshotField& field : snapshot.fields) {
        if (std::string fault = beyond_field(field, snapshot.nodata); !fault.empty()) return fault;
    }
    if (!snapshot.section) return {};
    const SnapshotSection& section = *snapshot.section;
    for (const double size : {section.dx, section.dz}) {
        if (within(size, smallest_cell_size, largest_cell_size)) continue;
        return fmt::format("the section's nodes are {} m apart; they are {:g} to {:g}",
                           number_text(size), smallest_cell_size, largest_cell_size);
    }
    for (const SnapshotField& field : section.fields) {
        if (std::string fault = beyond_field(field, {}); !fault.empty()) return fault;
    }
    return {};
}

}  // namespace fumon
