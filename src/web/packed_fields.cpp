#include "web/packed_fields.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

using Numbers = std::vector<std::uint16_t>;

constexpr int predictors = 3;

std::string squeezed(const std::string& bytes, int level) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), &libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    std::string made(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    made.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), made.data(),
                                         made.size()));
    return made;
}

std::uint16_t wrapped(int number) {
    return static_cast<std::uint16_t>(static_cast<unsigned>(number) & 0xFFFFU);
}

/// What a number is expected to be, from those that stand before it.
int expected(const Numbers& numbers, std::size_t at, int x, int y, int nx, int predictor) {
    if (predictor == 0) return 0;
    const auto row = static_cast<std::size_t>(nx);
    const int west = x > 0 ? numbers[at - 1] : 0;
    const int south = y > 0 ? numbers[at - row] : 0;
    if (x == 0 || y == 0) return west + south;
    return predictor == 1 ? west + south - numbers[at - row - 1] : (west + south) / 2;
}

/// The bytes before deflation.
std::string remainders(const Numbers& numbers, int nx, int ny, int predictor) {
    std::string bytes(2 * numbers.size(), '\0');
    std::size_t at = 0;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x, ++at) {
            const std::uint16_t rest =
                wrapped(numbers[at] - expected(numbers, at, x, y, nx, predictor));
            const unsigned sign = (rest & 0x8000U) != 0 ? 0xFFFFU : 0U;
            const unsigned folded = ((static_cast<unsigned>(rest) << 1U) ^ sign) & 0xFFFFU;
            bytes[at] = static_cast<char>(folded >> 8U);
            bytes[numbers.size() + at] = static_cast<char>(folded & 0xFFU);
        }
    }
    return bytes;
}

Numbers in_steps(const Field<float>& field, double low, double step) {
    Numbers numbers;
    numbers.reserve(field.size());
    for (const float value : field.values()) {
        const double at = std::round((static_cast<double>(value) - low) / step);
        numbers.push_back(static_cast<std::uint16_t>(std::clamp(at, 0.0, 65535.0)));
    }
    return numbers;
}

Numbers difference(const Numbers& numbers, const Numbers& previous) {
    Numbers all(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) all[i] = wrapped(numbers[i] - previous[i]);
    return all;
}

/// The shortest of all ways to pack a field.
PackedField shortest(const Numbers& numbers, const Numbers& previous, int nx, int ny) {
    constexpr int quick = 4;
    constexpr int thorough = 12;
    PackedField best;
    std::string kept;
    std::size_t least = 0;
    for (const bool over : {false, true}) {
        if (over && previous.empty()) break;
        const Numbers packed = over ? difference(numbers, previous) : numbers;
        for (int predictor = 0; predictor < predictors; ++predictor) {
            std::string bytes = remainders(packed, nx, ny, predictor);
            const std::size_t size = squeezed(bytes, quick).size();
            if (!kept.empty() && size >= least) continue;
            least = size;
            kept = std::move(bytes);
            best.over_previous = over;
            best.predictor = predictor;
        }
    }
    best.bytes = squeezed(kept, thorough);
    return best;
}

PackedFields packed_in(const std::vector<Field<float>>& fields, double low, double step) {
    PackedFields packed{low, step, {}};
    Numbers previous;
    for (const Field<float>& field : fields) {
        Numbers numbers = in_steps(field, low, step);
        packed.fields.push_back(shortest(numbers, previous, field.nx(), field.ny()));
        previous = std::move(numbers);
    }
    return packed;
}

}  // namespace

PackedFields packed_fields(const std::vector<Field<float>>& fields, double most_bytes) {
    float low = 0.0F;
    float high = 0.0F;
    double values = 0.0;
    bool any = false;
    for (const Field<float>& field : fields) {
        for (const float value : field.values()) {
            low = any ? std::min(low, value) : value;
            high = any ? std::max(high, value) : value;
            any = true;
        }
        values += static_cast<double>(field.size());
    }
    const double range = high > low ? static_cast<double>(high) - static_cast<double>(low) : 1.0;
    PackedFields packed;
    for (const double parts : {65535.0, 16383.0, 4095.0}) {
        packed = packed_in(fields, static_cast<double>(low), range / parts);
        double bytes = 0.0;
        for (const PackedField& field : packed.fields)
            bytes += static_cast<double>(field.bytes.size());
        if (bytes <= most_bytes * values) break;
    }
    return packed;
}

std::vector<Field<float>> unpacked_fields(const PackedFields& packed, int nx, int ny) {
    std::vector<Field<float>> fields;
    Numbers previous;
    const std::size_t size = static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny);
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
    if (!decompressor) throw std::bad_alloc();
    for (const PackedField& field : packed.fields) {
        std::string bytes(2 * size, '\0');
        if (libdeflate_zlib_decompress(decompressor.get(), field.bytes.data(), field.bytes.size(),
                                       bytes.data(), bytes.size(), nullptr) != LIBDEFLATE_SUCCESS)
            throw Error("a packed field is damaged");
        Numbers numbers(size);
        std::size_t at = 0;
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x, ++at) {
                const unsigned folded = static_cast<unsigned>(static_cast<unsigned char>(bytes[at]))
                                            << 8U |
                                        static_cast<unsigned char>(bytes[size + at]);
                const int rest = static_cast<int>(folded >> 1U) ^ -static_cast<int>(folded & 1U);
                numbers[at] = wrapped(expected(numbers, at, x, y, nx, field.predictor) + rest);
            }
        }
        if (field.over_previous) {
            for (std::size_t i = 0; i < size; ++i) numbers[i] = wrapped(numbers[i] + previous[i]);
        }
        Field<float> values(nx, ny);
        for (std::size_t i = 0; i < size; ++i)
            values.values()[i] = static_cast<float>(packed.low + packed.step * numbers[i]);
        fields.push_back(std::move(values));
        previous = std::move(numbers);
    }
    return fields;
}

}  // namespace fumon
