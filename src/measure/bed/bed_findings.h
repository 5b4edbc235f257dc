#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "base/snapshot.h"
#include "base/snapshot_lookup.h"
#include "measure/bed/bed_along_wind.h"
#include "measure/bed/bed_statistics.h"
#include "measure/bed/bed_waves.h"
#include "measure/bed/crest_orientation.h"
#include "measure/bed/row_spectrum.h"

namespace fumon {

/// What is found when it is first asked for. Threads may ask at once.
template <class Found>
class FoundOnce {
  public:
    template <class Find>
    Found& get(const Find& find) {
        const std::lock_guard lock(mutex_);
        if (!found_) found_.emplace(find());
        return *found_;
    }
    /// No thread asks meanwhile.
    void forget() { found_.reset(); }

  private:
    std::mutex mutex_;
    std::optional<Found> found_;
};

/// What the measures of a snapshot's bed share. Each is found when it is first asked for, once a
/// snapshot; threads may ask at once.
class BedFindings {
  public:
    /// What is asked from now on is found in this snapshot, which must not go before the next
    /// call. No thread asks meanwhile.
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

    /// The spectra of the rows of the bed along the wind, where that is periodic. One thread asks,
    /// and may take them for others, whose memory is used again.
    RowSpectra& spectra();

  private:
    const BedAlongWind& turned(const HorizontalDirection& direction);

    const Snapshot* snapshot_ = nullptr;
    std::optional<HorizontalDirection> wind_;
    FoundOnce<BedAlongWind> turned_;
    FoundOnce<BedStatistics> statistics_;
    FoundOnce<RowPower> power_;
    RowSpectra spectra_;  ///< found with the power
    FoundOnce<BedWaves> waves_;
    FoundOnce<CrestOrientation> orientation_;
};

/// Those of the groups of one suite.
using SharedFindings = std::shared_ptr<BedFindings>;

}  // namespace fumon
