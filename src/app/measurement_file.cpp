#include "app/measurement_file.h"

#include <fmt/format.h>

#include "measure/bed_statistics.h"

namespace fumon {

MeasurementFile::MeasurementFile(const std::filesystem::path& file) : file_(file) {
    file_.write(
        "step,time,mean_height,standard_deviation,minimum_height,maximum_height,total_sand\n");
}

void MeasurementFile::add(const Snapshot& snapshot) {
    const BedStatistics bed = bed_statistics(snapshot.bed, snapshot.nodata);
    file_.write(fmt::format("{},{},{},{},{},{},{}\n", snapshot.step, snapshot.time, bed.mean,
                            bed.standard_deviation, bed.minimum, bed.maximum, bed.total));
}

}  // namespace fumon
