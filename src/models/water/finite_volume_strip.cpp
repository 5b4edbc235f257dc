#include "models/water/finite_volume_strip.h"

#include <algorithm>
#include <limits>

#include "models/water/kernels/shore_vectors.h"

namespace fumon::finite_volume {

// In a padded row of w cells, slopes are known at 1 … w−2, the face east of cell k at 1 … w−3, and
// shares at 2 … w−3.

void Strip::start(int first_x, int count, bool edge_west, bool edge_east) {
    first_x_ = first_x;
    count_ = count;
    edge_west_ = edge_west;
    edge_east_ = edge_east;
    for (int y = 0; y < kept; ++y) std::fill_n(row(shares, y), stride, 1.0);
    short_of_water_.fill(false);
}

CellRow Strip::across_x(int y, int from) {
    return {depth(y) + from, surface(y) + from, velocity_x(y) + from, velocity_y(y) + from,
            inside(y) + from};
}

CellRow Strip::across_y(int y, int from) {
    return {depth(y) + from, surface(y) + from, velocity_y(y) + from, velocity_x(y) + from,
            inside(y) + from};
}

HalfSlopes Strip::slopes(Kind kind, int y, int from) {
    double* bed = steps_ == StoppingSteps::bed ? row(kind + 4, y) + from : nullptr;
    return {row(kind, y) + from, row(kind + 1, y) + from, row(kind + 2, y) + from,
            row(kind + 3, y) + from, bed};
}

Fluxes Strip::fluxes(Kind kind, int y, int from) {
    return {row(kind, y) + from, row(kind + 1, y) + from, row(kind + 2, y) + from,
            row(kind + 3, y) + from};
}

void Strip::compute_slopes(const CellRow& back, const CellRow& here, const CellRow& forward,
                           const HalfSlopes& out, int count) const {
    limited_half_slopes(back, here, forward, limits_, out, count);
    if (partly_wet_) shore_half_slopes(back, here, forward, limits_.gravity, out, count);
}

MeanRow Strip::means(Kind kind, int y, int from) {
    return {row(kind, y) + from, row(kind + 1, y) + from, row(kind + 2, y) + from,
            row(kind + 3, y) + from, row(kind + 4, y) + from};
}

/// Cells as their faces see them.
CellRow Strip::at_faces(Kind kind, const CellRow& cells, int y, int from) {
    if (!hold_means_) return cells;
    const MeanRow row = means(kind, y, from);
    return {row.depth, row.surface, row.normal, row.transverse, cells.inside};
}

void Strip::compute_x_fluxes(int y, double gravity) {
    compute_slopes(across_x(y, 0), across_x(y, 1), across_x(y, 2), slopes(x_slopes, y, 1),
                   padded() - 2);
    if (hold_means_)
        means_to_faces(across_x(y, 0), across_x(y, 1), across_x(y, 2), slopes(x_slopes, y, 1),
                       means(x_means, y, 1), padded() - 2);
    face_fluxes(at_faces(x_means, across_x(y, 1), y, 1), slopes(x_slopes, y, 1),
                at_faces(x_means, across_x(y, 2), y, 2), slopes(x_slopes, y, 2), gravity,
                partly_wet_, fluxes(x_fluxes, y, 1), padded() - 3);
}

void Strip::compute_y_slopes(int y) {
    compute_slopes(across_y(y - 1, 2), across_y(y, 2), across_y(y + 1, 2), slopes(y_slopes, y, 2),
                   padded() - 4);
    if (hold_means_)
        means_to_faces(across_y(y - 1, 2), across_y(y, 2), across_y(y + 1, 2),
                       slopes(y_slopes, y, 2), means(y_means, y, 2), padded() - 4);
}

void Strip::compute_y_fluxes(int y, double gravity) {
    face_fluxes(at_faces(y_means, across_y(y, 2), y, 2), slopes(y_slopes, y, 2),
                at_faces(y_means, across_y(y + 1, 2), y + 1, 2), slopes(y_slopes, y + 1, 2),
                gravity, partly_wet_, fluxes(y_fluxes, y, 2), padded() - 4);
}

InvariantRow Strip::invariant_row(int y, int from) {
    return {across_x(y, from), row(invariants, y) + from};
}

void Strip::compute_invariants(int y, double gravity) {
    if (partly_wet_) largest_invariants(across_x(y, 0), gravity, row(invariants, y), padded());
}

void Strip::compute_speed_bounds(int y, const BoundFactors& factors) {
    if (!partly_wet_) return;
    constexpr int from = margin - 1;
    speed_bounds({invariant_row(y - 1, from), invariant_row(y, from), invariant_row(y + 1, from)},
                 factors, {row(bounds, y) + margin, row(bounds + 1, y) + margin}, count_);
}

void Strip::free_speed(int x, int y) {
    const int k = x - first_x_;
    if (k >= 0 && k < count_) row(bounds + 1, y)[margin + k] = -1.0;
}

void Strip::cut_fluxes(int y, double dt_dx, double dt_dy, bool beyond) {
    const auto slot = static_cast<std::size_t>(y & (kept - 1));
    const auto slot_south = static_cast<std::size_t>((y - 1) & (kept - 1));
    const bool was_short = short_of_water_[slot];
    const double* x_mass = row(x_fluxes, y);
    const bool is_short = !beyond && payable_shares(depth(y) + 2, x_mass + 1, x_mass + 2,
                                                    row(y_fluxes, y - 1) + 2, row(y_fluxes, y) + 2,
                                                    dt_dx, dt_dy, row(shares, y) + 2, padded() - 4);
    short_of_water_[slot] = is_short;
    if (was_short && !is_short) std::fill_n(row(shares, y), stride, 1.0);
    if (is_short && edge_west_) std::fill_n(row(shares, y), margin, 1.0);
    if (is_short && edge_east_) std::fill_n(row(shares, y) + margin + count_, margin, 1.0);
    if (is_short)
        cut_to_shares(fluxes(x_fluxes, y, 2), row(shares, y) + 2, row(shares, y) + 3, padded() - 5);
    if (is_short || short_of_water_[slot_south])
        cut_to_shares(fluxes(y_fluxes, y - 1, 2), row(shares, y - 1) + 2, row(shares, y) + 2,
                      padded() - 4);
}

void Strip::set_fluxes(Kind kind, int y, const std::vector<ShorePlanes::Face>& faces, int shift) {
    const int first = kind == x_fluxes ? 1 : 2;
    const int to_padded = margin - first_x_ + shift;
    auto face = std::ranges::lower_bound(faces, first - to_padded, {}, &ShorePlanes::Face::x);
    for (; face != faces.end() && face->x + to_padded <= padded() - 3; ++face) {
        const int k = face->x + to_padded;
        row(kind, y)[k] = face->mass;
        row(kind + 1, y)[k] = face->left;
        row(kind + 2, y)[k] = face->right;
        row(kind + 3, y)[k] = face->along;
    }
}

void Strip::set_x_fluxes(int y, const std::vector<ShorePlanes::Face>& faces, int shift) {
    set_fluxes(x_fluxes, y, faces, shift);
}

void Strip::set_y_fluxes(int y, const std::vector<ShorePlanes::Face>& faces, int shift) {
    set_fluxes(y_fluxes, y, faces, shift);
}

double* Strip::surface_slopes(bool across_x, int y) {
    if (hold_means_) return row((across_x ? x_means : y_means) + 4, y);
    return row((across_x ? x_slopes : y_slopes) + 1, y);
}

void Strip::set_slopes(int y, const std::vector<ShorePlanes::Slope>& slopes) {
    auto slope = std::ranges::lower_bound(slopes, first_x_, {}, &ShorePlanes::Slope::x);
    for (; slope != slopes.end() && slope->x < first_x_ + count_; ++slope) {
        const int k = slope->x - first_x_ + margin;
        surface_slopes(true, y)[k] = 0.5 * slope->surface_x;
        surface_slopes(false, y)[k] = 0.5 * slope->surface_y;
    }
}

void Strip::bound_speeds_beside(int y, const std::vector<ShorePlanes::Slope>& shore) {
    if (shore.empty()) return;
    auto slope = std::ranges::lower_bound(shore, first_x_ - 1, {}, &ShorePlanes::Slope::x);
    for (; slope != shore.end() && slope->x <= first_x_ + count_; ++slope) {
        const int k = slope->x - first_x_ + margin;
        std::fill_n(row(bounds + 1, y) + k - 1, 3, std::numeric_limits<double>::infinity());
    }
}

UpdateInput Strip::update_input(int y) {
    UpdateInput in;
    in.cells = across_x(y, margin);
    in.surface_x = surface_slopes(true, y) + margin;
    in.surface_y = surface_slopes(false, y) + margin;
    in.west = fluxes(x_fluxes, y, margin - 1);
    in.east = fluxes(x_fluxes, y, margin);
    in.south = fluxes(y_fluxes, y - 1, margin);
    in.north = fluxes(y_fluxes, y, margin);
    if (partly_wet_) {
        in.most_speed = row(bounds, y) + margin;
        in.thin = row(bounds + 1, y) + margin;
    }
    return in;
}

EdgeWater Strip::at_face(int k, int y, Side side) const {
    const bool is_x = side == Side::west || side == Side::east;
    const double sign = side == Side::east || side == Side::north ? 1.0 : -1.0;
    const int kind = slopes_across(side);
    const auto value = [&](int field, int slope) {
        return row(field, y)[k] + sign * row(kind + slope, y)[k];
    };
    const double depth = std::max(value(0, 0), 0.0);
    return {depth, sign * value(is_x ? 2 : 3, 2), value(is_x ? 3 : 2, 3), value(1, 1) - depth};
}

void Strip::set_flux(int k, int y, Side side, const EdgeFlux& flux, double depth, double gravity) {
    const bool is_x = side == Side::west || side == Side::east;
    const bool is_low = side == Side::west || side == Side::south;
    const int kind = is_x ? x_fluxes : y_fluxes;
    const int face_row = side == Side::south ? y - 1 : y;
    const int face = side == Side::west ? k - 1 : k;
    const auto set = [&](int field, double value) { row(kind + field, face_row)[face] = value; };
    const double sign = is_low ? -1.0 : 1.0;
    const double change = flux.momentum - 0.5 * gravity * (depth * depth);
    set(0, sign * flux.mass);
    set(1, change);
    set(2, change);
    set(3, sign * flux.along);
}

double Strip::outward(int x, int y, Side side) const {
    const int k = x - first_x_ + margin;
    switch (side) {
        case Side::west:
            return -row(x_fluxes, y)[k - 1];
        case Side::east:
            return row(x_fluxes, y)[k];
        case Side::south:
            return -row(y_fluxes, y - 1)[k];
        case Side::north:
            return row(y_fluxes, y)[k];
    }
    return 0.0;
}

}  // namespace fumon::finite_volume
