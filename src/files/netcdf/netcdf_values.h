#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "base/sha256.h"

namespace fumon {

/// Takes the values of a fields file's records, in their order: puts them into a NetCDF file, or
/// into none, and hashes them as little-endian float64 and int64. Throws NetcdfFault; the caller
/// holds the NetcdfLock.
class RecordValues {
  public:
    /// `hash` goes on with them, and outlives this. Without a file they are only hashed.
    RecordValues(std::optional<int> file, Sha256Stream& hash) : file_(file), hash_(hash) {}

    /// Doubles from `start`, so many along each dimension of the variable.
    void put(int variable, std::span<const std::size_t> start, std::span<const std::size_t> count,
             const double* values);
    void put(int variable, std::size_t record, double value);
    void put(int variable, std::size_t record, long long value);
    /// A number that follows from others of its record: put, and not hashed.
    void put_derived(int variable, std::size_t record, double value) const;

  private:
    std::optional<int> file_;
    Sha256Stream& hash_;
};

}  // namespace fumon
