#include "measure/bed/bed_findings.h"

#include "measure/bed/wavelength.h"

namespace fumon {

void BedFindings::begin(const Snapshot& snapshot) {
    snapshot_ = &snapshot;
    wind_ = downwind(snapshot);
    turned_.forget();
    statistics_.forget();
    power_.forget();
    waves_.forget();
    orientation_.forget();
}

const BedAlongWind& BedFindings::turned(const HorizontalDirection& direction) {
    return turned_.get([&] { return bed_along_wind(*snapshot_, direction); });
}

const Grid& BedFindings::along() {
    const HorizontalDirection direction = wind_.value_or(HorizontalDirection{});
    return direction.is_east() ? snapshot_->bed : turned(direction).bed;
}

bool BedFindings::along_is_periodic() {
    const HorizontalDirection direction = wind_.value_or(HorizontalDirection{});
    return direction.is_east() ? snapshot_->periodic : turned(direction).periodic;
}

const BedStatistics& BedFindings::statistics() {
    return statistics_.get([&] { return bed_statistics(snapshot_->bed, snapshot_->nodata); });
}

const RowPower& BedFindings::power() {
    return power_.get([&] {
        return along_is_periodic() ? find_row_spectra(along(), spectra_)
                                   : power_of_rows(along(), false);
    });
}

RowSpectra& BedFindings::spectra() {
    power();
    return spectra_;
}

const BedWaves& BedFindings::waves() {
    return waves_.get([&] { return bed_waves(along(), along_is_periodic()); });
}

double BedFindings::wavelength() {
    return wavelength_of_spectrum(power(), along().nx());
}

const CrestOrientation& BedFindings::orientation() {
    return orientation_.get([&] { return crest_orientation(snapshot_->bed, snapshot_->periodic); });
}

}  // namespace fumon
