#pragma once

#include <filesystem>

#include "files/atomic_file.h"
#include "measure/suite.h"
#include "models/model.h"

namespace fumon {

/// measurements.csv: one row a measured step, heights in model heights. It gets its name by
/// commit().
class MeasurementFile {
  public:
    /// Throws Error when it cannot be made or written.
    MeasurementFile(const std::filesystem::path& file, Landform landform);
    void add(const Snapshot& snapshot);
    void commit() { file_.commit(); }

  private:
    AtomicFile file_;
    MeasureSuite suite_;
};

}  // namespace fumon
