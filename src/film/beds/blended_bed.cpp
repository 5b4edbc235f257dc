#include "film/beds/blended_bed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/find_named.h"

namespace fumon {

namespace {

/// Fields that say which cells something happened in.
constexpr std::array<std::string_view, 1> marks{"last_avalanche"};

double between(double from, double to, double share) {
    const double value = (1.0 - share) * from + share * to;
    if (std::isfinite(value)) return value;
    return share < 0.5 ? from : to;
}

void blend(Grid& values, const Grid& others, double share) {
    for (std::size_t i = 0; i < values.size(); ++i)
        values.values()[i] = between(values.values()[i], others.values()[i], share);
}

}  // namespace

Snapshot blended(const Snapshot& one, const Snapshot& other, double share) {
    Snapshot all = one;
    all.step += std::llround(share * static_cast<double>(other.step - one.step));
    all.time = between(one.time, other.time, share);
    blend(all.bed, other.bed, share);
    if (all.nodata.empty()) {
        all.nodata = other.nodata;
    } else if (!other.nodata.empty()) {
        for (std::size_t i = 0; i < all.nodata.size(); ++i)
            all.nodata.values()[i] =
                std::max<std::uint8_t>(all.nodata.values()[i], other.nodata.values()[i]);
    }
    const bool nearer_other = share >= 0.5;
    for (SnapshotField& field : all.fields) {
        const SnapshotField* to = find_named(other.fields, field.name);
        if (to == nullptr) continue;
        if (std::ranges::find(marks, field.name) == marks.end()) {
            blend(field.values, to->values, share);
        } else if (nearer_other) {
            field.values = to->values;
        }
    }
    for (SnapshotNumber& number : all.numbers) {
        const SnapshotNumber* to = find_named(other.numbers, number.name);
        if (to == nullptr) continue;
        // The mean of two winds is none that blew.
        const bool is_direction = number.unit == "degrees";
        if (!is_direction) {
            number.value = between(number.value, to->value, share);
        } else if (nearer_other) {
            number.value = to->value;
        }
    }
    if (nearer_other) all.section = other.section;
    return all;
}

}  // namespace fumon
