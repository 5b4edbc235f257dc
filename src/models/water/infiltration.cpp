#include "models/water/infiltration.h"

#include "base/elementary.h"
#include "base/worker_pool.h"
#include "models/water/kernels/infiltration_vectors.h"
#include "models/water/kernels/sediment_vectors.h"

namespace fumon {

namespace {

constexpr double hour = 3600.0;

}  // namespace

Infiltration::Infiltration(const GullyParameters& parameters, double cell_area, int nx, int ny,
                           WorkerPool& pool)
    : law_(parameters.infiltration),
      rate_(parameters.infiltration_rate * millimetre_per_hour),
      start_(parameters.infiltration_start * millimetre_per_hour),
      decay_(parameters.infiltration_decay / hour),
      suction_(parameters.suction_head * parameters.moisture_deficit),
      cell_area_(cell_area),
      pool_(pool) {
    if (!takes()) return;
    rows_.resize(static_cast<std::size_t>(ny));
    if (law_ == InfiltrationLaw::green_ampt) total_ = Grid(nx, ny);
}

void Infiltration::advance(Grid& depth, double time, double dt) {
    if (!takes()) return;
    double most = rate_ * dt;
    if (law_ == InfiltrationLaw::horton) {
        const double fallen = elementary::exp(-decay_ * (time + 0.5 * dt));
        most = (rate_ + (start_ - rate_) * fallen) * dt;
    }
    const int nx = depth.nx();
    pool_.for_ranges(depth.ny(), [&](int begin, int end) {
        std::vector<double> taken(static_cast<std::size_t>(nx));
        for (int y = begin; y < end; ++y) {
            double* row = depth.row(y).data();
            if (law_ == InfiltrationLaw::green_ampt) {
                infiltration::green_ampt_row(most, suction_, nx, row, total_.row(y).data(),
                                             taken.data());
            } else {
                infiltration::take_row(most, nx, row, taken.data());
            }
            rows_[static_cast<std::size_t>(y)] = sediment::row_sum(taken.data(), nx);
        }
    });
    for (const double row : rows_) volume_.add(cell_area_ * row);
}

void Infiltration::carry(StateCarrier& carrier) {
    if (!takes()) return;
    volume_.carry("infiltrated_volume", carrier);
    if (!total_.empty()) carrier.values("infiltrated", total_.values());
}

}  // namespace fumon
