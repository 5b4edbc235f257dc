#include "models/water/cip_scheme.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/give_up.h"
#include "base/multiversion.h"
#include "base/state_carrier.h"
#include "base/worker_pool.h"
#include "models/water/shallow_water.h"

namespace fumon {

namespace {

FUMON_MULTIVERSION
double rate_of_row(const double* h, const double* u, const double* v, double per_x, double per_y,
                   double gravity, int count) {
    double largest[8] = {};
    const double both = per_x + per_y;
    const auto rate = [&](int x) {
        const double depth = h[x] > 0.0 ? h[x] : 0.0;
        return per_x * std::fabs(u[x]) + per_y * std::fabs(v[x]) +
               both * std::sqrt(gravity * depth);
    };
    int x = 0;
    for (; x + 8 <= count; x += 8) {
        for (int k = 0; k < 8; ++k) {
            const double one = rate(x + k);
            largest[k] = one > largest[k] ? one : largest[k];
        }
    }
    for (; x < count; ++x) largest[0] = std::max(largest[0], rate(x));
    return *std::max_element(largest, largest + 8);
}

/// The largest (|u| + √(g h)) / dx + (|v| + √(g h)) / dy, 1/s: times a sub-step, its Courant
/// number. 0 where all is dry; cells whose values are not numbers are passed over.
double courant_rate(const Water& water, double dx, double dy, double gravity, WorkerPool& pool) {
    const int ny = water.depth.ny();
    std::vector<double> rows(static_cast<std::size_t>(ny));
    pool.for_ranges(ny, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            rows[static_cast<std::size_t>(y)] = rate_of_row(
                water.depth.row(y).data(), water.velocity_x.row(y).data(),
                water.velocity_y.row(y).data(), 1.0 / dx, 1.0 / dy, gravity, water.depth.nx());
        }
    });
    return *std::max_element(rows.begin(), rows.end());
}

void copy_padded(const Grid& from, PaddedGrid& to, int y) {
    const auto row = from.row(y);
    std::copy(row.begin(), row.end(), to.row(y));
    to.wrap(y);
}

void copy_row(const PaddedGrid& from, Grid& to, int y) {
    std::copy(from.row(y), from.row(y) + to.nx(), to.row(y).data());
}

}  // namespace

CipScheme::CipScheme(const GullyParameters& parameters, const WaterDomain& domain,
                     const Water& start, WorkerPool& pool)
    : as_published_(parameters.scheme == WaterScheme::cip_as_published),
      steep_(parameters.relief == Relief::steep),
      nx_(start.depth.nx()),
      ny_(start.depth.ny()),
      domain_(domain),
      gravity_(parameters.gravity),
      friction_(parameters.friction_coefficient *
                (parameters.friction == FrictionLaw::half ? 0.5 : 1.0)),
      pool_(pool),
      u_(nx_, ny_),
      v_(nx_, ny_),
      depth_(nx_, ny_),
      flux_(nx_, ny_, domain.dx, domain.dy) {
    start_from(start.velocity_x, u_);
    start_from(start.velocity_y, v_);
    start_from(start.depth, depth_);
}

double CipScheme::step_at_courant_one(const Water& water) const {
    return 1.0 / courant_rate(water, domain_.dx, domain_.dy, gravity_, pool_);
}

void CipScheme::advance(Water& water, const Grid& bed, double dt, double rain) {
    const cip::SubStep step{dt,       domain_.dx, domain_.dy, gravity_, -gravity_ * domain_.slope,
                            friction_};
    advect_and_accelerate(step, water, bed);
    if (as_published_) thin_as_published(step, rain);
    flux_.begin(dt, rain);
    pool_.for_ranges(ny_, [&](int begin, int end) {
        turn_velocity_gradients(step, begin);
        if (end - begin > 1) turn_velocity_gradients(step, end - 1);
        for (int y = begin; as_published_ && y < end; ++y) {
            turn_gradient(step, depth_, y);
            copy_row(depth_.next, water.depth, y);
        }
        if (!as_published_) flux_.carry(depth_.value, u_.next, v_.next, begin, end, water.depth);
    });
    if (!as_published_) flux_.finish(depth_.value, u_.next, v_.next, water.depth);
    for (Carried* carried : {&u_, &v_, &depth_}) {
        std::swap(carried->gradient_x, carried->next_x);
        std::swap(carried->gradient_y, carried->next_y);
        std::swap(carried->value, carried->next);
    }
}

std::vector<StateField> CipScheme::state() const {
    std::vector<StateField> fields{{"velocity_x_gradient_x", u_.gradient_x.values()},
                                   {"velocity_x_gradient_y", u_.gradient_y.values()},
                                   {"velocity_y_gradient_x", v_.gradient_x.values()},
                                   {"velocity_y_gradient_y", v_.gradient_y.values()}};
    if (as_published_) {
        fields.push_back({"depth_gradient_x", depth_.gradient_x.values()});
        fields.push_back({"depth_gradient_y", depth_.gradient_y.values()});
    }
    return fields;
}

void CipScheme::carry(StateCarrier& carrier) {
    const auto carry_one = [&carrier](const std::string& name, Carried& carried) {
        carrier.values(name, carried.value.all_values());
        carrier.values(name + "_gradient_x", carried.gradient_x.all_values());
        carrier.values(name + "_gradient_y", carried.gradient_y.all_values());
    };
    carry_one("carried_velocity_x", u_);
    carry_one("carried_velocity_y", v_);
    if (as_published_) carry_one("carried_depth", depth_);
}

cip::Stencil CipScheme::around(const PaddedGrid& grid, int y) const {
    return {grid.row((y + ny_ - 1) % ny_), grid.row(y), grid.row((y + 1) % ny_)};
}

/// The gradients begin as central differences.
void CipScheme::start_from(const Grid& values, Carried& carried) const {
    for (int y = 0; y < ny_; ++y) copy_padded(values, carried.value, y);
    for (int y = 0; y < ny_; ++y) {
        const cip::Stencil value = around(carried.value, y);
        for (int x = 0; x < nx_; ++x) {
            carried.gradient_x.row(y)[x] = 0.5 * (value.here[x + 1] - value.here[x - 1]);
            carried.gradient_y.row(y)[x] = 0.5 * (value.north[x] - value.south[x]);
        }
        carried.gradient_x.wrap(y);
        carried.gradient_y.wrap(y);
    }
}

void CipScheme::advect_and_accelerate(const cip::SubStep& step, Water& water, const Grid& bed) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        std::vector<double> advected_u(static_cast<std::size_t>(nx_));
        std::vector<double> advected_v(static_cast<std::size_t>(nx_));
        PaddedGrid bed_row(nx_, 1);
        for (int y = begin; y < end; ++y) {
            give_up_if_asked();
            const auto advect = [&](Carried& carried, double* value) {
                cip::advect_row({around(carried.value, y), around(carried.gradient_x, y),
                                 around(carried.gradient_y, y)},
                                u_.value.row(y), v_.value.row(y), step, nx_,
                                {value, carried.next_x.row(y), carried.next_y.row(y)});
                if (steep_) {
                    cip::hold_advected_row(around(carried.value, y), u_.value.row(y),
                                           v_.value.row(y), nx_, value);
                }
            };
            advect(u_, advected_u.data());
            advect(v_, advected_v.data());
            if (!as_published_) copy_padded(water.depth, depth_.value, y);
            std::copy(bed.row(y).begin(), bed.row(y).end(), bed_row.row(0));
            bed_row.wrap(0);
            const int south = (y + ny_ - 1) % ny_;
            const int north = (y + 1) % ny_;
            const cip::Stencil depth{water.depth.row(south).data(), depth_.value.row(y),
                                     water.depth.row(north).data()};
            const cip::Stencil ground{bed.row(south).data(), bed_row.row(0), bed.row(north).data()};
            if (as_published_) {
                advect(depth_, depth_.next.row(y));
                cip::accelerate_row_as_published(depth, ground, u_.value.row(y), v_.value.row(y),
                                                 step, nx_, advected_u.data(), advected_v.data(),
                                                 u_.next.row(y), v_.next.row(y), u_.gained.row(y),
                                                 v_.gained.row(y));
            } else {
                const auto accelerate = steep_ ? cip::accelerate_row_steep : cip::accelerate_row;
                accelerate(depth, ground, step, nx_, advected_u.data(), advected_v.data(),
                           u_.next.row(y), v_.next.row(y), u_.gained.row(y), v_.gained.row(y));
            }
            for (Carried* carried : {&u_, &v_}) {
                carried->next.wrap(y);
                carried->gained.wrap(y);
            }
            copy_row(u_.next, water.velocity_x, y);
            copy_row(v_.next, water.velocity_y, y);
            // While the rows around it are at hand; the first and the last row wait for others'.
            if (y - 1 > begin) turn_velocity_gradients(step, y - 1);
        }
    });
}

/// The advected depth waits in depth_.next; the new velocities' divergence thins it.
void CipScheme::thin_as_published(const cip::SubStep& step, double rain) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            give_up_if_asked();
            cip::thin_row(depth_.value.row(y), depth_.next.row(y), around(u_.next, y),
                          around(v_.next, y), step, rain, nx_, depth_.next.row(y),
                          depth_.gained.row(y));
            depth_.gained.wrap(y);
            depth_.next.wrap(y);
        }
    });
}

void CipScheme::turn_velocity_gradients(const cip::SubStep& step, int y) {
    turn_gradient(step, u_, y);
    turn_gradient(step, v_, y);
}

void CipScheme::turn_gradient(const cip::SubStep& step, Carried& carried, int y) const {
    cip::turn_gradient_row(around(carried.gained, y), around(u_.value, y), around(v_.value, y),
                           step, nx_, carried.next_x.row(y), carried.next_y.row(y));
    if (steep_) {
        cip::hold_gradient_row(around(carried.next, y), nx_, carried.next_x.row(y),
                               carried.next_y.row(y));
    }
    carried.next_x.wrap(y);
    carried.next_y.wrap(y);
}

}  // namespace fumon
