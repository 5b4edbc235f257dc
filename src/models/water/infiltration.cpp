#include "models/water/infiltration.h"

#include <algorithm>

#include "base/elementary.h"
#include "base/error.h"
#include "base/worker_pool.h"
#include "models/water/kernels/infiltration_vectors.h"
#include "models/water/kernels/sediment_vectors.h"

namespace fumon {

namespace {

constexpr double hour = 3600.0;

}  // namespace

Infiltration::Infiltration(const GullyParameters& parameters, Soil soil, double cell_area, int nx,
                           int ny, WorkerPool& pool)
    : law_(parameters.infiltration),
      rate_(std::move(soil.rate), parameters.infiltration_rate * millimetre_per_hour, nx),
      start_(std::move(soil.start), parameters.infiltration_start * millimetre_per_hour, nx),
      decay_(parameters.infiltration_decay / hour),
      suction_(std::move(soil.suction), parameters.suction_head * parameters.moisture_deficit, nx),
      cell_area_(cell_area),
      pool_(pool),
      recovery_(parameters.infiltration_recovery / hour) {
    const bool by_intake =
        law_ == InfiltrationLaw::horton && parameters.horton_by == HortonBy::intake;
    if (recovery_ > 0.0 && !by_intake) {
        throw KeyError("model.infiltration_recovery",
                       "belongs to infiltration = \"horton\" with horton_by = \"intake\"; write "
                       "these, or leave the key out");
    }
    if (!takes()) return;
    if (by_intake) fallen_ = Grid(nx, ny, 1.0);
    rows_.resize(static_cast<std::size_t>(ny));
    if (law_ == InfiltrationLaw::green_ampt) total_ = Grid(nx, ny);
}

void Infiltration::advance(Grid& depth, double time, double dt) {
    if (!takes()) return;
    const bool horton = law_ == InfiltrationLaw::horton;
    const double fallen = horton ? elementary::exp(-decay_ * (time + 0.5 * dt)) : 0.0;
    const double falls = elementary::exp(-decay_ * dt);
    const double stays = elementary::exp(-recovery_ * dt);
    constexpr double most = 500.0;  // of which e is a number
    const double grown = elementary::expm1_positive(std::min(decay_ * dt, most));
    const double lasts = decay_ > 0.0 ? grown / (grown + 1.0) / decay_ : dt;
    const int nx = depth.nx();
    pool_.for_ranges(depth.ny(), [&](int begin, int end) {
        std::vector<double> taken(static_cast<std::size_t>(nx));
        for (int y = begin; y < end; ++y) {
            double* row = depth.row(y).data();
            if (law_ == InfiltrationLaw::green_ampt) {
                infiltration::green_ampt_row({rate_.row(y), suction_.row(y), dt}, nx, row,
                                             total_.row(y).data(), taken.data());
            } else if (!fallen_.empty()) {
                infiltration::horton_row(
                    {rate_.row(y), start_.row(y), decay_, falls, lasts, stays, dt}, nx, row,
                    fallen_.row(y).data(), taken.data());
            } else {
                const double* start = horton ? start_.row(y) : rate_.row(y);
                infiltration::take_row({rate_.row(y), start, fallen, dt}, nx, row, taken.data());
            }
            rows_[static_cast<std::size_t>(y)] = sediment::row_sum(taken.data(), nx);
        }
    });
    for (const double row : rows_) volume_.add(cell_area_ * row);
}

void Infiltration::serialise(StateArchive& archive) {
    if (!takes()) return;
    volume_.serialise("infiltrated_volume", archive);
    if (!total_.empty()) archive.values("infiltrated", total_.values());
    if (!fallen_.empty()) archive.values("infiltration_capacity", fallen_.values());
}

}  // namespace fumon
