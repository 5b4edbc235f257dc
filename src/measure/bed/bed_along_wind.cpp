#include "measure/bed/bed_along_wind.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/truncation.h"

namespace fumon {

namespace {

/// The weights of the cells at −1, 0, 1, 2 for a place `beyond` the second of them (0 … 1).
std::array<double, 4> convolution(double beyond) {
    const double t = beyond;
    return {0.5 * t * (t * (2.0 - t) - 1.0), 0.5 * (t * t * (3.0 * t - 5.0) + 2.0),
            0.5 * t * (t * (4.0 - 3.0 * t) + 1.0), 0.5 * t * t * (t - 1.0)};
}

int cell_of(double cell, int count, bool periodic) {
    if (!periodic) return truncated_within(cell, 0, count - 1);
    return truncated_within(cell - count * std::floor(cell / count), 0, count - 1);
}

/// Turned by quarters: the cell (x, y) of the result is the cell origin + x·way + y·left.
BedAlongWind turned_by_quarters(const Snapshot& snapshot, const HorizontalDirection& direction) {
    const Grid& bed = snapshot.bed;
    const bool across = direction.x == 0.0;
    BedAlongWind turned{across ? Grid(bed.ny(), bed.nx()) : Grid(bed.nx(), bed.ny()),
                        snapshot.periodic};
    const auto from = [](double direction, int cell, int count) {
        return direction > 0.0 ? cell : count - 1 - cell;
    };
    for (int y = 0; y < turned.bed.ny(); ++y) {
        for (int x = 0; x < turned.bed.nx(); ++x) {
            turned.bed(x, y) =
                across ? bed(from(-direction.y, y, bed.nx()), from(direction.y, x, bed.ny()))
                       : bed(from(direction.x, x, bed.nx()), from(direction.x, y, bed.ny()));
        }
    }
    return turned;
}

}  // namespace

double height_between(const Grid& bed, bool periodic, double x, double y) {
    const double west = std::floor(x);
    const double south = std::floor(y);
    const std::array<double, 4> along = convolution(x - west);
    const std::array<double, 4> across = convolution(y - south);
    std::array<int, 4> columns{};
    for (int i = 0; i < 4; ++i)
        columns[static_cast<std::size_t>(i)] = cell_of(west + i - 1, bed.nx(), periodic);
    double height = 0.0;
    for (int j = 0; j < 4; ++j) {
        const auto row = bed.row(cell_of(south + j - 1, bed.ny(), periodic));
        double of_row = 0.0;
        for (std::size_t i = 0; i < 4; ++i)
            of_row += along[i] * row[static_cast<std::size_t>(columns[i])];
        height += across[static_cast<std::size_t>(j)] * of_row;
    }
    return height;
}

BedAlongWind bed_along_wind(const Snapshot& snapshot, const HorizontalDirection& direction) {
    if (direction.is_east()) return {snapshot.bed, snapshot.periodic};
    const Grid& bed = snapshot.bed;
    const double cell_aspect = snapshot.scale.dy / snapshot.scale.dx;
    const bool on_axis = direction.x == 0.0 || direction.y == 0.0;
    if (on_axis && (cell_aspect == 1.0 || direction.y == 0.0))
        return turned_by_quarters(snapshot, direction);
    const double wide = bed.nx();
    const double high = bed.ny() * cell_aspect;
    double share = 1.0;
    if (!snapshot.periodic) {
        const double c = std::abs(direction.x);
        const double s = std::abs(direction.y);
        share = std::min(wide / (wide * c + high * s), high / (wide * s + high * c));
    }
    const int nx = std::max(1, static_cast<int>(share * wide));
    const int ny = std::max(1, static_cast<int>(share * high));
    BedAlongWind turned{Grid(nx, ny), false};
    for (int y = 0; y < ny; ++y) {
        const double across = y - 0.5 * (ny - 1);
        for (int x = 0; x < nx; ++x) {
            const double along = x - 0.5 * (nx - 1);
            const double east = along * direction.x - across * direction.y;
            const double north = along * direction.y + across * direction.x;
            turned.bed(x, y) = height_between(bed, snapshot.periodic, 0.5 * (bed.nx() - 1) + east,
                                              0.5 * (bed.ny() - 1) + north / cell_aspect);
        }
    }
    return turned;
}

}  // namespace fumon
