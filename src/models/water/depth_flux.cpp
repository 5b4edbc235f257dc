#include "models/water/depth_flux.h"

#include <algorithm>

#include "base/give_up.h"
#include "base/multiversion.h"

namespace fumon {

namespace {

/// Depth that passes faces between a cell and the next one, of depths d0, d1 | d2, d3 in order.
FUMON_MULTIVERSION
void through_faces(const double* before, const double* here, const double* next,
                   const double* after_next, const double* speed_here, const double* speed_next,
                   double per_cell, int count, double* faces) {
    for (int x = 0; x < count; ++x) {
        const double shift = 0.5 * per_cell * (speed_here[x] + speed_next[x]);  // in cells
        const bool onward = shift > 0.0;
        const double upwind = onward ? here[x] : next[x];
        const double rise = next[x] - here[x];  // all rises along the axis
        const double rise_here = here[x] - before[x];
        const double rise_next = after_next[x] - next[x];
        const double behind = onward ? rise_here : rise_next;
        const double twice = behind * behind < rise * rise ? 2.0 * behind : 2.0 * rise;
        const double middle = 0.5 * (behind + rise);
        const double steep = twice * twice < middle * middle ? twice : middle;
        const double limited = behind * rise > 0.0 ? steep : 0.0;
        const double reach = onward ? 1.0 - shift : -1.0 - shift;
        faces[x] = shift * (upwind + 0.5 * reach * limited);
    }
}

/// Depths after the faces have passed theirs; whether a cell gave more than it had.
FUMON_MULTIVERSION
bool settle(const double* before, const double* east_faces, const double* south_faces,
            const double* north_faces, double rain, int count, double* after) {
    double lowest[8] = {};
    const auto one = [&](int x) {
        return (before[x] + rain) +
               ((east_faces[x - 1] - east_faces[x]) + (south_faces[x] - north_faces[x]));
    };
    int x = 0;
    for (; x + 8 <= count; x += 8) {
        for (int k = 0; k < 8; ++k) {
            after[x + k] = one(x + k);
            lowest[k] = after[x + k] < lowest[k] ? after[x + k] : lowest[k];
        }
    }
    for (; x < count; ++x) {
        after[x] = one(x);
        lowest[0] = after[x] < lowest[0] ? after[x] : lowest[0];
    }
    return *std::min_element(lowest, lowest + 8) < 0.0;
}

}  // namespace

DepthFlux::DepthFlux(int nx, int ny, double dx, double dy)
    : nx_(nx), ny_(ny), dx_(dx), dy_(dy), overdrawn_(static_cast<std::size_t>(ny)) {}

void DepthFlux::begin(double dt, double rain) {
    dt_ = dt;
    fallen_ = rain * dt;
}

/// faces[1 + x] lies between cells x and x + 1, x = −1 … nx − 1.
void DepthFlux::moved_east(const PaddedGrid& before, const PaddedGrid& u, int y,
                           double* faces) const {
    const double* h = before.row(y) - 1;
    const double* speed = u.row(y) - 1;
    through_faces(h - 1, h, h + 1, h + 2, speed, speed + 1, dt_ / dx_, nx_ + 1, faces);
}

/// faces[x] lies between cells (x, y) and (x, y + 1).
void DepthFlux::moved_north(const PaddedGrid& before, const PaddedGrid& v, int y,
                            double* faces) const {
    const auto row = [this](int any) { return ((any % ny_) + ny_) % ny_; };
    through_faces(before.row(row(y - 1)), before.row(row(y)), before.row(row(y + 1)),
                  before.row(row(y + 2)), v.row(row(y)), v.row(row(y + 1)), dt_ / dy_, nx_, faces);
}

void DepthFlux::carry(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v, int begin,
                      int end, Grid& after) {
    std::vector<double> east(static_cast<std::size_t>(nx_) + 1);
    std::vector<double> south(static_cast<std::size_t>(nx_));
    std::vector<double> north(static_cast<std::size_t>(nx_));
    moved_north(before, v, begin - 1, south.data());
    for (int y = begin; y < end; ++y) {
        give_up_if_asked();
        moved_east(before, u, y, east.data());
        moved_north(before, v, y, north.data());
        overdrawn_[static_cast<std::size_t>(y)] =
            settle(before.row(y), east.data() + 1, south.data(), north.data(), fallen_, nx_,
                   after.row(y).data())
                ? 1
                : 0;
        std::swap(south, north);
    }
}

void DepthFlux::finish(const PaddedGrid& before, const PaddedGrid& u, const PaddedGrid& v,
                       Grid& after) {
    if (std::find(overdrawn_.begin(), overdrawn_.end(), 1) == overdrawn_.end()) return;
    constexpr double whole = 1.0 - 0x1p-50;  // so that rounding cannot take more than there is
    Grid east(nx_ + 1, ny_);
    Grid north(nx_, ny_);
    for (int y = 0; y < ny_; ++y) {
        give_up_if_asked();
        moved_east(before, u, y, east.row(y).data());
        moved_north(before, v, y, north.row(y).data());
    }
    Grid share(nx_, ny_, 1.0);
    for (int y = 0; y < ny_; ++y) {
        give_up_if_asked();
        for (int x = 0; x < nx_; ++x) {
            const double leaving =
                (std::max(east(x + 1, y), 0.0) + std::max(-east(x, y), 0.0)) +
                (std::max(north(x, y), 0.0) + std::max(-north(x, (y + ny_ - 1) % ny_), 0.0));
            const double there = before.row(y)[x] * whole;
            if (leaving > there) share(x, y) = there / leaving;
        }
    }
    for (int y = 0; y < ny_; ++y) {
        give_up_if_asked();
        for (int x = 0; x <= nx_; ++x) {
            double& moved = east(x, y);
            moved *= share((moved > 0.0 ? x - 1 + nx_ : x) % nx_, y);
        }
        for (int x = 0; x < nx_; ++x) {
            double& moved = north(x, y);
            moved *= share(x, moved > 0.0 ? y : (y + 1) % ny_);
        }
    }
    for (int y = 0; y < ny_; ++y) {
        give_up_if_asked();
        for (int x = 0; x < nx_; ++x) {
            const double out =
                (east(x + 1, y) - east(x, y)) + (north(x, y) - north(x, (y + ny_ - 1) % ny_));
            after(x, y) = std::max(before.row(y)[x] - out, 0.0) + fallen_;
        }
    }
}

}  // namespace fumon
