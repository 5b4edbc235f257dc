#include "models/sediment/sediment_loads.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/cancellation.h"
#include "base/elementary.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/sediment/water_density.h"

namespace fumon {

namespace {

double tangent(double degrees) {
    return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
}

loads::PickUpLaw law_of(const LoadParameters& parameters, const LoadGround& ground) {
    const double d = 1e-3 * parameters.grain_size;
    const double submerged = (parameters.grain_density / water_density - 1.0) * ground.gravity;
    loads::PickUpLaw law;
    law.manning = ground.manning;
    law.per_stress = 1.0 / (submerged * d);
    law.critical = critical_shields(parameters);
    law.unit = parameters.bed_load == BedLoadLaw::none ? 0.0 : std::sqrt(submerged * d * d * d);
    law.slope_x = 0.0 - ground.slope_x;
    law.slope_y = ground.slope;
    law.half_per_x = 0.5 / ground.dx;
    law.half_per_y = 0.5 / ground.dy;
    law.per_tangent = 1.0 / tangent(parameters.repose_angle);
    law.turning = parameters.bed_load_slope;
    if (parameters.entrainment == EntrainmentLaw::excess_shear)
        law.entrainment = parameters.entrainment_rate / parameters.grain_density;
    law.per_entrainment_stress = water_density / parameters.entrainment_stress;
    law.ashida_michiue = parameters.bed_load == BedLoadLaw::ashida_michiue;
    return law;
}

Grid floor_of(const LoadParameters& parameters, const LoadGround& ground) {
    if (parameters.base_level.is_word()) return {};
    Grid floor(ground.nx, ground.ny);
    for (int y = 0; y < ground.ny; ++y) {
        for (int x = 0; x < ground.nx; ++x)
            floor(x, y) = parameters.base_level.value - ground.plane(x, y);
    }
    return floor;
}

/// What a cell at the edge passes on to it.
double with_the_water(double water, double along) {
    if (water > 0.0) return std::max(along, 0.0);
    return water < 0.0 ? std::min(along, 0.0) : 0.0;
}

}  // namespace

SedimentLoads::SedimentLoads(const LoadParameters& parameters, LoadGround ground, WorkerPool& pool)
    : ground_(std::move(ground)),
      pool_(pool),
      law_(law_of(parameters, ground_)),
      settling_(parameters.settling_factor * settling_velocity(parameters, ground_.gravity)),
      inflow_(parameters.inflow_concentration),
      bed_factor_(parameters.morphological_factor / (1.0 - parameters.porosity)),
      suspends_(law_.entrainment > 0.0 || inflow_ > 0.0),
      floor_(floor_of(parameters, ground_)),
      friction_row_(static_cast<std::size_t>(ground_.nx), ground_.friction),
      row_bed_rates_(static_cast<std::size_t>(ground_.ny)) {
    const int nx = ground_.nx;
    const int ny = ground_.ny;
    if (parameters.bank_failure == BankFailure::avalanche) {
        banks_ = std::make_unique<BankCollapse>(ground_, parameters.repose_angle, floor_, pool_);
    }
    if (suspends_) {
        load_ = between_ = Grid(nx, ny);
        before_ = middle_ = PaddedGrid(nx, ny + 2);
    }
    if (law_.unit > 0.0) {
        bed_ = along_x_ = along_y_ = down_slope_ = PaddedGrid(nx, ny + 2);
        east_ = Grid(nx + 1, ny);
        north_ = Grid(nx, ny + 1);
        if (law_.entrainment > 0.0) entrainment_ = Grid(nx, ny);
    }
    if (!floor_.empty() && law_.unit > 0.0) shares_ = Grid(nx, ny, 1.0);
    find_outer_faces();
}

void SedimentLoads::find_outer_faces() {
    const int nx = ground_.nx;
    const int ny = ground_.ny;
    const auto is_outside = [&](int x, int y) {
        if (ground_.periodic_x) x = (x + nx) % nx;
        if (ground_.periodic_y) y = (y + ny) % ny;
        return x < 0 || x >= nx || y < 0 || y >= ny || ground_.outside(x, y);
    };
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (ground_.outside(x, y)) continue;
            if (is_outside(x - 1, y)) outer_faces_.push_back({x, y, true, true});
            if (is_outside(x + 1, y)) outer_faces_.push_back({x, y, true, false});
            if (is_outside(x, y - 1)) outer_faces_.push_back({x, y, false, true});
            if (is_outside(x, y + 1)) outer_faces_.push_back({x, y, false, false});
        }
    }
}

template <class Body>
void SedimentLoads::over_rows(const Body& body) {
    pool_.for_ranges(ground_.ny, [&](int begin, int end) {
        Scratch scratch;
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            if constexpr (std::is_invocable_v<Body, int, Scratch&>) {
                body(y, scratch);
            } else {
                body(y);
            }
        }
    });
}

/// Fills what lies beyond the edges: the other side, `beyond`, or what the line through the last
/// two cells has there.
void SedimentLoads::fill_ghost_cells(PaddedGrid& field, bool extrapolated, double beyond) const {
    const int nx = ground_.nx;
    const int ny = ground_.ny;
    const auto past = [&](double edge, double inner) {
        return extrapolated ? edge + (edge - inner) : beyond;
    };
    double* below = row(field, -1);
    double* above = row(field, ny);
    for (int x = 0; x < nx; ++x) {
        const auto at = [&](int y) { return row(field, y)[x]; };
        below[x] = ground_.periodic_y ? at(ny - 1) : past(at(0), at(std::min(1, ny - 1)));
        above[x] = ground_.periodic_y ? at(0) : past(at(ny - 1), at(std::max(ny - 2, 0)));
    }
    for (int y = 0; y < ny; ++y) {
        double* cells = row(field, y);
        cells[-1] = ground_.periodic_x ? cells[nx - 1] : past(cells[0], cells[std::min(1, nx - 1)]);
        cells[nx] = ground_.periodic_x ? cells[0] : past(cells[nx - 1], cells[std::max(nx - 2, 0)]);
    }
}

void SedimentLoads::begin(const Grid& depth) {
    if (!suspends_) return;
    over_rows([&](int y) {
        loads::concentrate_row(load_.row(y).data(), depth.row(y).data(), ground_.nx,
                               row(before_, y));
    });
    fill_ghost_cells(before_, false, inflow_);
}

/// Of a row, in a stage whose concentrations are known in it and in those beside it.
void SedimentLoads::advect_load_row(int stage, const FaceFlows& flows, double dt, int y) {
    PaddedGrid& concentration = stage == 0 ? before_ : middle_;
    const FaceFlows::Stage& flow = flows.stages[static_cast<std::size_t>(stage)];
    const double* east = flow.east.row(y).data();
    const loads::AdvectedRow carried{row(concentration, y),
                                     row(concentration, y - 1),
                                     row(concentration, y + 1),
                                     east,
                                     east + 1,
                                     flow.north.row(y).data(),
                                     flow.north.row(y + 1).data()};
    const double* from = stage == 0 ? load_.row(y).data() : between_.row(y).data();
    const double* before = stage == 0 ? nullptr : load_.row(y).data();
    double* to = stage == 0 ? between_.row(y).data() : load_.row(y).data();
    loads::advect_load_row(carried, from, before, dt / ground_.dx, dt / ground_.dy, ground_.nx, to);
    for (int x = 0; x < ground_.nx && !ground_.nodata.empty(); ++x) {
        if (ground_.outside(x, y)) to[x] = 0.0;
    }
}

void SedimentLoads::advect_first_stage(const FaceFlows& flows, double dt) {
    over_rows([&](int y) {
        advect_load_row(0, flows, dt, y);
        loads::concentrate_row(between_.row(y).data(), flows.between->row(y).data(), ground_.nx,
                               row(middle_, y));
    });
    fill_ghost_cells(middle_, false, inflow_);
}

/// Cells without data take the mean of the cells beside them that have some.
void SedimentLoads::copy_bed(const Grid& bed) {
    const int nx = ground_.nx;
    over_rows([&](int y) { std::ranges::copy(bed.row(y), row(bed_, y)); });
    for (int y = 0; y < ground_.ny && !ground_.nodata.empty(); ++y) {
        for (int x = 0; x < nx; ++x) {
            if (!ground_.outside(x, y)) continue;
            double sum = 0.0;
            int count = 0;
            const auto add = [&](int at_x, int at_y) {
                const bool has = at_x >= 0 && at_x < nx && at_y >= 0 && at_y < ground_.ny &&
                                 !ground_.outside(at_x, at_y);
                if (has) sum += bed(at_x, at_y);
                if (has) ++count;
            };
            add(x - 1, y);
            add(x + 1, y);
            add(x, y - 1);
            add(x, y + 1);
            row(bed_, y)[x] = count > 0 ? sum / count : 0.0;
        }
    }
    fill_ghost_cells(bed_, true, 0.0);
}

/// Of the cells of a row.
const double* SedimentLoads::friction_of(int y) const {
    return ground_.friction_map.empty() ? friction_row_.data() : ground_.friction_map.row(y).data();
}

double* SedimentLoads::entrainment_of(int y, Scratch& scratch) {
    if (law_.entrainment == 0.0) return nullptr;
    if (!entrainment_.empty()) return entrainment_.row(y).data();
    scratch.entrainment.resize(static_cast<std::size_t>(ground_.nx));
    return scratch.entrainment.data();
}

void SedimentLoads::pick_up_row(const LoadWater& water, int y, Scratch& scratch) {
    const double per_x = 1.0 / ground_.dx;
    const double per_y = 1.0 / ground_.dy;
    scratch.bed_rates.resize(static_cast<std::size_t>(ground_.nx));
    const bool has_bed_load = law_.unit > 0.0;
    const loads::PickUpRow from{water.depth.row(y).data(),
                                water.u.row(y).data(),
                                water.v.row(y).data(),
                                friction_of(y),
                                has_bed_load ? row(bed_, y) : nullptr,
                                has_bed_load ? row(bed_, y - 1) : nullptr,
                                has_bed_load ? row(bed_, y + 1) : nullptr};
    const loads::PickedUp to{has_bed_load ? row(along_x_, y) : nullptr,
                             has_bed_load ? row(along_y_, y) : nullptr,
                             has_bed_load ? row(down_slope_, y) : nullptr,
                             entrainment_of(y, scratch), scratch.bed_rates.data()};
    loads::pick_up_row(law_, from, per_x + per_y, per_x * per_x + per_y * per_y, ground_.nx, to);
    row_bed_rates_[static_cast<std::size_t>(y)] =
        loads::largest_bed_rate(scratch.bed_rates.data(), ground_.nx);
}

void SedimentLoads::find_faces(const FaceFlows& flows) {
    const int nx = ground_.nx;
    const double per_x = 1.0 / ground_.dx;
    const double per_y = 1.0 / ground_.dy;
    const auto north_faces = [&](int y) {
        loads::face_row({row(along_y_, y - 1), row(along_y_, y), row(down_slope_, y - 1),
                         row(down_slope_, y), row(bed_, y - 1), row(bed_, y)},
                        per_y, law_.slope_y, nx, north_.row(y).data());
    };
    over_rows([&](int y) {
        loads::face_row({row(along_x_, y) - 1, row(along_x_, y), row(down_slope_, y) - 1,
                         row(down_slope_, y), row(bed_, y) - 1, row(bed_, y)},
                        per_x, law_.slope_x, nx + 1, east_.row(y).data());
        north_faces(y);
        if (y == ground_.ny - 1) north_faces(ground_.ny);
    });
    for (const OuterFace& face : outer_faces_) {
        const int x = face.face_x();
        const int y = face.face_y();
        if (face.along_x) {
            const double flow = flows.stages[0].east(x, y) + flows.stages[1].east(x, y);
            east_(x, y) = with_the_water(flow, row(along_x_, face.y)[face.x]);
        } else {
            const double flow = flows.stages[0].north(x, y) + flows.stages[1].north(x, y);
            north_(x, y) = with_the_water(flow, row(along_y_, face.y)[face.x]);
        }
    }
}

/// Cuts what leaves a cell to what lies above the base level: bed load may take half of it,
/// entrainment the other half (hold_row_above_base).
void SedimentLoads::hold_above_base(const Grid& bed, double dt) {
    const int nx = ground_.nx;
    const int ny = ground_.ny;
    over_rows([&](int y) {
        for (int x = 0; x < nx; ++x) {
            const double most = above_base_share(dt) * std::max(bed(x, y) - floor_(x, y), 0.0);
            const double out =
                (std::max(east_(x + 1, y), 0.0) - std::min(east_(x, y), 0.0)) / ground_.dx +
                (std::max(north_(x, y + 1), 0.0) - std::min(north_(x, y), 0.0)) / ground_.dy;
            shares_(x, y) = out > most ? most / out : 1.0;
        }
    });
    const auto share = [&](int x, int y) {
        if (ground_.periodic_x) x = (x + nx) % nx;
        if (ground_.periodic_y) y = (y + ny) % ny;
        return x < 0 || x >= nx || y < 0 || y >= ny ? 1.0 : shares_(x, y);
    };
    const auto cut_north = [&](int y) {
        for (int x = 0; x < nx; ++x) {
            double& flux = north_(x, y);
            flux *= share(x, flux > 0.0 ? y - 1 : y);
        }
    };
    over_rows([&](int y) {
        for (int x = 0; x <= nx; ++x) {
            double& flux = east_(x, y);
            flux *= share(flux > 0.0 ? x - 1 : x, y);
        }
        cut_north(y);
        if (y == ny - 1) cut_north(ny);
    });
}

void SedimentLoads::count_outer_faces(const FaceFlows& flows, double dt) {
    double left = 0.0;
    double entered = 0.0;
    for (const OuterFace& face : outer_faces_) {
        const int x = face.face_x();
        const int y = face.face_y();
        const double outward = (face.low ? -dt : dt) * (face.along_x ? ground_.dy : ground_.dx);
        const auto count = [&](double through) {
            const double volume = outward * through;
            if (volume > 0.0) {
                left += volume;
            } else {
                entered -= volume;
            }
        };
        if (!east_.empty()) count(face.along_x ? east_(x, y) : north_(x, y));
        if (!suspends_) continue;
        for (std::size_t stage = 0; stage < 2; ++stage) {
            const FaceFlows::Stage& flow = flows.stages[stage];
            const double water = face.along_x ? flow.east(x, y) : flow.north(x, y);
            const bool out = face.low ? water < 0.0 : water > 0.0;
            const double inside = row(stage == 0 ? before_ : middle_, face.y)[face.x];
            count(0.5 * water * (out ? inside : inflow_));
        }
    }
    left_.add(left);
    entered_.add(entered);
}

/// Takes up, where the base level lets it, and settles.
void SedimentLoads::settle_row(Grid& bed, const LoadWater& water, double dt, int y,
                               Scratch& scratch) {
    const int nx = ground_.nx;
    const loads::SettlingFactors factors{dt, dt / ground_.dx, dt / ground_.dy, settling_,
                                         bed_factor_};
    const bool has_bed_load = law_.unit > 0.0;
    double* entrainment = entrainment_of(y, scratch);
    if (entrainment != nullptr && !floor_.empty()) {
        loads::hold_above_row(floor_.row(y).data(), bed.row(y).data(), above_base_share(dt), nx,
                              entrainment);
    }
    if (!suspends_) scratch.nothing.assign(static_cast<std::size_t>(nx), 0.0);
    std::vector<double>& kept = scratch.kept;
    if (!ground_.nodata.empty()) kept.assign(bed.row(y).begin(), bed.row(y).end());
    const double* east = has_bed_load ? east_.row(y).data() : nullptr;
    const loads::SettledRow from{water.depth.row(y).data(),
                                 entrainment,
                                 east,
                                 has_bed_load ? east + 1 : nullptr,
                                 has_bed_load ? north_.row(y).data() : nullptr,
                                 has_bed_load ? north_.row(y + 1).data() : nullptr};
    loads::settle_row(from, factors, nx, suspends_ ? load_.row(y).data() : scratch.nothing.data(),
                      bed.row(y).data());
    for (int x = 0; x < nx && !kept.empty(); ++x) {
        if (ground_.outside(x, y)) bed(x, y) = kept[static_cast<std::size_t>(x)];
    }
}

/// Bed load goes through the faces of rows side by side; without it a row is done at once, while it
/// is in the cache.
void SedimentLoads::advance(Grid& bed, const LoadWater& water, const FaceFlows& flows, double dt) {
    const bool has_bed_load = law_.unit > 0.0;
    const bool picks_up = has_bed_load || law_.entrainment > 0.0;
    const auto advect = [&](int y) {
        if (suspends_) advect_load_row(1, flows, dt, y);
    };
    const auto pick_up = [&](int y, Scratch& scratch) {
        if (picks_up) pick_up_row(water, y, scratch);
    };
    const auto settle = [&](int y, Scratch& scratch) { settle_row(bed, water, dt, y, scratch); };
    if (suspends_) advect_first_stage(flows, dt);
    if (has_bed_load) {
        copy_bed(bed);
        over_rows([&](int y, Scratch& scratch) {
            advect(y);
            pick_up(y, scratch);
        });
        for (PaddedGrid* field : {&along_x_, &along_y_, &down_slope_})
            fill_ghost_cells(*field, false, 0.0);
        find_faces(flows);
        if (!floor_.empty()) hold_above_base(bed, dt);
        over_rows(settle);
    } else {
        over_rows([&](int y, Scratch& scratch) {
            advect(y);
            pick_up(y, scratch);
            settle(y, scratch);
        });
    }
    if (picks_up) bed_rate_ = bed_factor_ * *std::ranges::max_element(row_bed_rates_);
    if (!outer_faces_.empty()) count_outer_faces(flows, dt);
}

double SedimentLoads::suspended() const {
    CompensatedSum sum;
    for (const double load : load_.values()) sum.add(load);
    return ground_.dx * ground_.dy * sum.value();
}

Grid SedimentLoads::concentration(const Grid& depth) const {
    Grid field(ground_.nx, ground_.ny);
    for (std::size_t cell = 0; cell < load_.size(); ++cell) {
        const double h = depth.values()[cell];
        if (h > loads::thin_water) field.values()[cell] = load_.values()[cell] / h;
    }
    return field;
}

std::vector<StateField> SedimentLoads::state() const {
    std::vector<StateField> fields;
    if (suspends_) fields.push_back({"suspended_load", load_.values()});
    fields.push_back({"bed_pace", std::span(&bed_rate_, 1)});
    return fields;
}

void SedimentLoads::serialise(StateArchive& archive) {
    if (suspends_) archive.values("suspended_load", load_.values());
    archive.value("bed_pace", bed_rate_);
    left_.serialise("sediment_left", archive);
    entered_.serialise("sediment_entered", archive);
}

}  // namespace fumon
