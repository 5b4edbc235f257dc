#include "files/netcdf/netcdf_values.h"

#include <netcdf.h>

#include <array>
#include <bit>
#include <cstdint>

#include "files/netcdf/netcdf_calls.h"

namespace fumon {

void RecordValues::put(int variable, std::span<const std::size_t> start,
                       std::span<const std::size_t> count, const double* values) {
    std::size_t all = 1;
    for (const std::size_t along : count) all *= along;
    if (file_)
        check_netcdf(nc_put_vara_double(*file_, variable, start.data(), count.data(), values));
    if constexpr (std::endian::native == std::endian::little) {
        hash_.add(values, all * sizeof(double));
    } else {
        for (const double value : std::span(values, all))
            hash_.add_little_endian(std::bit_cast<std::uint64_t>(value));
    }
}

void RecordValues::put(int variable, std::size_t record, double value) {
    const std::array<std::size_t, 1> one{1};
    put(variable, std::span(&record, 1), one, &value);
}

void RecordValues::put_derived(int variable, std::size_t record, double value) const {
    if (file_) check_netcdf(nc_put_var1_double(*file_, variable, &record, &value));
}

void RecordValues::put(int variable, std::size_t record, long long value) {
    if (file_) check_netcdf(nc_put_var1_longlong(*file_, variable, &record, &value));
    hash_.add_little_endian(static_cast<std::uint64_t>(value));
}

}  // namespace fumon
