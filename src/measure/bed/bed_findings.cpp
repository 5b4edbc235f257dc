#include "measure/bed/bed_findings.h"

#include "measure/bed/wavelength.h"

namespace fumon {

void BedFindings::begin(const Snapshot& snapshot) {
    snapshot_ = &snapshot;
    wind_ = downwind(snapshot);
    turned_.reset();
    statistics_.reset();
    power_.reset();
    waves_.reset();
    orientation_.reset();
}

const Grid& BedFindings::along() {
    const HorizontalDirection direction = wind_.value_or(HorizontalDirection{});
    if (direction.is_east()) return snapshot_->bed;
    if (!turned_) turned_ = bed_along_wind(*snapshot_, direction);
    return turned_->bed;
}

bool BedFindings::along_is_periodic() {
    along();
    return turned_ ? turned_->periodic : snapshot_->periodic;
}

const BedStatistics& BedFindings::statistics() {
    if (!statistics_) statistics_ = bed_statistics(snapshot_->bed, snapshot_->nodata);
    return *statistics_;
}

const RowPower& BedFindings::power() {
    if (!power_) power_ = power_of_rows(along(), along_is_periodic());
    return *power_;
}

const BedWaves& BedFindings::waves() {
    if (!waves_) waves_ = bed_waves(along(), along_is_periodic());
    return *waves_;
}

double BedFindings::wavelength() {
    return wavelength_of_spectrum(power(), along().nx());
}

const CrestOrientation& BedFindings::orientation() {
    if (!orientation_) orientation_ = crest_orientation(snapshot_->bed, snapshot_->periodic);
    return *orientation_;
}

}  // namespace fumon
