#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "files/netcdf/netcdf_input.h"

namespace fumon {

/// Records of a variable whose chunks hold several of them. Each chunk is decompressed as a whole
/// whatever is read of it, so the rest of its records is kept until they are asked for, within a
/// bound.
class RecordsAhead {
  public:
    /// Bytes that are kept at most.
    static constexpr std::size_t most_bytes = std::size_t{64} << 20U;

    explicit RecordsAhead(std::size_t bytes = most_bytes) : most_bytes_(bytes) {}

    /// Values from `start`, so many along each dimension, of which `records` is one that has one
    /// record of them: as nc_get_vara_double() reads them. Throws NetcdfFault; the caller holds
    /// the NetcdfLock.
    void read(const NetcdfInput& input, int variable, int records,
              std::span<const std::size_t> start, std::span<const std::size_t> count,
              double* values);

    /// How many records the library has been asked for.
    [[nodiscard]] std::size_t records_read() const { return records_read_; }

  private:
    std::size_t most_bytes_;
    std::string file_;
    std::size_t first_ = 0;
    std::size_t kept_ = 0;         ///< records
    std::vector<float> singles_;   ///< record after record, of what single precision holds
    std::vector<double> doubles_;  ///< likewise, of other variables
    std::size_t records_read_ = 0;
};

}  // namespace fumon
