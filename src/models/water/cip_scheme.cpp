#include "models/water/cip_scheme.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/cancellation.h"
#include "base/state_archive.h"
#include "base/worker_pool.h"
#include "models/water/kernels/cip_advection_vectors.h"
#include "models/water/kernels/depth_vectors.h"
#include "models/water/shallow_water.h"

namespace fumon {

CipScheme::CipScheme(const GullyParameters& parameters, const WaterDomain& domain,
                     const Water& start, WorkerPool& pool)
    : as_published_(parameters.scheme == WaterScheme::cip_as_published),
      steep_(parameters.relief == Relief::steep),
      nx_(start.depth.nx()),
      ny_(start.depth.ny()),
      domain_(domain),
      gravity_(parameters.gravity),
      friction_(constant_friction(parameters)),
      pool_(pool),
      of_u_(nx_, ny_),
      of_v_(nx_, ny_),
      next_{Grid(nx_, ny_), Grid(nx_, ny_), Grid(nx_, ny_)},
      strips_(static_cast<std::size_t>(pool.size())),
      overdrawn_(static_cast<std::size_t>(ny_)),
      rates_(static_cast<std::size_t>(ny_)) {
    start_from(start.velocity_x, of_u_);
    start_from(start.velocity_y, of_v_);
    if (!as_published_) return;
    of_depth_ = Gradient(nx_, ny_);
    gained_depth_ = PaddedGrid(nx_, ny_);
    start_from(start.depth, of_depth_);
}

/// The gradients begin as central differences.
void CipScheme::start_from(const Grid& values, Gradient& gradient) const {
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) {
            const double east = values((x + 1) % nx_, y);
            const double west = values((x + nx_ - 1) % nx_, y);
            gradient.x.row(y)[x] = 0.5 * (east - west);
            gradient.y.row(y)[x] = 0.5 * (values(x, wrapped(y + 1)) - values(x, wrapped(y - 1)));
        }
        gradient.x.wrap(y);
        gradient.y.wrap(y);
    }
}

cip::SubStep CipScheme::sub_step(double dt) const {
    return {dt, domain_.dx, domain_.dy, gravity_, -gravity_ * domain_.slope, friction_};
}

double CipScheme::step_at_courant_one(const Water& water) const {
    std::vector<double> rates(static_cast<std::size_t>(ny_));
    pool_.for_ranges(ny_, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            rates[static_cast<std::size_t>(y)] =
                cip::fastest(water.depth.row(y).data(),
                             {water.velocity_x.row(y).data(), water.velocity_y.row(y).data()},
                             sub_step(0.0), nx_);
        }
    });
    return 1.0 / *std::ranges::max_element(rates);
}

double CipScheme::advance(Water& water, const Grid& bed, double dt, double rain) {
    const cip::SubStep step = sub_step(dt);
    const int shares = pool_.size();
    pool_.for_ranges(shares, [&](int begin, int end) {
        for (int share = begin; share < end; ++share) {
            const auto first_y = static_cast<int>(static_cast<long long>(ny_) * share / shares);
            const auto last_y =
                static_cast<int>(static_cast<long long>(ny_) * (share + 1) / shares);
            if (first_y == last_y) continue;
            std::fill(overdrawn_.begin() + first_y, overdrawn_.begin() + last_y, 0);
            std::fill(rates_.begin() + first_y, rates_.begin() + last_y, 0.0);
            const int blocks = (nx_ + cip::Strip::widest_block - 1) / cip::Strip::widest_block;
            for (int block = 0; block < blocks; ++block) {
                const auto start = static_cast<int>(static_cast<long long>(nx_) * block / blocks);
                const auto stop =
                    static_cast<int>(static_cast<long long>(nx_) * (block + 1) / blocks);
                advance_block(step, water, bed, rain, {start, stop - start, first_y, last_y},
                              strips_[static_cast<std::size_t>(share)]);
            }
        }
    });
    const bool overdrawn = std::ranges::find(overdrawn_, 1) != overdrawn_.end();
    if (as_published_) {
        thin_as_published(step, water, rain);
    } else if (overdrawn) {
        const PassedDepth passed =
            share_depth({water.depth, next_.velocity_x, next_.velocity_y}, dt / domain_.dx,
                        dt / domain_.dy, rain * dt, next_.depth);
        if (watched_ != nullptr) count_shared(passed);
    }
    std::swap(water, next_);
    if (as_published_ && watched_ != nullptr) count_as_published(water, dt);
    for (Gradient* gradient : {&of_u_, &of_v_, &of_depth_}) {
        std::swap(gradient->x, gradient->next_x);
        std::swap(gradient->y, gradient->next_y);
    }
    if (as_published_ || overdrawn) return step_at_courant_one(water);
    return 1.0 / *std::ranges::max_element(rates_);
}

void CipScheme::advance_block(const cip::SubStep& step, const Water& water, const Grid& bed,
                              double rain, const Block& block, cip::Strip& strip) {
    for (int top = block.first_y - cip::Strip::margin; top < block.last_y + cip::Strip::margin;
         ++top) {
        throw_if_cancelled();
        load_row(water, bed, block, top, strip);
        if (top < block.first_y) continue;
        accelerate(step, block, top - 1, strip);
        const int y = top - 2;
        if (!as_published_ && y >= block.first_y - 1) transport_depth(step, rain, block, y, strip);
        if (y >= block.first_y) turn_gradients(step, block, y, strip);
    }
}

void CipScheme::load_row(const Water& water, const Grid& bed, const Block& block, int y,
                         cip::Strip& strip) const {
    const int row = wrapped(y);
    const auto load = [&](cip::Strip::Field field, const Grid& grid) {
        const double* from = grid.row(row).data();
        double* to = strip.row(field, y);
        std::copy_n(from + block.first_x, block.count, to);
        for (int k = 1; k <= cip::Strip::margin; ++k) {
            to[-k] = from[(((block.first_x - k) % nx_) + nx_) % nx_];
            to[block.count - 1 + k] = from[(block.first_x + block.count - 1 + k) % nx_];
        }
    };
    load(cip::Strip::depth, water.depth);
    load(cip::Strip::bed, bed);
    load(cip::Strip::u, water.velocity_x);
    load(cip::Strip::v, water.velocity_y);
}

/// Velocities of row y after advection and forces, a cell further than the block on either side.
void CipScheme::accelerate(const cip::SubStep& step, const Block& block, int y, cip::Strip& strip) {
    const int count = block.count + 2;
    const auto from = [](const cip::Stencil& rows) {
        return cip::Stencil{rows.south - 1, rows.here - 1, rows.north - 1};
    };
    const auto stencil = [&](cip::Strip::Field field) { return from(strip.around(field, y)); };
    const auto row = [&](cip::Strip::Field field) { return strip.row(field, y) - 1; };
    const int row_of_grid = wrapped(y);
    const auto carried = [&](cip::Strip::Field value, const Gradient& gradient) {
        return cip::AdvectedStencil{stencil(value),
                                    from(around(gradient.x, row_of_grid, block.first_x)),
                                    from(around(gradient.y, row_of_grid, block.first_x))};
    };
    cip::advect_velocities(
        carried(cip::Strip::u, of_u_), carried(cip::Strip::v, of_v_), step, steep_, count,
        {row(cip::Strip::advected_u), row(cip::Strip::u_gradient_x), row(cip::Strip::u_gradient_y)},
        {row(cip::Strip::advected_v), row(cip::Strip::v_gradient_x),
         row(cip::Strip::v_gradient_y)});
    const cip::Velocity advected{row(cip::Strip::advected_u), row(cip::Strip::advected_v)};
    const cip::Accelerated after{row(cip::Strip::next_u), row(cip::Strip::next_v),
                                 row(cip::Strip::gained_u), row(cip::Strip::gained_v)};
    const cip::Stencil depth = stencil(cip::Strip::depth);
    const cip::Stencil bed = stencil(cip::Strip::bed);
    if (as_published_) {
        cip::accelerate_row_as_published(depth, bed, {row(cip::Strip::u), row(cip::Strip::v)}, step,
                                         advected, count, after);
    } else if (steep_) {
        cip::accelerate_row_steep(depth, bed, step, advected, count, after);
    } else {
        cip::accelerate_row(depth, bed, step, advected, count, after);
    }
    if (y < block.first_y || y >= block.last_y) return;
    std::copy_n(strip.row(cip::Strip::next_u, y), block.count,
                next_.velocity_x.row(y).data() + block.first_x);
    std::copy_n(strip.row(cip::Strip::next_v, y), block.count,
                next_.velocity_y.row(y).data() + block.first_x);
    if (as_published_) advect_depth(step, block, y, strip);
}

void CipScheme::turn_gradients(const cip::SubStep& step, const Block& block, int y,
                               cip::Strip& strip) {
    const auto turned = [&](cip::Strip::Field x, cip::Strip::Field across, Gradient& gradient) {
        return cip::TurnedRow{strip.row(x, y), strip.row(across, y),
                              gradient.next_x.row(y) + block.first_x,
                              gradient.next_y.row(y) + block.first_x};
    };
    const auto changed = [&](cip::Strip::Field before, cip::Strip::Field after,
                             cip::Strip::Field gained) {
        return cip::ChangedStencil{strip.around(before, y), strip.around(after, y),
                                   strip.around(gained, y)};
    };
    cip::turn_velocity_gradients(changed(cip::Strip::u, cip::Strip::next_u, cip::Strip::gained_u),
                                 changed(cip::Strip::v, cip::Strip::next_v, cip::Strip::gained_v),
                                 step, steep_, block.count,
                                 turned(cip::Strip::u_gradient_x, cip::Strip::u_gradient_y, of_u_),
                                 turned(cip::Strip::v_gradient_x, cip::Strip::v_gradient_y, of_v_));
    if (block.first_x + block.count < nx_) return;
    for (Gradient* gradient : {&of_u_, &of_v_}) {
        gradient->next_x.wrap(y);
        gradient->next_y.wrap(y);
    }
}

/// What passes the faces north of row y, and within the block the row's depth.
void CipScheme::transport_depth(const cip::SubStep& step, double rain, const Block& block, int y,
                                cip::Strip& strip) {
    const auto depth = [&](int row) { return strip.row(cip::Strip::depth, row); };
    double* north = strip.row(cip::Strip::faces_north, y);
    cip::through_faces({depth(y - 1), depth(y), depth(y + 1), depth(y + 2),
                        strip.row(cip::Strip::next_v, y), strip.row(cip::Strip::next_v, y + 1)},
                       step.dt / step.dy, block.count, north);
    if (y < block.first_y) return;
    double* east = strip.row(cip::Strip::faces_east, y);
    const double* here = depth(y) - 1;
    const double* speed = strip.row(cip::Strip::next_u, y) - 1;
    cip::through_faces({here - 1, here, here + 1, here + 2, speed, speed + 1}, step.dt / step.dx,
                       block.count + 1, east - 1);
    const bool overdrawn =
        cip::settle_row(depth(y), east, strip.row(cip::Strip::faces_north, y - 1), north,
                        rain * step.dt, block.count, next_.depth.row(y).data() + block.first_x);
    if (watched_ != nullptr) count_watched(block, y, strip);
    const auto row = static_cast<std::size_t>(y);
    if (overdrawn) overdrawn_[row] = 1;
    rates_[row] =
        std::max(rates_[row],
                 cip::fastest(next_.depth.row(y).data() + block.first_x,
                              {strip.row(cip::Strip::next_u, y), strip.row(cip::Strip::next_v, y)},
                              step, block.count));
}

/// What passes the faces that gauges watch.
void CipScheme::count_watched(const Block& block, int y, cip::Strip& strip) const {
    for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
        const int k = face.x - block.first_x;
        if (k < 0 || k >= block.count) continue;
        const auto outward = [&]() {
            switch (face.side) {
                case GridSide::west:
                    return 0.0 - strip.row(cip::Strip::faces_east, y)[k - 1];
                case GridSide::east:
                    return strip.row(cip::Strip::faces_east, y)[k];
                case GridSide::south:
                    return 0.0 - strip.row(cip::Strip::faces_north, y - 1)[k];
                case GridSide::north:
                    break;
            }
            return strip.row(cip::Strip::faces_north, y)[k];
        };
        face.volume = outward() * (domain_.dx * domain_.dy);
    }
}

/// Instead of what would have passed if there had been enough.
void CipScheme::count_shared(const PassedDepth& passed) const {
    for (int y = 0; y < ny_; ++y) {
        for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
            const auto outward = [&]() {
                switch (face.side) {
                    case GridSide::west:
                        return 0.0 - passed.east(face.x, y);
                    case GridSide::east:
                        return passed.east(face.x + 1, y);
                    case GridSide::south:
                        return 0.0 - passed.north(face.x, wrapped(y - 1));
                    case GridSide::north:
                        break;
                }
                return passed.north(face.x, y);
            };
            face.volume = outward() * (domain_.dx * domain_.dy);
        }
    }
}

void CipScheme::count_as_published(const Water& water, double dt) const {
    for (int y = 0; y < ny_; ++y) {
        for (WatchedFace& face : watched_->rows[static_cast<std::size_t>(y)]) {
            const bool is_x = face.side == GridSide::west || face.side == GridSide::east;
            const int toward = face.side == GridSide::west || face.side == GridSide::south ? -1 : 1;
            const int beside_x = is_x ? (face.x + toward + nx_) % nx_ : face.x;
            const int beside_y = is_x ? y : wrapped(y + toward);
            const Grid& velocity = is_x ? water.velocity_x : water.velocity_y;
            const double mean =
                0.5 * (water.depth(face.x, y) * velocity(face.x, y) +
                       water.depth(beside_x, beside_y) * velocity(beside_x, beside_y));
            face.volume = toward * mean * dt * (is_x ? domain_.dy : domain_.dx);
        }
    }
}

/// The depth waits in next_, its gradients in theirs, for the new velocities of the whole plane.
void CipScheme::advect_depth(const cip::SubStep& step, const Block& block, int y,
                             cip::Strip& strip) {
    cip::advect_row(
        {strip.around(cip::Strip::depth, y), around(of_depth_.x, y, block.first_x),
         around(of_depth_.y, y, block.first_x)},
        {strip.row(cip::Strip::u, y), strip.row(cip::Strip::v, y)}, step, block.count,
        {next_.depth.row(y).data() + block.first_x, of_depth_.next_x.row(y) + block.first_x,
         of_depth_.next_y.row(y) + block.first_x});
}

/// The new velocities' divergence thins the depth, and what that changes turns its gradients.
void CipScheme::thin_as_published(const cip::SubStep& step, const Water& before, double rain) {
    const auto padded = [this](const Grid& grid, int y, PaddedGrid& scratch) {
        std::copy_n(grid.row(y).data(), nx_, scratch.row(0));
        scratch.wrap(0);
        return cip::Stencil{grid.row(wrapped(y - 1)).data(), scratch.row(0),
                            grid.row(wrapped(y + 1)).data()};
    };
    const auto over_rows = [&](const Water& flow, const auto& body) {
        pool_.for_ranges(ny_, [&](int begin, int end) {
            PaddedGrid u_row(nx_, 1);
            PaddedGrid v_row(nx_, 1);
            for (int y = begin; y < end; ++y) {
                throw_if_cancelled();
                body(y, padded(flow.velocity_x, y, u_row), padded(flow.velocity_y, y, v_row));
            }
        });
    };
    over_rows(next_, [&](int y, const cip::Stencil& u, const cip::Stencil& v) {
        double* depth = next_.depth.row(y).data();
        cip::thin_row(before.depth.row(y).data(), depth, u, v, step, rain, nx_, depth,
                      gained_depth_.row(y));
        gained_depth_.wrap(y);
    });
    over_rows(before, [&](int y, const cip::Stencil& u, const cip::Stencil& v) {
        double* gradient_x = of_depth_.next_x.row(y);
        double* gradient_y = of_depth_.next_y.row(y);
        cip::turn_gradient_row(around(gained_depth_, y), u, v, step, nx_,
                               {gradient_x, gradient_y, gradient_x, gradient_y});
        of_depth_.next_x.wrap(y);
        of_depth_.next_y.wrap(y);
    });
}

cip::Stencil CipScheme::around(const PaddedGrid& grid, int y, int first_x) const {
    return {grid.row(wrapped(y - 1)) + first_x, grid.row(y) + first_x,
            grid.row(wrapped(y + 1)) + first_x};
}

std::vector<StateField> CipScheme::state() const {
    std::vector<StateField> fields{{"velocity_x_gradient_x", of_u_.x.values()},
                                   {"velocity_x_gradient_y", of_u_.y.values()},
                                   {"velocity_y_gradient_x", of_v_.x.values()},
                                   {"velocity_y_gradient_y", of_v_.y.values()}};
    if (as_published_) {
        fields.push_back({"depth_gradient_x", of_depth_.x.values()});
        fields.push_back({"depth_gradient_y", of_depth_.y.values()});
    }
    return fields;
}

void CipScheme::serialise(StateArchive& archive) {
    const auto serialise_gradient = [&archive](const std::string& name, Gradient& gradient) {
        archive.values(name + "_gradient_x", gradient.x.all_values());
        archive.values(name + "_gradient_y", gradient.y.all_values());
    };
    serialise_gradient("carried_velocity_x", of_u_);
    serialise_gradient("carried_velocity_y", of_v_);
    if (as_published_) serialise_gradient("carried_depth", of_depth_);
}

}  // namespace fumon
