#include "files/netcdf/netcdf_classic.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

namespace fumon {

namespace {

/// Reads a header's big-endian numbers from the file's start on; `good` turns false at its end and
/// at numbers no file can hold.
class HeaderReader {
  public:
    explicit HeaderReader(const std::filesystem::path& file) : in_(file, std::ios::binary) {}

    [[nodiscard]] bool good() const { return good_ && in_.good(); }

    std::uint64_t number(int bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < bytes; ++i) {
            const int byte = in_.get();
            value = value << 8 | static_cast<std::uint64_t>(byte & 0xFF);
        }
        return value;
    }

    /// A number of things that are still to come.
    std::uint64_t count(int bytes) {
        constexpr std::uint64_t most = std::uint64_t{1} << 31;
        const std::uint64_t value = number(bytes);
        if (value > most) good_ = false;
        return good() ? value : 0;
    }

    /// Of an attribute or variable: NC_BYTE …
    std::uint64_t type() {
        const std::uint64_t value = number(4);
        if (good() && (value < NC_BYTE || value > NC_UINT64)) types_known_ = false;
        return value;
    }

    [[nodiscard]] bool types_known() const { return types_known_; }

    void skip(std::uint64_t bytes) { in_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur); }

  private:
    std::ifstream in_;
    bool good_ = true;
    bool types_known_ = true;
};

std::uint64_t bytes_of_type(std::uint64_t type) {
    switch (type) {
        case NC_BYTE:
        case NC_CHAR:
        case NC_UBYTE:
            return 1;
        case NC_SHORT:
        case NC_USHORT:
            return 2;
        case NC_INT:
        case NC_UINT:
        case NC_FLOAT:
            return 4;
        default:
            return 8;
    }
}

std::uint64_t padded(std::uint64_t bytes) {
    return (bytes + 3) / 4 * 4;
}

/// A multiplication that stays at the largest number where it would go beyond.
std::uint64_t times(std::uint64_t a, std::uint64_t b) {
    std::uint64_t product = 0;
    return __builtin_mul_overflow(a, b, &product) ? UINT64_MAX / 4 : product;
}

struct Variable {
    bool has_records = false;
    bool sound = true;        ///< its dimensions are there, and only the first may be the records'
    std::uint64_t bytes = 0;  ///< all of it, or one record of it
    std::uint64_t begin = 0;
};

void skip_attributes(HeaderReader& header, int width) {
    header.number(4);  // the list's tag
    const std::uint64_t count = header.count(width);
    for (std::uint64_t i = 0; i < count && header.good(); ++i) {
        header.skip(padded(header.count(width)));  // its name
        const std::uint64_t type = header.type();
        header.skip(padded(header.count(width) * bytes_of_type(type)));
    }
}

Variable read_variable(HeaderReader& header, int width, int offset_width,
                       const std::vector<std::uint64_t>& lengths) {
    Variable variable;
    variable.bytes = 1;
    header.skip(padded(header.count(width)));
    const std::uint64_t rank = header.count(width);
    for (std::uint64_t i = 0; i < rank && header.good(); ++i) {
        const std::uint64_t dimension = header.number(width);
        const std::uint64_t length = dimension < lengths.size() ? lengths[dimension] : 0;
        const bool wrong = dimension >= lengths.size() || (i > 0 && length == 0);
        if (wrong && header.good()) variable.sound = false;
        if (i == 0 && length == 0) {
            variable.has_records = true;
        } else {
            variable.bytes = times(variable.bytes, length);
        }
    }
    skip_attributes(header, width);
    variable.bytes = times(variable.bytes, bytes_of_type(header.type()));
    header.number(width);  // its size, which large variables cannot tell
    variable.begin = header.number(offset_width);
    return variable;
}

/// The length that a classic file must have at least; nothing for other files.
std::optional<std::uint64_t> needed_length(const std::filesystem::path& file) {
    HeaderReader header(file);
    if (header.number(3) != 0x434446) return std::nullopt;  // "CDF"
    const std::uint64_t version = header.number(1);
    if (version != 1 && version != 2 && version != 5) return std::nullopt;
    const int width = version == 5 ? 8 : 4;         // bytes of a count
    const int offset_width = version == 1 ? 4 : 8;  // bytes of a place in the file
    std::uint64_t records = header.number(width);
    const bool streaming = records == (width == 4 ? UINT32_MAX : UINT64_MAX);
    if (streaming) records = 0;  // to be told from the file's length

    header.number(4);
    std::vector<std::uint64_t> lengths;
    const std::uint64_t dimensions = header.count(width);
    for (std::uint64_t i = 0; i < dimensions && header.good(); ++i) {
        header.skip(padded(header.count(width)));
        lengths.push_back(header.number(width));
    }
    skip_attributes(header, width);
    header.number(4);
    std::vector<Variable> variables;
    const std::uint64_t count = header.count(width);
    for (std::uint64_t i = 0; i < count && header.good(); ++i)
        variables.push_back(read_variable(header, width, offset_width, lengths));
    // The library divides by such lengths, and by the size of such types.
    if (!header.types_known() || !std::ranges::all_of(variables, &Variable::sound))
        throw InputError(
            fmt::format("{}: it has an element of unknown type, or with a missing or empty "
                        "dimension; it is damaged: copy it again",
                        file.string()));
    if (!header.good()) return UINT64_MAX;  // it ends within its header

    std::uint64_t record_bytes = 0;
    std::uint64_t with_records = 0;
    for (const Variable& variable : variables) {
        if (!variable.has_records) continue;
        ++with_records;
        record_bytes += padded(variable.bytes);
    }
    std::uint64_t needed = 0;
    for (const Variable& variable : variables) {
        if (variable.has_records && records == 0) continue;
        // A lone record variable is not padded.
        const std::uint64_t stride = with_records == 1 ? variable.bytes : record_bytes;
        const std::uint64_t before = variable.has_records ? times(records - 1, stride) : 0;
        needed = std::max(needed, variable.begin + before + variable.bytes);
    }
    return needed;
}

}  // namespace

void refuse_damaged_classic_file(const std::filesystem::path& file) {
    const auto needed = needed_length(file);
    std::error_code fault;
    const std::uintmax_t length = std::filesystem::file_size(file, fault);
    if (!needed || fault || length >= *needed) return;
    if (*needed == UINT64_MAX)
        throw InputError(fmt::format(
            "{}: ends within its header, after {} bytes; it is damaged or cut short: copy it again",
            file.string(), length));
    throw InputError(
        fmt::format("{}: has {} bytes, but its header needs {}; it is cut short: copy it again",
                    file.string(), length, *needed));
}

}  // namespace fumon
