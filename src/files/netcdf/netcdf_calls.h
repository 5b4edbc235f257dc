#pragma once

#include <mutex>

#include "base/error.h"

namespace fumon {

/// Held around every use of the NetCDF library, which keeps its open files and HDF5's handles in
/// process-wide tables and is not thread-safe: one file is written or read at a time, whatever
/// threads they belong to. Compression happens under it too.
/// Also keeps HDF5 from printing to the standard error output of its own accord.
class NetcdfLock {
  public:
    NetcdfLock();
    NetcdfLock(const NetcdfLock&) = delete;
    NetcdfLock& operator=(const NetcdfLock&) = delete;

  private:
    std::lock_guard<std::mutex> lock_;
};

/// A call of the NetCDF library failed: its own words, without the file's name, which the writers
/// and readers add.
class NetcdfFault : public Error {
  public:
    using Error::Error;
};

/// Throws NetcdfFault where a call's status is not NC_NOERR.
void check_netcdf(int status);

}  // namespace fumon
