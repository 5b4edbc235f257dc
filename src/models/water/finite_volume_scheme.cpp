#include "models/water/finite_volume_scheme.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/cancellation.h"
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

Grid friction_factors(const GullyParameters& parameters, Grid roughness) {
    for (double& cell : roughness.values()) cell = friction_factor(parameters, cell);
    return roughness;
}

}  // namespace

FiniteVolumeScheme::FiniteVolumeScheme(const GullyParameters& parameters, const WaterDomain& domain,
                                       WorkerPool& pool, const Grid& roughness)
    : domain_(domain),
      gravity_(parameters.gravity),
      manning_(parameters.friction == FrictionLaw::manning),
      planes_(parameters.shore_cells == ShoreCells::planes),
      steepness_(parameters.limiter_steepness),
      even_friction_(friction_factor(parameters)),
      friction_(friction_factors(parameters, roughness)),
      pool_(pool),
      strips_(static_cast<std::size_t>(pool.size()),
              finite_volume::Strip(
                  parameters.stopping_steps,
                  {parameters.limiter_tolerance, parameters.gravity, parameters.limiter_steepness,
                   parameters.shore_velocity == ShoreVelocity::even},
                  parameters.shore_cells)) {}

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

/// What depends on the grid's size.
void FiniteVolumeScheme::prepare(const Water& water) {
    if (nx_ == water.depth.nx() && ny_ == water.depth.ny()) return;
    nx_ = water.depth.nx();
    ny_ = water.depth.ny();
    between_ = {Grid(nx_, ny_), Grid(nx_, ny_), Grid(nx_, ny_)};
    row_rates_.resize(static_cast<std::size_t>(ny_));
    edges_ = std::make_unique<WaterEdges>(domain_, nx_, ny_);
    edges_->set_time(time_);
    friction_row_.assign(static_cast<std::size_t>(nx_), even_friction_);
    find_outlets();
    tiles_ = std::make_unique<WetTiles>(nx_, ny_, domain_.edges_x == EdgeKind::periodic,
                                        domain_.edges_y == EdgeKind::periodic);
    keep_inlets_wet();
    if (!planes_) return;
    later_ = {Grid(nx_, ny_), Grid(nx_, ny_), Grid(nx_, ny_)};
    shores_ = std::make_unique<ShorePlanes>(domain_, *edges_, nx_, ny_, gravity_, steepness_);
}

void FiniteVolumeScheme::convert_to_means(Water& water, const Grid& bed) {
    prepare(water);
    if (shores_) shores_->convert_to_means(water, bed, pool_);
}

double FiniteVolumeScheme::advance(Water& water, const Grid& bed, double dt, double rain) {
    prepare(water);
    find_wet(water, rain);
    rain_row_.assign(static_cast<std::size_t>(nx_), rain);
    if (shores_ && flows_ == nullptr) {  // Shu & Osher (1988)
        run({water, nullptr, between_, bed, dt, 0.0, 1.0 / 6.0});
        run({between_, &water, later_, bed, dt, 0.75, 1.0 / 6.0});
        run({later_, &water, water, bed, dt, 1.0 / 3.0, 2.0 / 3.0});
    } else {  // Heun
        run({water, nullptr, between_, bed, dt, 0.0, 0.5});
        run({between_, &water, water, bed, dt, 0.5, 0.5});
    }
    deliver_deficits(water, dt);
    if (flows_ != nullptr) flows_->between = &between_.depth;
    return step_of(row_rates_);
}

/// Of cells along shores, after the last stage.
void FiniteVolumeScheme::deliver_deficits(Water& water, double dt) {
    if (!shores_) return;
    std::vector<int> changed;
    shores_->deliver_deficits(
        water, dt, {flows_ == nullptr ? nullptr : &flows_->stages[1], watched_}, changed);
    for (const int y : changed) {
        row_rates_[static_cast<std::size_t>(y)] = finite_volume::fastest(
            water.depth.row(y).data(), water.velocity_x.row(y).data(),
            water.velocity_y.row(y).data(), gravity_, domain_.dx, domain_.dy, nx_);
    }
}

void FiniteVolumeScheme::set_time(double time) {
    time_ = time;
    if (edges_) edges_->set_time(time);
}

double FiniteVolumeScheme::edge_step_at_courant_one(double time, const Grid& bed) const {
    return fumon::edge_step_at_courant_one(domain_, time, bed, gravity_);
}

void FiniteVolumeScheme::serialise(StateArchive& archive) {
    if (domain_.segments.empty()) {
        archive.value("left_volume", left_);
    } else {
        left_with_flow_.serialise("left_volume", archive);
        entered_.serialise("entered_volume", archive);
    }
}

/// Finds where water is, and clears what the last sub-step left where there is none any more.
void FiniteVolumeScheme::find_wet(const Water& water, double rain) {
    if (rain > 0.0 || rain_ != nullptr) {
        tiles_->find_all();
        return;
    }
    tiles_->find(water.depth, pool_);
    tiles_->for_each_dried([&](int first_x, int first_y, int end_x, int end_y) {
        const auto clear = [&](Grid& grid, int to_x, int to_y) {
            for (int y = first_y; y < to_y; ++y)
                std::fill(grid.row(y).data() + first_x, grid.row(y).data() + to_x, 0.0);
        };
        const auto clear_water = [&](Water& water_left) {
            for (Grid* grid : {&water_left.depth, &water_left.velocity_x, &water_left.velocity_y})
                clear(*grid, end_x, end_y);
        };
        clear_water(between_);
        if (shores_) clear_water(later_);
        if (flows_ == nullptr) return;
        for (FaceFlows::Stage& flow : flows_->stages) {
            clear(flow.east, end_x == nx_ ? nx_ + 1 : end_x, end_y);
            clear(flow.north, end_x, ny_ == end_y ? ny_ + 1 : end_y);
        }
    });
}

void FiniteVolumeScheme::run(const Stage& stage) {
    if (shores_) shores_->find(stage.from, stage.bed, {stage.dt, stage.weight}, pool_);
    std::fill(row_rates_.begin(), row_rates_.end(), 0.0);
    for (std::vector<Outlet>& row : outlets_) {
        for (Outlet& outlet : row) outlet.volume = 0.0;
    }
    const std::vector<int> shares = tiles_->equal_shares(pool_.size());
    pool_.for_ranges(pool_.size(), [&](int begin, int end) {
        for (auto share = static_cast<std::size_t>(begin); share < static_cast<std::size_t>(end);
             ++share) {
            if (shares[share] == shares[share + 1]) continue;
            advance_share(stage, strips_[share], shares[share], shares[share + 1]);
        }
    });
    Volumes sum;
    for (int y = 0; y < ny_; ++y) {
        const Volumes row = volumes_of_row(y);
        sum.left += row.left;
        sum.entered += row.entered;
    }
    if (domain_.segments.empty()) {
        left_ += stage.weight * stage.dt * sum.left;
    } else {
        left_with_flow_.add(stage.weight * stage.dt * sum.left);
        entered_.add(stage.weight * stage.dt * sum.entered);
    }
}

/// The wet parts of some rows: runs of tiles one above the other, over as many columns of tiles as
/// have the same ones, since a part costs a margin of rows more.
void FiniteVolumeScheme::advance_share(const Stage& stage, finite_volume::Strip& strip,
                                       int first_row, int last_row) {
    const int lowest = first_row / WetTiles::height;
    const int highest = (last_row - 1) / WetTiles::height;
    const auto has_the_same = [&](int column, int other) {
        for (int row = lowest; row <= highest; ++row) {
            if (tiles_->is_wet(column, row) != tiles_->is_wet(other, row)) return false;
        }
        return true;
    };
    for (int column = 0; column < tiles_->columns();) {
        int beyond = column + 1;
        while (beyond < tiles_->columns() && has_the_same(column, beyond)) ++beyond;
        const int first_x = column * WetTiles::width;
        const int end_x = std::min(beyond * WetTiles::width, nx_);
        for (int row = lowest; row <= highest; ++row) {
            if (!tiles_->is_wet(column, row)) continue;
            const int first = row;
            while (row <= highest && tiles_->is_wet(column, row)) ++row;
            advance_part(stage, strip,
                         {first_x, end_x, std::max(first * WetTiles::height, first_row),
                          std::min(row * WetTiles::height, last_row)});
        }
        column = beyond;
    }
}

void FiniteVolumeScheme::advance_part(const Stage& stage, finite_volume::Strip& strip,
                                      const Part& part) {
    const int width = part.end_x - part.first_x;
    constexpr int widest = finite_volume::Strip::widest_block;
    const int blocks = (width + widest - 1) / widest;
    for (int block = 0; block < blocks; ++block) {
        const int start = part.first_x + width * block / blocks;
        const int stop = part.first_x + width * (block + 1) / blocks;
        strip.start(start, stop - start, start == 0 && edges_->has_segments(Side::west),
                    stop == nx_ && edges_->has_segments(Side::east));
        advance_block(stage, strip, part.first_y, part.end_y);
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
        manning_,
        stage.kept};
    const int lowest = first_row - finite_volume::Strip::margin;
    const bool flows = edges_->any_flow();
    for (int top = lowest; top < last_row + finite_volume::Strip::margin; ++top) {
        throw_if_cancelled();
        load_row(stage, strip, top);
        strip.compute_invariants(top, gravity_);
        if (top < lowest + 2) continue;
        strip.compute_y_slopes(top - 1);
        if (top < lowest + 3) continue;
        strip.compute_y_fluxes(top - 2, gravity_);
        if (flows) compute_edge_y(strip, top - 2);
        if (top < lowest + 4) continue;
        strip.compute_x_fluxes(top - 2, gravity_);
        if (shores_) set_shore_fluxes(strip, top - 2);
        if (flows) compute_edge_x(strip, top - 2);
        const bool beyond = (top - 2 < 0 && edges_->has_segments(Side::south)) ||
                            (top - 2 >= ny_ && edges_->has_segments(Side::north));
        bound_speeds(stage, strip, top - 2);
        strip.cut_fluxes(top - 2, dt_dx, dt_dy, beyond);
        const int y = top - 3;
        if (y < first_row) continue;
        finite_volume::UpdateInput in = strip.update_input(y);
        in.rain = (rain_ == nullptr ? rain_row_.data() : rain_->row(y).data()) + strip.first_x();
        in.friction =
            (friction_.empty() ? friction_row_.data() : friction_.row(y).data()) + strip.first_x();
        if (stage.before != nullptr) {
            in.depth_before = stage.before->depth.row(y).data() + strip.first_x();
            in.x_before = stage.before->velocity_x.row(y).data() + strip.first_x();
            in.y_before = stage.before->velocity_y.row(y).data() + strip.first_x();
        }
        finite_volume::update(in, factors, stage.to.depth.row(y).data() + strip.first_x(),
                              stage.to.velocity_x.row(y).data() + strip.first_x(),
                              stage.to.velocity_y.row(y).data() + strip.first_x(), strip.count());
        count_left(strip, y);
        if (watched_ != nullptr) count_watched(stage, strip, y);
        if (flows_ != nullptr) keep_flows(stage, strip, y);
        if (stage.before != nullptr) rate_row(stage.to, strip, y);
    }
}

/// The fluxes of cells along shores, in row y, which may lie beyond a periodic edge.
void FiniteVolumeScheme::set_shore_fluxes(finite_volume::Strip& strip, int y) const {
    const CellSource row = source_of(y, ny_, domain_.edges_y);
    const bool is_beyond_wall = row.mirrored || row.outside;
    if (is_beyond_wall && y != -1) return;
    const int from = is_beyond_wall ? -1 : row.index;
    const int across = domain_.edges_x == EdgeKind::periodic ? nx_ : 0;
    for (int shift = -across; shift <= across; shift += std::max(across, 1)) {
        strip.set_x_fluxes(y, shores_->east_faces(from), shift);
        strip.set_y_fluxes(y, shores_->north_faces(from), shift);
    }
}

/// Water that flows over an edge brings a speed of its own.
void FiniteVolumeScheme::bound_speeds(const Stage& stage, finite_volume::Strip& strip,
                                      int y) const {
    const double steepness =
        std::sqrt(domain_.slope * domain_.slope + domain_.slope_x * domain_.slope_x);
    strip.compute_speed_bounds(
        y, {domain_.dx, domain_.dy, gravity_, stage.dt * gravity_ * steepness, stage.dt});
    if (y < 0 || y >= ny_) return;
    for (const Outlet& outlet : outlets_[static_cast<std::size_t>(y)]) {
        if (outlet.is_flow) strip.free_speed(outlet.x, y);
    }
    if (!shores_) return;
    strip.set_slopes(y, shores_->slopes(y));
    for (int beside = std::max(y - 1, 0); beside <= std::min(y + 1, ny_ - 1); ++beside)
        strip.bound_speeds_beside(y, shores_->slopes(beside));
}

/// Of row y: its faces to the west, north and, at the grid's ends, east and south.
void FiniteVolumeScheme::keep_flows(const Stage& stage, finite_volume::Strip& strip, int y) const {
    FaceFlows::Stage& flow = flows_->stages[stage.before == nullptr ? 0 : 1];
    const finite_volume::UpdateInput in = strip.update_input(y);
    const int first = strip.first_x();
    const int count = strip.count();
    std::copy_n(in.west.mass, count, flow.east.row(y).data() + first);
    if (first + count == nx_) flow.east(nx_, y) = in.east.mass[count - 1];
    std::copy_n(in.north.mass, count, flow.north.row(y + 1).data() + first);
    if (y == 0) std::copy_n(in.south.mass, count, flow.north.row(0).data() + first);
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
    if ((y < 0 && edges_->has_segments(Side::south)) ||
        (y >= ny_ && edges_->has_segments(Side::north))) {
        load_ghost_row(stage, strip, y);
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
            const CellIndex edge{is_low ? 0 : nx_ - 1, row.index};
            const CellIndex inner{is_low ? std::min(1, nx_ - 1) : std::max(nx_ - 2, 0), row.index};
            load_ghost_cells(stage, strip, k, y, edge, inner, is_low ? -x : x - nx_ + 1);
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
    constexpr int m = finite_volume::Strip::margin;
    const int first = strip.first_x() - m;
    const int from = first < 0 ? m : 0;  // margins inside the grid are loaded with the rest
    const int to = first + strip.padded() > nx_ ? strip.padded() - m : strip.padded();
    for (int k = 0; k < from; ++k) load_beyond(k);
    for (int k = to; k < strip.padded(); ++k) load_beyond(k);
    const auto source = [&](const Grid& grid) { return grid.row(row.index).data() + first + from; };
    finite_volume::load_cells(
        {source(stage.from.depth), source(stage.bed), source(stage.from.velocity_x),
         source(stage.from.velocity_y)},
        sign_y, {depth + from, surface + from, velocity_x + from, velocity_y + from, inside + from},
        to - from);
    if (domain_.nodata.empty()) return;
    for (int k = from; k < to; ++k) {
        if (domain_.nodata(first + k, row.index) != 0) clear(k);
    }
}

void FiniteVolumeScheme::count_left(const finite_volume::Strip& strip, int y) {
    for (Outlet& outlet : outlets_[static_cast<std::size_t>(y)]) {
        if (outlet.x < strip.first_x() || outlet.x >= strip.first_x() + strip.count()) continue;
        const bool along_y = outlet.side == Side::west || outlet.side == Side::east;
        outlet.volume =
            strip.outward(outlet.x, y, outlet.side) * (along_y ? domain_.dy : domain_.dx);
    }
}

/// Summed in a fixed order, whichever parts the row was advanced in.
FiniteVolumeScheme::Volumes FiniteVolumeScheme::volumes_of_row(int y) const {
    constexpr int widest = finite_volume::Strip::widest_block;
    const int blocks = (nx_ + widest - 1) / widest;
    Volumes row;
    for (int block = 0; block < blocks; ++block) {
        const auto start = static_cast<long long>(nx_) * block / blocks;
        const auto stop = static_cast<long long>(nx_) * (block + 1) / blocks;
        Volumes sum;
        for (const Outlet& outlet : outlets_[static_cast<std::size_t>(y)]) {
            if (outlet.x < start || outlet.x >= stop) continue;
            if (outlet.is_flow && outlet.volume < 0.0) {
                sum.entered -= outlet.volume;
            } else {
                sum.left += outlet.volume;
            }
        }
        row.left += sum.left;
        row.entered += sum.entered;
    }
    return row;
}

}  // namespace fumon
