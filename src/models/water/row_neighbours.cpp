#include "models/water/row_neighbours.h"

#include <algorithm>

namespace fumon {

namespace {

double beyond(GhostValue rule, double here, double other_side) {
    switch (rule) {
        case GhostValue::extrapolated:
            return 2.0 * here - other_side;
        case GhostValue::same:
            return here;
        case GhostValue::opposite:
            return -here;
    }
    return here;
}

}  // namespace

sediment::Sides RowNeighbours::of(const Grid& field, const WaterDomain& domain, int y,
                                  GhostValue beyond_x, GhostValue beyond_y,
                                  GhostValue beyond_hole) {
    const int nx = field.nx();
    const int ny = field.ny();
    const auto row = field.row(y);
    std::copy(row.begin(), row.end(), cells_.begin() + 1);
    if (domain.edges_x == EdgeKind::periodic) {
        cells_.front() = row.back();
        cells_.back() = row.front();
    } else {
        cells_.front() = beyond(beyond_x, row.front(), nx > 1 ? row[1] : row.front());
        cells_.back() = beyond(beyond_x, row.back(),
                               nx > 1 ? row[static_cast<std::size_t>(nx) - 2] : row.back());
    }
    sediment::Sides sides{cells_.data(), cells_.data() + 2, nullptr, nullptr};
    if (domain.edges_y == EdgeKind::periodic) {
        sides.south = field.row((y + ny - 1) % ny).data();
        sides.north = field.row((y + 1) % ny).data();
    } else {
        sides.south = ghost_row(field, y, -1, beyond_y, south_);
        sides.north = ghost_row(field, y, 1, beyond_y, north_);
    }
    if (domain.nodata.empty()) return sides;
    fill_holes(field, domain, y, beyond_hole, sides);
    return {west_.data(), east_.data(), south_.data(), north_.data()};
}

const double* RowNeighbours::ghost_row(const Grid& field, int y, int by, GhostValue rule,
                                       std::vector<double>& scratch) {
    const int ny = field.ny();
    if (y + by >= 0 && y + by < ny) return field.row(y + by).data();
    const auto here = field.row(y);
    const auto other = field.row(std::clamp(y - by, 0, ny - 1));
    for (std::size_t x = 0; x < here.size(); ++x) scratch[x] = beyond(rule, here[x], other[x]);
    return scratch.data();
}

void RowNeighbours::fill_holes(const Grid& field, const WaterDomain& domain, int y, GhostValue rule,
                               const sediment::Sides& plain) {
    const int nx = field.nx();
    const int ny = field.ny();
    const auto hole = [&](int x, int row) {
        if (domain.edges_x == EdgeKind::periodic) x = (x + nx) % nx;
        if (domain.edges_y == EdgeKind::periodic) row = (row + ny) % ny;
        return x >= 0 && x < nx && row >= 0 && row < ny && domain.nodata(x, row) != 0;
    };
    const auto pair = [&](bool low_hole, bool high_hole, double low, double here, double high,
                          double& low_out, double& high_out) {
        low_out = low_hole ? beyond(rule, here, high_hole ? here : high) : low;
        high_out = high_hole ? beyond(rule, here, low_hole ? here : low) : high;
    };
    for (int x = 0; x < nx; ++x) {
        const auto at = static_cast<std::size_t>(x);
        const double here = field(x, y);
        pair(hole(x - 1, y), hole(x + 1, y), plain.west[x], here, plain.east[x], west_[at],
             east_[at]);
        pair(hole(x, y - 1), hole(x, y + 1), plain.south[x], here, plain.north[x], south_[at],
             north_[at]);
    }
}

}  // namespace fumon
