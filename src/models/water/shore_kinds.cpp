// Which cells are full of water, which have only such ones around them, and which of those are
// outermost.

#include <algorithm>

#include "models/water/shore_planes.h"

namespace fumon {

namespace {

/// The cells of a row from the first to the last that are wet, by blocks.
std::array<int, 2> wet_part(const double* depth, int count) {
    constexpr int block = 16;
    const auto is_wet = [&](int from) {
        double most = 0.0;
        for (int k = from; k < std::min(from + block, count); ++k) most = std::max(most, depth[k]);
        return most > 0.0;
    };
    int begin = 0;
    while (begin < count && !is_wet(begin)) begin += block;
    if (begin >= count) return {0, 0};
    int end = (count + block - 1) / block * block;
    while (!is_wet(end - block)) end -= block;
    return {begin, std::min(end, count)};
}

}  // namespace

/// A cell of no data counts as full: water falls into it as over an open edge.
void ShorePlanes::find_full(int y) {
    const Grid& depth = water_->depth;
    std::uint8_t* flags = flags_of(full, y);
    const auto row_beside = [&](int to) {
        const CellReference& row = places_y_[static_cast<std::size_t>(to + pad)];
        return depth.row(row.outside ? y : row.y).data();
    };
    const double* here = depth.row(y).data();
    const double* south = row_beside(y - 1);
    const double* north = row_beside(y + 1);
    const auto look = [&](int x, double west, double east) {
        const double h = here[x];
        const double fall_x = std::max(std::max(west, east) - h, 0.0);
        const double fall_y = std::max(std::max(south[x], north[x]) - h, 0.0);
        flags[x] = h > std::max(0.5 * (fall_x + fall_y), dry_depth) ? 1 : 0;
    };
    const auto beside = [&](int x) {
        const CellReference& column = columns_[static_cast<std::size_t>(x + pad)];
        return column.outside ? 0.0 : here[column.x];
    };
    const auto [begin, end] = wet_[static_cast<std::size_t>(y)] = wet_part(here, nx_);
    std::fill_n(flags, nx_, std::uint8_t{0});
    for (int x = std::max(begin, 1); x < std::min(end, nx_ - 1); ++x)
        look(x, here[x - 1], here[x + 1]);
    if (begin == 0) look(0, beside(-1), beside(1));
    if (end == nx_ && nx_ > 1) look(nx_ - 1, beside(nx_ - 2), beside(nx_));
    if (domain_.nodata.empty()) return;
    for (int x = 0; x < nx_; ++x) {
        if (domain_.nodata(x, y) != 0) flags[x] = 1;
    }
}

/// Beyond an edge over which water falls all is taken to be of the kind.
void ShorePlanes::copy_ghost_flags(Kind kind) {
    const auto copy = [&](int x, int y) {
        const CellReference from = at(x, y);
        flags_of(kind, y)[x] = from.outside ? std::uint8_t{1} : flags_of(kind, from.y)[from.x];
    };
    for (int y = -1; y <= ny_; ++y) {
        copy(-1, y);
        copy(nx_, y);
    }
    for (int x = 0; x < nx_; ++x) {
        copy(x, -1);
        copy(x, ny_);
    }
}

void ShorePlanes::find_core(int y) {
    const std::uint8_t* here = flags_of(full, y);
    const std::uint8_t* south = flags_of(full, y - 1);
    const std::uint8_t* north = flags_of(full, y + 1);
    std::uint8_t* out = flags_of(core, y);
    std::fill_n(out, nx_, std::uint8_t{0});
    const auto [begin, end] = wet_[static_cast<std::size_t>(y)];
    for (int x = begin; x < end; ++x) {
        std::uint8_t all = 1;
        for (int to = x - 1; to <= x + 1; ++to) all &= here[to] & south[to] & north[to];
        out[x] = all;
    }
}

/// The cells of the core that have others beside them.
void ShorePlanes::find_inner(int y) {
    std::vector<Plane>& inner = rows_[slot(y)].inner;
    inner.clear();
    const std::uint8_t* here = flags_of(core, y);
    const std::uint8_t* south = flags_of(core, y - 1);
    const std::uint8_t* north = flags_of(core, y + 1);
    const auto [begin, end] = wet_[static_cast<std::size_t>(y)];
    for (int x = begin; x < end; ++x) {
        std::uint8_t all = 1;
        for (int to = x - 1; to <= x + 1; ++to) all &= here[to] & south[to] & north[to];
        if (here[x] != 0 && all == 0) inner.push_back(compute_inside(x, y));
    }
}

}  // namespace fumon
