#include "models/water/finite_volume_scheme.h"

#include <algorithm>
#include <limits>

#include "base/give_up.h"
#include "base/worker_pool.h"

namespace fumon {

using finite_volume::Side;

namespace {

/// Where the cell at `index`, possibly beyond the edges, takes its values from.
struct Source {
    int index = 0;
    bool mirrored = false;
    bool outside = false;
};

Source source_of(int index, int count, EdgeKind edges) {
    if (index >= 0 && index < count) return {index};
    if (edges == EdgeKind::open) return {0, false, true};
    if (edges == EdgeKind::wall) {
        const int twice = 2 * count;
        const int folded = ((index % twice) + twice) % twice;
        if (folded < count) return {folded};
        return {twice - 1 - folded, true};
    }
    return {((index % count) + count) % count};
}

/// What is not a number is above all else.
double larger_rate(double a, double b) {
    return a == a && !(b <= a) ? b : a;
}

double step_of(const std::vector<double>& rates) {
    double most = 0.0;
    for (const double rate : rates) most = larger_rate(most, rate);
    return most == 0.0 ? std::numeric_limits<double>::infinity() : 1.0 / most;
}

}  // namespace

/// One Euler step of the two that make a step.
struct FiniteVolumeScheme::Stage {
    const Water& from;
    const Water* before;  ///< the step's start, with which the second stage is averaged
    Water& to;
    const Grid& bed;
    double dt;
    double rain;
};

FiniteVolumeScheme::FiniteVolumeScheme(const GullyParameters& parameters, const WaterDomain& domain,
                                       WorkerPool& pool)
    : domain_(domain),
      gravity_(parameters.gravity),
      friction_(parameters.friction == FrictionLaw::full ? parameters.friction_coefficient
                                                         : 0.5 * parameters.friction_coefficient),
      pool_(pool),
      strips_(static_cast<std::size_t>(pool.size()),
              finite_volume::Strip(parameters.stopping_steps)) {}

double FiniteVolumeScheme::step_at_courant_one(const Water& water) const {
    const int nx = water.depth.nx();
    std::vector<double> rates(static_cast<std::size_t>(water.depth.ny()));
    pool_.for_ranges(water.depth.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            rates[static_cast<std::size_t>(y)] = finite_volume::fastest(
                water.depth.row(y).data(), water.velocity_x.row(y).data(),
                water.velocity_y.row(y).data(), gravity_, domain_.dx, domain_.dy, nx);
        }
    });
    return step_of(rates);
}

double FiniteVolumeScheme::advance(Water& water, const Grid& bed, double dt, double rain) {
    if (nx_ != water.depth.nx() || ny_ != water.depth.ny()) {
        nx_ = water.depth.nx();
        ny_ = water.depth.ny();
        between_ = {Grid(nx_, ny_), Grid(nx_, ny_), Grid(nx_, ny_)};
        row_left_.resize(static_cast<std::size_t>(ny_));
        row_rates_.resize(row_left_.size());
        find_outlets();
    }
    run({water, nullptr, between_, bed, dt, rain});
    run({between_, &water, water, bed, dt, rain});
    return step_of(row_rates_);
}

void FiniteVolumeScheme::find_outlets() {
    outlets_.assign(static_cast<std::size_t>(ny_), {});
    const auto is_outside = [&](int x, int y) {
        const Source column = source_of(x, nx_, domain_.edges_x);
        const Source row = source_of(y, ny_, domain_.edges_y);
        return column.outside || row.outside ||
               (!domain_.nodata.empty() && domain_.nodata(column.index, row.index) != 0);
    };
    for (int y = 0; y < ny_; ++y) {
        auto& outlets = outlets_[static_cast<std::size_t>(y)];
        for (int x = 0; x < nx_; ++x) {
            if (is_outside(x, y)) continue;
            if (is_outside(x - 1, y)) outlets.push_back({x, Side::west});
            if (is_outside(x + 1, y)) outlets.push_back({x, Side::east});
            if (is_outside(x, y - 1)) outlets.push_back({x, Side::south});
            if (is_outside(x, y + 1)) outlets.push_back({x, Side::north});
        }
    }
}

void FiniteVolumeScheme::run(const Stage& stage) {
    std::fill(row_left_.begin(), row_left_.end(), 0.0);
    std::fill(row_rates_.begin(), row_rates_.end(), 0.0);
    const int shares = pool_.size();
    const auto work = [&](int begin, int end) {
        for (int share = begin; share < end; ++share) {
            const int first = static_cast<int>(static_cast<long long>(ny_) * share / shares);
            const int last = static_cast<int>(static_cast<long long>(ny_) * (share + 1) / shares);
            if (first == last) continue;
            finite_volume::Strip& strip = strips_[static_cast<std::size_t>(share)];
            const int blocks =
                (nx_ + finite_volume::Strip::widest_block - 1) / finite_volume::Strip::widest_block;
            for (int block = 0; block < blocks; ++block) {
                const auto start = static_cast<long long>(nx_) * block / blocks;
                const auto stop = static_cast<long long>(nx_) * (block + 1) / blocks;
                strip.start(static_cast<int>(start), static_cast<int>(stop - start));
                advance_block(stage, strip, first, last);
            }
        }
    };
    pool_.for_ranges(shares, work);
    double sum = 0.0;
    for (const double row : row_left_) sum += row;
    left_ += 0.5 * stage.dt * sum;
}

void FiniteVolumeScheme::advance_block(const Stage& stage, finite_volume::Strip& strip,
                                       int first_row, int last_row) {
    const double dt_dx = stage.dt / domain_.dx;
    const double dt_dy = stage.dt / domain_.dy;
    const finite_volume::UpdateFactors factors{
        stage.dt, dt_dx, dt_dy, gravity_, gravity_ * domain_.slope, friction_, stage.rain};
    const int lowest = first_row - finite_volume::Strip::margin;
    for (int top = lowest; top < last_row + finite_volume::Strip::margin; ++top) {
        give_up_if_asked();
        load_row(stage, strip, top);
        if (top < lowest + 2) continue;
        strip.take_y_slopes(top - 1);
        if (top < lowest + 3) continue;
        strip.take_y_fluxes(top - 2, gravity_);
        if (top < lowest + 4) continue;
        strip.take_x_fluxes(top - 2, gravity_);
        strip.cut_fluxes(top - 2, dt_dx, dt_dy);
        const int y = top - 3;
        if (y < first_row) continue;
        finite_volume::UpdateInput in = strip.update_input(y);
        if (stage.before != nullptr) {
            in.depth_before = stage.before->depth.row(y).data() + strip.first_x();
            in.x_before = stage.before->velocity_x.row(y).data() + strip.first_x();
            in.y_before = stage.before->velocity_y.row(y).data() + strip.first_x();
        }
        finite_volume::update(in, factors, stage.to.depth.row(y).data() + strip.first_x(),
                              stage.to.velocity_x.row(y).data() + strip.first_x(),
                              stage.to.velocity_y.row(y).data() + strip.first_x(), strip.count());
        count_left(strip, y);
        if (stage.before != nullptr) rate_row(stage.to, strip, y);
    }
}

void FiniteVolumeScheme::rate_row(const Water& water, const finite_volume::Strip& strip, int y) {
    const int x = strip.first_x();
    double& rate = row_rates_[static_cast<std::size_t>(y)];
    rate = larger_rate(rate, finite_volume::fastest(water.depth.row(y).data() + x,
                                                    water.velocity_x.row(y).data() + x,
                                                    water.velocity_y.row(y).data() + x, gravity_,
                                                    domain_.dx, domain_.dy, strip.count()));
}

void FiniteVolumeScheme::load_row(const Stage& stage, finite_volume::Strip& strip, int y) const {
    const Source row = source_of(y, ny_, domain_.edges_y);
    double* depth = strip.depth(y);
    double* surface = strip.surface(y);
    double* velocity_x = strip.velocity_x(y);
    double* velocity_y = strip.velocity_y(y);
    double* inside = strip.inside(y);
    const auto clear = [&](int k) {
        depth[k] = surface[k] = velocity_x[k] = velocity_y[k] = inside[k] = 0.0;
    };
    if (row.outside) {
        for (int k = 0; k < strip.padded(); ++k) clear(k);
        return;
    }
    const double sign_y = row.mirrored ? -1.0 : 1.0;
    const auto load = [&](int k, int x, double sign_x) {
        depth[k] = stage.from.depth(x, row.index);
        surface[k] = depth[k] + stage.bed(x, row.index);
        velocity_x[k] = sign_x * stage.from.velocity_x(x, row.index);
        velocity_y[k] = sign_y * stage.from.velocity_y(x, row.index);
        inside[k] = 1.0;
        if (!domain_.nodata.empty() && domain_.nodata(x, row.index) != 0) clear(k);
    };
    const auto load_beyond = [&](int k) {
        const Source column =
            source_of(strip.first_x() + k - finite_volume::Strip::margin, nx_, domain_.edges_x);
        if (column.outside) {
            clear(k);
        } else {
            load(k, column.index, column.mirrored ? -1.0 : 1.0);
        }
    };
    for (int k = 0; k < finite_volume::Strip::margin; ++k) {
        load_beyond(k);
        load_beyond(strip.padded() - 1 - k);
    }
    const int first = strip.first_x();
    const int count = strip.count();
    constexpr int m = finite_volume::Strip::margin;
    const auto source = [&](const Grid& grid) { return grid.row(row.index).data() + first; };
    finite_volume::load_cells(
        {source(stage.from.depth), source(stage.bed), source(stage.from.velocity_x),
         source(stage.from.velocity_y)},
        sign_y, {depth + m, surface + m, velocity_x + m, velocity_y + m, inside + m}, count);
    if (domain_.nodata.empty()) return;
    const std::uint8_t* nodata = domain_.nodata.row(row.index).data() + first;
    for (int x = 0; x < count; ++x) {
        if (nodata[x] != 0) clear(x + m);
    }
}

void FiniteVolumeScheme::count_left(const finite_volume::Strip& strip, int y) {
    double sum = 0.0;
    for (const Outlet& outlet : outlets_[static_cast<std::size_t>(y)]) {
        if (outlet.x < strip.first_x() || outlet.x >= strip.first_x() + strip.count()) continue;
        const bool along_y = outlet.side == Side::west || outlet.side == Side::east;
        sum += strip.outward(outlet.x, y, outlet.side) * (along_y ? domain_.dy : domain_.dx);
    }
    row_left_[static_cast<std::size_t>(y)] += sum;
}

}  // namespace fumon
