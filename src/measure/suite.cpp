#include "measure/suite.h"

#include "measure/bed_statistics.h"

namespace fumon {

class MeasureSuite::Parts {
  public:
    std::vector<MeasureColumn> columns;
};

MeasureSuite::MeasureSuite(const Snapshot& /*first*/) : parts_(std::make_unique<Parts>()) {
    parts_->columns = {
        {"mean_height", "heights", "mean of the bed"},
        {"standard_deviation", "heights", "of the heights over all cells"},
        {"minimum_height", "heights", "lowest cell"},
        {"maximum_height", "heights", "highest cell"},
        {"total_sand", "heights x cells", "sum of the heights"},
    };
}

MeasureSuite::~MeasureSuite() = default;

const std::vector<MeasureColumn>& MeasureSuite::columns() const {
    return parts_->columns;
}

void MeasureSuite::note(std::span<const Avalanche> /*avalanches*/) {}

std::vector<double> MeasureSuite::row(const Snapshot& snapshot) {
    const BedStatistics bed = bed_statistics(snapshot.bed, snapshot.nodata);
    return {bed.mean, bed.standard_deviation, bed.minimum, bed.maximum, bed.total};
}

}  // namespace fumon
