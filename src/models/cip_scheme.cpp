#include "models/cip_scheme.h"

#include <algorithm>
#include <limits>

#include "models/courant.h"
#include "support/worker_pool.h"

namespace fumon {

CipScheme::CipScheme(const GullyParameters& parameters, const WaterDomain& domain,
                     const Water& start, WorkerPool& pool)
    : as_published_(parameters.scheme == WaterScheme::cip_as_published),
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
      bed_(nx_, ny_),
      flux_(nx_, ny_, domain.dx, domain.dy, pool) {
    take_in(start, Grid(nx_, ny_));
    for (Carried* carried : {&u_, &v_, &depth_}) start_gradients(*carried);
}

double CipScheme::step_at_courant_one(const Water& water) const {
    return 1.0 / courant_rate(water, domain_.dx, domain_.dy, gravity_, pool_);
}

void CipScheme::advance(Water& water, const Grid& bed, double dt, double rain) {
    const cip::SubStep step{dt,       domain_.dx, domain_.dy, gravity_, -gravity_ * domain_.slope,
                            friction_};
    take_in(water, bed);
    advect_and_accelerate(step);
    if (as_published_) {
        thin_as_published(step, rain);
        turn_gradients(step, depth_);
    } else {
        flux_.carry(depth_.value, u_.next, v_.next, dt, rain, water.depth);
    }
    turn_gradients(step, u_);
    turn_gradients(step, v_);
    give_back(water);
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

cip::Stencil CipScheme::around(const PaddedGrid& grid, int y) const {
    return {grid.row((y + ny_ - 1) % ny_), grid.row(y), grid.row((y + 1) % ny_)};
}

void CipScheme::take_in(const Water& water, const Grid& bed) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        const auto copy = [](const Grid& from, PaddedGrid& to, int y) {
            const auto row = from.row(y);
            std::copy(row.begin(), row.end(), to.row(y));
            to.wrap(y);
        };
        for (int y = begin; y < end; ++y) {
            copy(water.velocity_x, u_.value, y);
            copy(water.velocity_y, v_.value, y);
            copy(water.depth, depth_.value, y);
            copy(bed, bed_, y);
        }
    });
}

/// Central differences.
void CipScheme::start_gradients(Carried& carried) {
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

void CipScheme::advect_and_accelerate(const cip::SubStep& step) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        std::vector<double> advected_u(static_cast<std::size_t>(nx_));
        std::vector<double> advected_v(static_cast<std::size_t>(nx_));
        for (int y = begin; y < end; ++y) {
            const auto advect = [&](Carried& carried, double* value) {
                cip::advect_row({around(carried.value, y), around(carried.gradient_x, y),
                                 around(carried.gradient_y, y)},
                                u_.value.row(y), v_.value.row(y), step, nx_,
                                {value, carried.next_x.row(y), carried.next_y.row(y)});
            };
            advect(u_, advected_u.data());
            advect(v_, advected_v.data());
            const cip::Stencil depth = around(depth_.value, y);
            const cip::Stencil bed = around(bed_, y);
            if (as_published_) {
                advect(depth_, depth_.next.row(y));
                cip::accelerate_row_as_published(depth, bed, u_.value.row(y), v_.value.row(y), step,
                                                 nx_, advected_u.data(), advected_v.data(),
                                                 u_.next.row(y), v_.next.row(y), u_.gained.row(y),
                                                 v_.gained.row(y));
            } else {
                cip::accelerate_row(depth, bed, step, nx_, advected_u.data(), advected_v.data(),
                                    u_.next.row(y), v_.next.row(y), u_.gained.row(y),
                                    v_.gained.row(y));
            }
            for (Carried* carried : {&u_, &v_}) {
                carried->next.wrap(y);
                carried->gained.wrap(y);
            }
        }
    });
}

/// The advected depth waits in depth_.next; the new velocities' divergence thins it.
void CipScheme::thin_as_published(const cip::SubStep& step, double rain) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            cip::thin_row(depth_.value.row(y), depth_.next.row(y), around(u_.next, y),
                          around(v_.next, y), step, rain, nx_, depth_.next.row(y),
                          depth_.gained.row(y));
            depth_.gained.wrap(y);
        }
    });
}

void CipScheme::turn_gradients(const cip::SubStep& step, Carried& carried) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            cip::turn_gradient_row(around(carried.gained, y), around(u_.value, y),
                                   around(v_.value, y), step, nx_, carried.next_x.row(y),
                                   carried.next_y.row(y));
            carried.next_x.wrap(y);
            carried.next_y.wrap(y);
        }
    });
    std::swap(carried.gradient_x, carried.next_x);
    std::swap(carried.gradient_y, carried.next_y);
}

void CipScheme::give_back(Water& water) {
    pool_.for_ranges(ny_, [&](int begin, int end) {
        const auto copy = [this](const PaddedGrid& from, Grid& to, int y) {
            std::copy(from.row(y), from.row(y) + nx_, to.row(y).data());
        };
        for (int y = begin; y < end; ++y) {
            copy(u_.next, water.velocity_x, y);
            copy(v_.next, water.velocity_y, y);
            if (as_published_) copy(depth_.next, water.depth, y);
        }
    });
}

}  // namespace fumon
