#include "render/air/section_air.h"

#include <algorithm>
#include <cmath>

#include "base/find_named.h"
#include "base/truncation.h"

namespace fumon {

namespace {

constexpr double at_the_bed = 1e-6;  // of dz: nodes no higher above the bed lie on it

}  // namespace

SectionAir::SectionAir(const Snapshot& snapshot)
    : snapshot_(snapshot), section_(*snapshot.section) {}

double SectionAir::length() const {
    return snapshot_.bed.nx() * section_.dx;
}

double SectionAir::height() const {
    return section_.fields.empty() ? 0.0 : (section_.fields.front().values.ny() - 1) * section_.dz;
}

template <class Node>
double SectionAir::between(double x, double z, Node node) const {
    const int nx = snapshot_.bed.nx();
    const double column = x / section_.dx - nx * std::floor(x / (nx * section_.dx));
    const double west_column = std::floor(column);
    // Rounding may leave a place just west of the section's start.
    const auto west = static_cast<int>((truncated(west_column) % nx + nx) % nx);
    const double east_share = column - west_column;
    return (1.0 - east_share) * node(west, z / section_.dz) +
           east_share * node((west + 1) % nx, z / section_.dz);
}

double SectionAir::bed(double x) const {
    return between(x, 0.0, [&](int column, double) {
        return snapshot_.bed(column, 0) * snapshot_.scale.height_unit;
    });
}

const SnapshotField* SectionAir::find(std::string_view name) const {
    return find_named(section_.fields, name);
}

double SectionAir::value(const SnapshotField& field, double x, double z) const {
    return between(x, z, [&](int column, double row) {
        const double inside = std::clamp(row, 0.0, field.values.ny() - 1.0);
        const int below = truncated_within(inside, 0, field.values.ny() - 1);
        const int above = std::min(below + 1, field.values.ny() - 1);
        return std::lerp(field.values(column, below), field.values(column, above), inside - below);
    });
}

double SectionAir::value_of_air(const SnapshotField& field, double x, double z) const {
    return between(x, z, [&](int column, double row) {
        const double top = field.values.ny() - 1.0;
        const double lowest = std::min<double>(lowest_in_air(column), top);
        const double inside = std::clamp(row, lowest, top);
        const int below = truncated_within(inside, 0, field.values.ny() - 1);
        const int above = std::min(below + 1, field.values.ny() - 1);
        return std::lerp(field.values(column, below), field.values(column, above), inside - below);
    });
}

int SectionAir::lowest_in_air(int column) const {
    const double bed = snapshot_.bed(column, 0) * snapshot_.scale.height_unit;
    constexpr int most = 1 << 30;
    return truncated_within(std::floor(bed / section_.dz + at_the_bed), -1, most) + 1;
}

}  // namespace fumon
