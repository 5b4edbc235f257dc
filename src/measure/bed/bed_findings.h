#pragma once

#include <memory>
#include <optional>

#include "base/snapshot.h"
#include "base/snapshot_lookup.h"
#include "measure/bed/bed_along_wind.h"
#include "measure/bed/bed_statistics.h"
#include "measure/bed/bed_waves.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/row_spectrum.h"

namespace fumon {

/// What the measures of a snapshot's bed share. Each is found when it is first asked for, once a
/// snapshot.
class BedFindings {
  public:
    /// What is asked from now on is found in this snapshot, which must not go before the next
    /// call.
    void begin(const Snapshot& snapshot);

    [[nodiscard]] const Snapshot& snapshot() const { return *snapshot_; }
    [[nodiscard]] const std::optional<HorizontalDirection>& wind() const { return wind_; }
    /// The bed along the wind; of winds that cancel, along x.
    const Grid& along();
    /// Whether that goes on past its edges with its other side.
    bool along_is_periodic();

    const BedStatistics& statistics();
    const RowPower& power();                ///< of the bed along the wind
    const BedWaves& waves();                ///< likewise
    double wavelength();                    ///< wavelength_of_spectrum
    const CrestOrientation& orientation();  ///< of the bed as it lies

  private:
    const Snapshot* snapshot_ = nullptr;
    std::optional<HorizontalDirection> wind_;
    std::optional<BedAlongWind> turned_;
    std::optional<BedStatistics> statistics_;
    std::optional<RowPower> power_;
    std::optional<BedWaves> waves_;
    std::optional<CrestOrientation> orientation_;
};

/// Those of the groups of one suite.
using SharedFindings = std::shared_ptr<BedFindings>;

}  // namespace fumon
