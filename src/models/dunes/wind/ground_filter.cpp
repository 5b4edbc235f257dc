#include "models/dunes/wind/ground_filter.h"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "base/elementary.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

/// The next length whose transform is fast.
int fast_length(int least) {
    const auto is_fast = [](int length) {
        for (const int prime : {2, 3, 5}) {
            while (length % prime == 0) length /= prime;
        }
        return length == 1;
    };
    while (!is_fast(least)) ++least;
    return least;
}

DuneGround extended(DuneGround ground) {
    if (!ground.periodic_x) ground.nx = fast_length(ground.nx + (ground.nx + 1) / 2);
    if (!ground.periodic_y) ground.ny = fast_length(ground.ny + (ground.ny + 1) / 2);
    return ground;
}

/// The share of the edge ahead at a cell of the way from the one behind.
double share_ahead(int cell, int cells) {
    const double way = (cell + 1.0) / (cells + 1.0);
    return way * way * (3.0 - 2.0 * way);
}

}  // namespace

GroundFilter::GroundFilter(const DuneGround& ground, WorkerPool& pool)
    : nx_(ground.nx),
      ny_(ground.ny),
      ground_(extended(ground)),
      unit_x_(2.0 * std::numbers::pi / (ground_.nx * ground_.dx)),
      unit_y_(2.0 * std::numbers::pi / (ground_.ny * ground_.dy)),
      pool_(pool),
      extended_(ground_.nx > nx_ || ground_.ny > ny_ ? Grid(ground_.nx, ground_.ny) : Grid()),
      filter_(ground_.nx, ground_.ny, pool) {}

void GroundFilter::extend_past_edges(const Grid& plane) {
    const int beyond_x = ground_.nx - nx_;
    const int beyond_y = ground_.ny - ny_;
    pool_.for_ranges(ny_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            const auto from = plane.row(y);
            const auto to = extended_.row(y);
            std::ranges::copy(from, to.begin());
            for (int i = 0; i < beyond_x; ++i) {
                const double share = share_ahead(i, beyond_x);
                to[static_cast<std::size_t>(nx_) + static_cast<std::size_t>(i)] =
                    (1.0 - share) * from.back() + share * from.front();
            }
        }
    });
    pool_.for_ranges(beyond_y, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const double share = share_ahead(j, beyond_y);
            const auto south = extended_.row(0);
            const auto north = extended_.row(ny_ - 1);
            const auto to = extended_.row(ny_ + j);
            for (std::size_t x = 0; x < to.size(); ++x)
                to[x] = (1.0 - share) * north[x] + share * south[x];
        }
    });
}

void GroundFilter::filter(Grid& plane, const PlaneFilter::Response& response) {
    if (extended_.empty()) {
        filter_.apply(plane, response);
        return;
    }
    extend_past_edges(plane);
    filter_.apply(extended_, response);
    for (int y = 0; y < ny_; ++y) std::copy_n(extended_.row(y).begin(), nx_, plane.row(y).begin());
}

std::vector<double> gaussian_of_modes(int count, double scale) {
    std::vector<double> kept(static_cast<std::size_t>(count) / 2 + 1);
    for (std::size_t mode = 0; mode < kept.size(); ++mode) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(mode) / count;
        kept[mode] = elementary::exp(-(scale * scale) * (angle * angle) / 2.0);
    }
    return kept;
}

}  // namespace fumon
