#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>

#include "base/error.h"
#include "files/active_library.h"

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
    ActiveLibrary at_work_;
};

/// A call of the NetCDF library failed: its own words, without the file's name, which the writers
/// and readers add.
class NetcdfFault : public Error {
  public:
    using Error::Error;
};

/// Throws NetcdfFault where a call's status is not NC_NOERR.
void check_netcdf(int status);

/// A file that the NetCDF library has open. Whoever calls any of this holds the NetcdfLock.
///
/// Where the device fails as HDF5 closes a file, the NetCDF library prints what HDF5 has open and
/// looks into what is closed already, a crash. So HDF5's own handle is held for as long as the
/// library's, and closed behind it.
class NetcdfHandle {
  public:
    /// Throws NetcdfFault where the file cannot be made or opened.
    static NetcdfHandle create(const std::filesystem::path& file);
    static NetcdfHandle open_to_read(const std::filesystem::path& file);

    NetcdfHandle() = default;
    NetcdfHandle(NetcdfHandle&& other) noexcept;
    NetcdfHandle& operator=(NetcdfHandle&& other) noexcept;
    ~NetcdfHandle() { (void)close(); }

    [[nodiscard]] int id() const { return id_; }
    [[nodiscard]] bool is_open() const { return id_ >= 0; }
    /// Whether all that was written has reached the file. Closing twice is as once.
    [[nodiscard]] bool close();

  private:
    int id_ = -1;
    std::int64_t hdf5_ = -1;  ///< HDF5's handle; −1: a classic file
};

}  // namespace fumon
