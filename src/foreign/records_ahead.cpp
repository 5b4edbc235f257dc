#include "foreign/records_ahead.h"

#include <netcdf.h>

#include <algorithm>

namespace fumon {

namespace {

/// Along `records`, of a variable in chunks; 1 for others.
std::size_t records_of_chunk(const NetcdfInput& input, int variable, std::size_t along,
                             std::size_t dimensions) {
    int storage = NC_CONTIGUOUS;
    std::vector<std::size_t> chunk(dimensions, 1);
    if (nc_inq_var_chunking(input.id(), variable, &storage, chunk.data()) != NC_NOERR) return 1;
    return storage == NC_CHUNKED ? std::max<std::size_t>(1, chunk[along]) : 1;
}

/// Whether a single-precision number holds each of its values.
bool fits_in_float(int type) {
    return type == NC_FLOAT || type == NC_SHORT || type == NC_USHORT || type == NC_BYTE ||
           type == NC_UBYTE;
}

}  // namespace

void RecordsAhead::read(const NetcdfInput& input, int variable, int records,
                        std::span<const std::size_t> start, std::span<const std::size_t> count,
                        double* values) {
    const std::vector<int> over = input.dimensions(variable);
    const auto along = static_cast<std::size_t>(std::ranges::find(over, records) - over.begin());
    std::size_t cells = 1;
    for (const std::size_t one : count) cells *= one;
    const bool outermost = along == 0 && !over.empty() && count[0] == 1;
    const std::size_t chunk = outermost ? records_of_chunk(input, variable, along, over.size()) : 1;
    const bool single = fits_in_float(input.type(variable));
    const std::size_t bytes = cells * (single ? sizeof(float) : sizeof(double));
    const std::size_t room = most_bytes_ / std::max<std::size_t>(1, bytes);
    if (chunk < 2 || room < 2) {
        ++records_read_;
        return check_netcdf(
            nc_get_vara_double(input.id(), variable, start.data(), count.data(), values));
    }
    const std::size_t record = start[along];
    const bool known = file_ == input.name() && record >= first_ && record < first_ + kept_ &&
                       (single ? singles_.size() : doubles_.size()) == kept_ * cells;
    if (!known) {
        const std::size_t end =
            std::min(input.dimension_length(records), (record / chunk + 1) * chunk);
        const std::size_t wanted = std::min(end - record, room);
        std::vector<std::size_t> all(count.begin(), count.end());
        all[along] = wanted;
        kept_ = 0;
        singles_.resize(single ? wanted * cells : 0);
        doubles_.resize(single ? 0 : wanted * cells);
        check_netcdf(single ? nc_get_vara_float(input.id(), variable, start.data(), all.data(),
                                                singles_.data())
                            : nc_get_vara_double(input.id(), variable, start.data(), all.data(),
                                                 doubles_.data()));
        file_ = input.name();
        first_ = record;
        kept_ = wanted;
        records_read_ += wanted;
    }
    const auto from = static_cast<std::ptrdiff_t>((record - first_) * cells);
    if (single) {
        std::copy_n(singles_.begin() + from, cells, values);
    } else {
        std::copy_n(doubles_.begin() + from, cells, values);
    }
}

}  // namespace fumon
