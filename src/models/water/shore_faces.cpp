// What passes the faces of a shore's cells.

#include <algorithm>
#include <cmath>

#include "models/water/shore_planes.h"
#include "numerics/clipped_plane.h"

namespace fumon {

namespace {

constexpr double speed_floor = 1e-300;  // m/s
constexpr double mass_floor = 1e-300;   // m²/s
constexpr double same_level = 0.25;     // of the bed's slope over a cell

}  // namespace

void ShorePlanes::find_faces(int y) {
    Row& row = rows_[slot(y)];
    row.east.clear();
    row.north.clear();
    const auto is_shore = [&](int x, int at_y) { return is(shore, at(x, at_y)); };
    if (y >= 0) {
        for (const Plane& plane : row.cells) {
            const int west = plane.x - 1;
            const bool wraps = west < 0 && domain_.edges_x == EdgeKind::periodic;
            const bool is_wall = at(west, y).sign_x < 0.0;
            if (!wraps && (is_wall || west < 0 || !is_shore(west, y)))
                row.east.push_back(face_between(west, y, true));
            row.east.push_back(face_between(plane.x, y, true));
        }
        if (domain_.edges_x == EdgeKind::periodic && is_shore(0, y) && !is_shore(nx_ - 1, y))
            row.east.push_back(face_between(nx_ - 1, y, true));
        for (const Plane& plane : row.cells) row.north.push_back(face_between(plane.x, y, false));
    }
    const CellReference& above = places_y_[static_cast<std::size_t>(y + 1 + pad)];
    const bool is_periodic = domain_.edges_y == EdgeKind::periodic;
    if (above.outside || above.sign_y < 0.0 || (y < 0 && is_periodic)) return;
    for (const Plane& plane : rows_[slot(above.y)].cells) {
        if (y < 0 || !is_shore(plane.x, y)) row.north.push_back(face_between(plane.x, y, false));
    }
    std::ranges::sort(row.north, {}, &Face::x);
}

ShorePlanes::Plane ShorePlanes::plane_of(const CellReference& place) const {
    if (is(shore, place)) {
        const std::vector<Plane>& cells = rows_[slot(place.y)].cells;
        return *std::ranges::lower_bound(cells, place.x, {}, &Plane::x);
    }
    if (is(core, place)) return plane_inside(place.x, place.y);
    Plane plane;
    set_bed(plane, place.x, place.y);
    plane.level = surface(place);
    plane.u = water_->velocity_x(place.x, place.y);
    plane.v = water_->velocity_y(place.x, place.y);
    return plane;
}

/// Whether it is thin water of its own, and none that stands as high as that of the next cell.
bool ShorePlanes::is_film(const CellReference& place, const Plane& own, const Plane& beside) const {
    if (is(planed, place) || is(core, place)) return false;
    return std::fabs(own.level - beside.level) >
           same_level * (std::fabs(own.bed_x) + std::fabs(own.bed_y));
}

/// The water of a plane at a face: `sign` is 1 where the face lies east or north of the cell.
ShorePlanes::Side ShorePlanes::side_of(const Plane& plane, bool across_x, double sign, double bed,
                                       double bed_rise) {
    const double half = 0.5 * sign;
    const double level = plane.level + half * (across_x ? plane.level_x : plane.level_y) +
                         (across_x ? plane.level_xx : plane.level_yy) / 12.0;
    const double over = level - bed;
    const double rise = (across_x ? plane.level_y : plane.level_x) - bed_rise;
    const auto means = clipped_plane::means_along(over, rise);
    const auto carried = [&](double middle, double along_x, double along_y) {
        const double across = across_x ? along_x : along_y;
        const double along = across_x ? along_y : along_x;
        return (middle + half * across) + means.centre * along;
    };
    const double u = carried(plane.u, plane.u_x, plane.u_y);
    const double v = carried(plane.v, plane.v_x, plane.v_y);
    return {means.depth, means.square, across_x ? u : v, across_x ? v : u};
}

ShorePlanes::Face ShorePlanes::face_between(int x, int y, bool across_x) const {
    const CellReference back = at(x, y);
    const CellReference forward = across_x ? at(x + 1, y) : at(x, y + 1);
    const auto is_wet = [&](const CellReference& place) {
        return !place.outside && water_->depth(place.x, place.y) > dry_depth;
    };
    const auto is_mirror = [&](const CellReference& place) {
        return (across_x ? place.sign_x : place.sign_y) < 0.0;
    };
    const Plane left = plane_of(back);
    const Plane right = plane_of(forward);
    const auto bed_at = [&](const Plane& plane, double sign) {
        return plane.bed + 0.5 * sign * (across_x ? plane.bed_x : plane.bed_y) +
               (across_x ? plane.bed_xx : plane.bed_yy) / 12.0;
    };
    const double bed_left = bed_at(left, 1.0);
    const double bed_right = bed_at(right, -1.0);
    const double rise_left = across_x ? left.bed_y : left.bed_x;
    const double rise_right = across_x ? right.bed_y : right.bed_x;
    Side l;
    Side r;
    if (is_mirror(back)) {
        r = side_of(right, across_x, -1.0, bed_right, rise_right);
        l = r;
        l.across = 0.0 - r.across;
    } else if (is_mirror(forward)) {
        l = side_of(left, across_x, 1.0, bed_left, rise_left);
        r = l;
        r.across = 0.0 - l.across;
    } else {
        const double bed = 0.5 * (bed_left + bed_right);
        const double rise = 0.5 * (rise_left + rise_right);
        const auto thin = [&](Side& side, const CellReference& place, const Plane& own,
                              const Plane& beside) {
            if (!is_film(place, own, beside)) return;
            const double depth = water_->depth(place.x, place.y);
            side.depth = std::min(side.depth, depth);
            side.square = std::min(side.square, depth * depth);
        };
        if (is_wet(back)) {
            l = side_of(left, across_x, 1.0, bed, rise);
            thin(l, back, left, right);
        }
        if (is_wet(forward)) {
            r = side_of(right, across_x, -1.0, bed, rise);
            thin(r, forward, right, left);
        }
        if (!is_wet(back)) l = r;
        if (!is_wet(forward)) r = l;
    }
    Face face = flux(l, r);
    face.x = x;
    return face;
}

/// HLLC with the wave speeds of two rarefactions, and exact fronts, as for all other faces.
ShorePlanes::Face ShorePlanes::flux(Side left, Side right) const {
    Face face;
    if (!(left.depth > 0.0) && !(right.depth > 0.0)) return face;
    const double c_left = std::sqrt(gravity_ * left.depth);
    const double c_right = std::sqrt(gravity_ * right.depth);
    const double u_left = left.depth > 0.0 ? left.across : right.across - 2.0 * c_right;
    const double u_right = right.depth > 0.0 ? right.across : left.across + 2.0 * c_left;
    const double u_star = 0.5 * (u_left + u_right) + (c_left - c_right);
    const double c_star = 0.5 * (c_left + c_right) + 0.25 * (u_left - u_right);
    const double slowest = std::min(std::min(u_left - c_left, u_star - c_star), 0.0);
    const double quickest = std::max(std::max(u_right + c_right, u_star + c_star), 0.0);
    const double share = 1.0 / std::max(quickest - slowest, speed_floor);
    const double q_left = left.depth * u_left;
    const double q_right = right.depth * u_right;
    const double both = slowest * quickest;
    const double carried =
        (quickest * (q_left * u_left) - slowest * (q_right * u_right)) + both * (q_right - q_left);
    const double pressure_rise = 0.5 * gravity_ * (right.square - left.square);
    face.mass =
        ((quickest * q_left - slowest * q_right) + both * (right.depth - left.depth)) * share;
    // Where nothing passes, the deeper side pays for what its pressure does.
    if (face.mass == 0.0 && left.square != right.square)
        face.mass = left.square > right.square ? mass_floor : 0.0 - mass_floor;
    face.left = (carried - slowest * pressure_rise) * share;
    face.right = (carried - quickest * pressure_rise) * share;
    face.along = std::max(face.mass, 0.0) * left.along + std::min(face.mass, 0.0) * right.along;
    return face;
}

}  // namespace fumon
