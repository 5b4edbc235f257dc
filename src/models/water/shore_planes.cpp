#include "models/water/shore_planes.h"

#include <algorithm>
#include <cmath>

#include "base/worker_pool.h"
#include "numerics/cell_means.h"
#include "numerics/clipped_plane.h"

namespace fumon {

namespace {

constexpr double smooth_bed = 0.5;  // second differences of a smooth bed over its slopes
constexpr int most_reach = 3;       // cells from which a plane is taken
constexpr int band = 1;             // cells inside that belong to a shore
constexpr double same_water = 0.5;  // of what the depth falls by over a cell

double smaller_if_alike(double a, double b) {
    if (!(a * b > 0.0)) return 0.0;
    return std::fabs(a) < std::fabs(b) ? a : b;
}

using Values = std::array<double, 9>;  // of a plane, level first, each followed by its slopes

/// The largest speed in a cell, about.
double speed_within(const Values& plane) {
    const double u = std::fabs(plane[3]) + 0.5 * (std::fabs(plane[4]) + std::fabs(plane[5]));
    const double v = std::fabs(plane[6]) + 0.5 * (std::fabs(plane[7]) + std::fabs(plane[8]));
    return std::sqrt(u * u + v * v);
}

/// Where the second differences of several cells agree, the smallest.
struct Agreed {
    double value = 0.0;
    bool any = false;

    void take(double other) {
        value = any ? smaller_if_alike(value, other) : other;
        any = true;
    }
};

}  // namespace

ShorePlanes::ShorePlanes(const WaterDomain& domain, const WaterEdges& edges, int nx, int ny,
                         double gravity, double steepness)
    : domain_(domain),
      nx_(nx),
      ny_(ny),
      gravity_(gravity),
      steepest_(steepness),
      wet_(static_cast<std::size_t>(ny)),
      rows_(static_cast<std::size_t>(ny) + 1) {
    const auto padded =
        static_cast<std::size_t>(nx + 2 * pad) * static_cast<std::size_t>(ny + 2 * pad);
    for (std::vector<std::uint8_t>& flags : flags_) flags.resize(padded);
    for (int x = -pad; x < nx + pad; ++x) {
        const CellSource from = source_of(x, nx, domain.edges_x);
        const bool given = (x < 0 && edges.has_segments(GridSide::west)) ||
                           (x >= nx && edges.has_segments(GridSide::east));
        columns_.push_back({from.index, 0, from.mirrored ? -1.0 : 1.0, 1.0, from.outside || given});
    }
    for (int y = -pad; y < ny + pad; ++y) {
        const CellSource from = source_of(y, ny, domain.edges_y);
        const bool given = (y < 0 && edges.has_segments(GridSide::south)) ||
                           (y >= ny && edges.has_segments(GridSide::north));
        places_y_.push_back(
            {0, from.index, 1.0, from.mirrored ? -1.0 : 1.0, from.outside || given});
    }
}

void ShorePlanes::find(const Water& water, const Grid& bed, const StageOfStep& stage,
                       WorkerPool& pool) {
    find_deep(water, bed, pool);
    const auto in_rows = [&](int first, auto of_row) {
        pool.for_ranges(ny_ - first, [&](int begin, int end) {
            for (int y = begin + first; y < end + first; ++y) of_row(y);
        });
    };
    in_rows(0, [&](int y) { find_planes(y); });
    in_rows(0, [&](int y) { find_shore(y); });
    in_rows(-1, [&](int y) { find_faces(y); });
    in_rows(0, [&](int y) { add_deficits(y, stage); });
}

void ShorePlanes::find_deep(const Water& water, const Grid& bed, WorkerPool& pool) {
    water_ = &water;
    bed_ = &bed;
    const auto in_rows = [&](auto of_row) {
        pool.for_ranges(ny_, [&](int begin, int end) {
            for (int y = begin; y < end; ++y) of_row(y);
        });
    };
    in_rows([&](int y) { find_full(y); });
    copy_ghost_flags(full);
    in_rows([&](int y) { find_core(y); });
    copy_ghost_flags(core);
    in_rows([&](int y) { find_inner(y); });
}

void ShorePlanes::convert_to_means(Water& water, const Grid& bed, WorkerPool& pool) {
    find_deep(water, bed, pool);
    Water means = water;
    pool.for_ranges(ny_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < nx_; ++x) {
                Plane plane;
                if (is(core, at(x, y)) || at(x, y).outside || !extend(plane, x, y)) continue;
                const double depth = water.depth(x, y);
                const double rise_x = plane.level_x - plane.bed_x;
                const double rise_y = plane.level_y - plane.bed_y;
                const double reach = same_water * (std::fabs(rise_x) + std::fabs(rise_y));
                double middle = plane.level - plane.bed;
                if (depth > dry_depth) {
                    if (!(std::fabs(depth - middle) <= reach)) continue;
                    middle = depth;
                } else if (!(middle <= reach)) {
                    continue;
                }
                means.depth(x, y) = clipped_plane::mean_depth(
                    depth > dry_depth ? middle : std::min(middle, 0.0), rise_x, rise_y);
                if (depth > dry_depth || !(means.depth(x, y) > 0.0)) continue;
                means.velocity_x(x, y) = plane.u;
                means.velocity_y(x, y) = plane.v;
            }
        }
    });
    water = std::move(means);
}

ShorePlanes::CellReference ShorePlanes::at(int x, int y) const {
    CellReference place = columns_[static_cast<std::size_t>(x + pad)];
    const CellReference& row = places_y_[static_cast<std::size_t>(y + pad)];
    place.y = row.y;
    place.sign_y = row.sign_y;
    place.outside = place.outside || row.outside ||
                    (!domain_.nodata.empty() && domain_.nodata(place.x, place.y) != 0);
    return place;
}

std::size_t ShorePlanes::flag_of(int x, int y) const {
    return static_cast<std::size_t>(y + pad) * static_cast<std::size_t>(nx_ + 2 * pad) +
           static_cast<std::size_t>(x + pad);
}

bool ShorePlanes::is_beside_outside(int x, int y) const {
    return at(x - 1, y).outside || at(x + 1, y).outside || at(x, y - 1).outside ||
           at(x, y + 1).outside;
}

bool ShorePlanes::is(Kind kind, const CellReference& place) const {
    return !place.outside && flags_[kind][flag_of(place.x, place.y)] != 0;
}

/// Limited as those of whole cells are (mean_vectors.h).
template <class Value>
ShorePlanes::Shape ShorePlanes::shape_of(const Value& value, int x, int y) const {
    const double here = value(at(x, y));
    const auto along = [&](int dx, int dy) -> std::array<double, 2> {
        const auto ahead = [&](int sign) {
            const CellReference there = at(x + sign * dx, y + sign * dy);
            return there.outside ? 0.0 : value(there) - here;
        };
        const double back = ahead(-1);
        const double forward = ahead(1);
        const double most = 2.0 * std::min(std::fabs(back), std::fabs(forward));
        return {cell_means::limited_slope(0.0 - back, forward, steepest_),
                std::clamp(forward + back, 0.0 - most, most)};
    };
    const auto [slope_x, bend_x] = along(1, 0);
    const auto [slope_y, bend_y] = along(0, 1);
    return {slope_x, slope_y, bend_x, bend_y};
}

void ShorePlanes::find_planes(int y) {
    Row& row = rows_[slot(y)];
    row.outer.clear();
    std::uint8_t* is_plane = flags_of(planed, y);
    std::fill_n(is_plane, nx_, std::uint8_t{0});
    const std::uint8_t* is_core = flags_of(core, y);
    const auto [begin, end] = wet_[static_cast<std::size_t>(y)];
    for (int x = begin; x < end; ++x) {
        x = static_cast<int>(std::find(is_core + x, is_core + end, std::uint8_t{0}) - is_core);
        if (x == end) break;
        const double depth = water_->depth(x, y);
        if (!(depth > dry_depth) || at(x, y).outside) continue;
        Plane plane;
        if (!extend(plane, x, y) || !fit_own_level(plane, depth)) continue;
        is_plane[x] = 1;
        row.outer.push_back(plane);
    }
}

/// The cells inside next to those join them: limited slopes would treat the water there, of no more
/// depth than a few of the bed's steps, as that of whole cells.
void ShorePlanes::find_shore(int y) {
    Row& row = rows_[slot(y)];
    row.cells = row.outer;
    row.slopes.clear();
    std::uint8_t* is_shore = flags_of(shore, y);
    std::copy_n(flags_of(planed, y), nx_, is_shore);
    for (int dy = -band; dy <= band; ++dy) {
        const CellReference& from = places_y_[static_cast<std::size_t>(y + dy + pad)];
        if (from.outside || from.sign_y < 0.0) continue;
        for (const Plane& plane : rows_[slot(from.y)].outer) {
            for (int dx = -band; dx <= band; ++dx) {
                const CellReference place = at(plane.x + dx, y);
                if (place.sign_x < 0.0 || !is(core, place) || is_shore[place.x] != 0) continue;
                if (is_beside_outside(place.x, y)) continue;
                is_shore[place.x] = 1;
                row.cells.push_back(plane_inside(place.x, y));
            }
        }
    }
    std::ranges::sort(row.cells, {}, &Plane::x);
    for (const Plane& plane : row.cells) row.slopes.push_back(slope_of(plane));
}

double ShorePlanes::surface(const CellReference& place) const {
    return water_->depth(place.x, place.y) + (*bed_)(place.x, place.y);
}

void ShorePlanes::set_bed(Plane& plane, int x, int y) const {
    const auto bed = [&](const CellReference& place) { return (*bed_)(place.x, place.y); };
    plane.x = x;
    plane.bed = bed(at(x, y));
    const Shape shape = shape_of(bed, x, y);
    plane.bed_x = shape.slope_x;
    plane.bed_y = shape.slope_y;
    plane.bed_xx = shape.bend_x;
    plane.bed_yy = shape.bend_y;
}

bool ShorePlanes::is_resolved(int x, int y) const {
    const auto bed = [&](int at_x, int at_y) {
        const CellReference place = at(at_x, at_y);
        return (*bed_)(place.x, place.y);
    };
    const auto is_smooth = [&](int cx, int cy) {
        const double here = bed(cx, cy);
        const auto ahead = [&](int dx, int dy) { return bed(cx + dx, cy + dy) - here; };
        const auto bend = [&](int dx, int dy) {
            return std::fabs(ahead(dx, dy) + ahead(-dx, -dy));
        };
        const auto rise = [&](int dx, int dy) {
            return 0.5 * std::fabs(ahead(dx, dy) - ahead(-dx, -dy));
        };
        return bend(1, 0) + bend(0, 1) < smooth_bed * (rise(1, 0) + rise(0, 1));
    };
    return is_smooth(x, y) && is_smooth(x - 1, y) && is_smooth(x + 1, y) && is_smooth(x, y - 1) &&
           is_smooth(x, y + 1);
}

/// Of a cell of the core.
ShorePlanes::Plane ShorePlanes::plane_inside(int x, int y) const {
    const std::vector<Plane>& inner = rows_[slot(y)].inner;
    const auto known = std::ranges::lower_bound(inner, x, {}, &Plane::x);
    return known != inner.end() && known->x == x ? *known : compute_inside(x, y);
}

ShorePlanes::Plane ShorePlanes::compute_inside(int x, int y) const {
    Plane plane;
    set_bed(plane, x, y);
    const auto of_surface = [&](const CellReference& place) { return surface(place); };
    const auto take = [&](const cell_means::Linear& velocity, double& value, double& value_x,
                          double& value_y) {
        value = velocity.middle;
        value_x = velocity.along_x;
        value_y = velocity.along_y;
    };
    plane.level = of_surface(at(x, y));
    const Shape shape = shape_of(of_surface, x, y);
    plane.level_x = shape.slope_x;
    plane.level_y = shape.slope_y;
    plane.level_xx = shape.bend_x;
    plane.level_yy = shape.bend_y;
    const auto around = [&](const auto& value) {
        cell_means::Patch patch;
        for (std::size_t k = 0; k < patch.size(); ++k) {
            const CellReference place =
                at(x - 1 + static_cast<int>(k % 3), y - 1 + static_cast<int>(k / 3));
            patch[k] = value(place.outside ? at(x, y) : place);
        }
        return patch;
    };
    const cell_means::Patch depth =
        around([&](const CellReference& place) { return water_->depth(place.x, place.y); });
    const cell_means::Patch along_x_carried = around([&](const CellReference& place) {
        return place.sign_x * water_->velocity_x(place.x, place.y);
    });
    const cell_means::Patch along_y_carried = around([&](const CellReference& place) {
        return place.sign_y * water_->velocity_y(place.x, place.y);
    });
    take(cell_means::velocity_of(depth, along_x_carried, steepest_), plane.u, plane.u_x, plane.u_y);
    take(cell_means::velocity_of(depth, along_y_carried, steepest_), plane.v, plane.v_x, plane.v_y);
    return plane;
}

/// As the cell's water feels it in the mean: where its centre of mass is.
ShorePlanes::Slope ShorePlanes::slope_of(const Plane& plane) {
    const auto centre = clipped_plane::centre_of_mass(
        plane.level - plane.bed, plane.level_x - plane.bed_x, plane.level_y - plane.bed_y);
    return {plane.x, plane.level_x + plane.level_xx * centre.x,
            plane.level_y + plane.level_yy * centre.y};
}

/// The plane that the nearest cells inside, in the mean, give a cell of a smooth bed. Sums are in
/// pairs of opposite cells, so that mirror images of a lake, and one with exchanged axes, are such
/// to the last bit.
bool ShorePlanes::extend(Plane& plane, int x, int y) const {
    int reach = 0;
    int inside = 0;
    const auto gives = [&](int dx, int dy) {
        const CellReference place = at(x + dx, y + dy);
        return place.sign_x > 0.0 && place.sign_y > 0.0 && is(core, place);
    };
    while (inside == 0) {
        if (++reach > most_reach) return false;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) inside += gives(dx, dy) ? 1 : 0;
        }
    }
    if (is_beside_outside(x, y) || !is_resolved(x, y)) return false;
    set_bed(plane, x, y);

    Agreed bend_x;
    Agreed bend_y;
    Agreed twist;
    const auto add_bends = [&](int kx, int ky) {
        const auto level = [&](int dx, int dy) {
            const CellReference place = at(kx + dx, ky + dy);
            return surface(place.outside ? at(kx, ky) : place);
        };
        const double here = level(0, 0);
        bend_x.take((level(1, 0) - here) - (here - level(-1, 0)));
        bend_y.take((level(0, 1) - here) - (here - level(0, -1)));
        twist.take(0.25 * ((level(1, 1) + level(-1, -1)) - (level(-1, 1) + level(1, -1))));
    };
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            if (gives(dx, dy)) add_bends(x + dx, y + dy);
        }
    }

    double fastest = 0.0;  // as a front may be that comes from there
    const auto given_by = [&](int dx, int dy) -> Values {
        if (!gives(dx, dy)) return {};
        const CellReference from = at(x + dx, y + dy);
        const Plane p = plane_inside(from.x, from.y);
        fastest = std::max(fastest, std::sqrt(p.u * p.u + p.v * p.v) +
                                        2.0 * std::sqrt(gravity_ * (p.level - p.bed)));
        const double rx = -dx;
        const double ry = -dy;
        const double bent =
            0.5 * (bend_x.value * (rx * rx) + bend_y.value * (ry * ry)) + twist.value * (rx * ry);
        return {(p.level + (p.level_x * rx + p.level_y * ry)) + bent,
                p.level_x + (bend_x.value * rx + twist.value * ry),
                p.level_y + (twist.value * rx + bend_y.value * ry),
                p.u + (p.u_x * rx + p.u_y * ry),
                p.u_x,
                p.u_y,
                p.v + (p.v_x * rx + p.v_y * ry),
                p.v_x,
                p.v_y};
    };
    const auto sum_of = [](const Values& a, const Values& b) {
        Values sum{};
        for (std::size_t n = 0; n < sum.size(); ++n) sum[n] = a[n] + b[n];
        return sum;
    };
    const auto opposite = [&](int dx, int dy) {
        return sum_of(given_by(dx, dy), given_by(-dx, -dy));
    };
    Values sum = sum_of(opposite(0, reach), opposite(reach, 0));
    for (int k = 1; k < reach; ++k) {
        sum = sum_of(sum, sum_of(sum_of(opposite(k, reach), opposite(-k, reach)),
                                 sum_of(opposite(reach, k), opposite(-reach, k))));
    }
    sum = sum_of(sum, sum_of(opposite(reach, reach), opposite(-reach, reach)));
    for (double& value : sum) value /= inside;
    if (!(speed_within(sum) <= fastest)) return false;
    plane.level = sum[0];
    plane.level_x = sum[1];
    plane.level_y = sum[2];
    plane.u = sum[3];
    plane.u_x = sum[4];
    plane.u_y = sum[5];
    plane.v = sum[6];
    plane.v_x = sum[7];
    plane.v_y = sum[8];
    plane.level_xx = bend_x.value;
    plane.level_yy = bend_y.value;
    return true;
}

/// The level from the cell's own depth, where that is the water that the plane has.
bool ShorePlanes::fit_own_level(Plane& plane, double depth) const {
    const double rise_x = plane.level_x - plane.bed_x;
    const double rise_y = plane.level_y - plane.bed_y;
    const double own = plane.bed + clipped_plane::depth_of_mean(depth, rise_x, rise_y);
    const double off = std::fabs(own - plane.level);
    plane.level = own;
    return off <= same_water * (std::fabs(rise_x) + std::fabs(rise_y));
}

}  // namespace fumon
