#include "app/measurement_file.h"

#include <fmt/format.h>

#include <cmath>

namespace fumon {

MeasurementFile::MeasurementFile(const std::filesystem::path& file, Landform landform)
    : file_(file), suite_(landform) {
    std::string header = "step,time";
    for (const MeasureColumn& column : suite_.columns()) header += "," + column.name;
    file_.write(header + "\n");
}

void MeasurementFile::add(const Snapshot& snapshot) {
    std::string line = fmt::format("{},{}", snapshot.step, snapshot.time);
    for (const double value : suite_.row(snapshot))
        line += std::isnan(value) ? "," : fmt::format(",{}", value);
    file_.write(line + "\n");
}

}  // namespace fumon
