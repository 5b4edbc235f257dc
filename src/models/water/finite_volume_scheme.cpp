#include "models/water/finite_volume_scheme.h"

#include <algorithm>
#include <limits>

#include "base/give_up.h"
#include "base/worker_pool.h"

namespace fumon {

namespace {

using finite_volume::Side;

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

FiniteVolumeScheme::FiniteVolumeScheme(const GullyParameters& parameters, const WaterDomain& domain,
                                       WorkerPool& pool)
    : domain_(domain),
      gravity_(parameters.gravity),
      friction_(constant_friction(parameters)),
      manning_(parameters.friction == FrictionLaw::manning
                   ? parameters.gravity * (parameters.manning * parameters.manning)
                   : 0.0),
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
        row_volumes_.resize(static_cast<std::size_t>(ny_));
        row_rates_.resize(row_volumes_.size());
        edges_ = std::make_unique<WaterEdges>(domain_, nx_, ny_);
        edges_->set_time(time_);
        find_outlets();
    }
    run({water, nullptr, between_, bed, dt, rain});
    run({between_, &water, water, bed, dt, rain});
    return step_of(row_rates_);
}

void FiniteVolumeScheme::set_time(double time) {
    time_ = time;
    if (edges_) edges_->set_time(time);
}

double FiniteVolumeScheme::edge_step_at_courant_one(double time, const Grid& bed) const {
    return fumon::edge_step_at_courant_one(domain_, time, bed, gravity_);
}

void FiniteVolumeScheme::carry(StateCarrier& carrier) {
    if (domain_.stretches.empty()) {
        carrier.value("left_volume", left_);
    } else {
        left_with_flow_.carry("left_volume", carrier);
        entered_.carry("entered_volume", carrier);
    }
}

void FiniteVolumeScheme::run(const Stage& stage) {
    std::fill(row_volumes_.begin(), row_volumes_.end(), RowVolumes{});
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
                strip.start(static_cast<int>(start), static_cast<int>(stop - start),
                            start == 0 && edges_->has_stretches(Side::west),
                            stop == nx_ && edges_->has_stretches(Side::east));
                advance_block(stage, strip, first, last);
            }
        }
    };
    pool_.for_ranges(shares, work);
    RowVolumes sum;
    for (const RowVolumes& row : row_volumes_) {
        sum.left += row.left;
        sum.entered += row.entered;
    }
    if (domain_.stretches.empty()) {
        left_ += 0.5 * stage.dt * sum.left;
    } else {
        left_with_flow_.add(0.5 * stage.dt * sum.left);
        entered_.add(0.5 * stage.dt * sum.entered);
    }
}

void FiniteVolumeScheme::advance_block(const Stage& stage, finite_volume::Strip& strip,
                                       int first_row, int last_row) {
    const double dt_dx = stage.dt / domain_.dx;
    const double dt_dy = stage.dt / domain_.dy;
    const finite_volume::UpdateFactors factors{
        stage.dt,
        dt_dx,
        dt_dy,
        gravity_,
        gravity_ * domain_.slope,
        0.0 - gravity_ * domain_.slope_x,  // not −0, which would change the sign of zeros
        friction_,
        manning_,
        stage.rain};
    const int lowest = first_row - finite_volume::Strip::margin;
    const bool flows = edges_->any_flow();
    for (int top = lowest; top < last_row + finite_volume::Strip::margin; ++top) {
        give_up_if_asked();
        load_row(stage, strip, top);
        if (top < lowest + 2) continue;
        strip.take_y_slopes(top - 1);
        if (top < lowest + 3) continue;
        strip.take_y_fluxes(top - 2, gravity_);
        if (flows) take_edge_y(strip, top - 2);
        if (top < lowest + 4) continue;
        strip.take_x_fluxes(top - 2, gravity_);
        if (flows) take_edge_x(strip, top - 2);
        const bool beyond = (top - 2 < 0 && edges_->has_stretches(Side::south)) ||
                            (top - 2 >= ny_ && edges_->has_stretches(Side::north));
        strip.cut_fluxes(top - 2, dt_dx, dt_dy, beyond);
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
    if ((y < 0 && edges_->has_stretches(Side::south)) ||
        (y >= ny_ && edges_->has_stretches(Side::north))) {
        load_row_beyond(stage, strip, y);
        return;
    }
    const CellSource row = source_of(y, ny_, domain_.edges_y);
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
        const int x = strip.first_x() + k - finite_volume::Strip::margin;
        const Side side = x < 0 ? Side::west : Side::east;
        const bool is_beyond = x < 0 || x >= nx_;
        if (is_beyond && edges_->flows(side, row.index)) {
            const bool is_low = x < 0;
            const Place edge{is_low ? 0 : nx_ - 1, row.index};
            const Place inner{is_low ? std::min(1, nx_ - 1) : std::max(nx_ - 2, 0), row.index};
            load_on_line(stage, strip, k, y, edge, inner, is_low ? -x : x - nx_ + 1);
            return;
        }
        const CellSource column =
            source_of(x, nx_, is_beyond ? edges_->kind(side, row.index) : domain_.edges_x);
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
    RowVolumes sum;
    for (const Outlet& outlet : outlets_[static_cast<std::size_t>(y)]) {
        if (outlet.x < strip.first_x() || outlet.x >= strip.first_x() + strip.count()) continue;
        const bool along_y = outlet.side == Side::west || outlet.side == Side::east;
        const double volume =
            strip.outward(outlet.x, y, outlet.side) * (along_y ? domain_.dy : domain_.dx);
        if (outlet.is_flow && volume < 0.0) {
            sum.entered -= volume;
        } else {
            sum.left += volume;
        }
    }
    RowVolumes& row = row_volumes_[static_cast<std::size_t>(y)];
    row.left += sum.left;
    row.entered += sum.entered;
}

}  // namespace fumon
