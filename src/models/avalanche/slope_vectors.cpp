#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/avalanche/slope_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <algorithm>
#include <cstddef>

#include "models/avalanche/slope_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::slope_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// max(h − a, h − b, 0) as a real number.
template <class D>
HWY_INLINE hn::Vec<D> fall(D doubles, const std::int64_t* here, const std::int64_t* a,
                           const std::int64_t* b) {
    const hn::RebindToSigned<D> whole;
    const auto h = hn::LoadU(whole, here);
    const auto to_a = hn::ConvertTo(doubles, hn::Sub(h, hn::LoadU(whole, a)));
    const auto to_b = hn::ConvertTo(doubles, hn::Sub(h, hn::LoadU(whole, b)));
    return greater(greater(to_a, to_b), hn::Zero(doubles));
}

void mark_steep(const std::int64_t* south, const std::int64_t* here, const std::int64_t* north,
                double wx, double wy, double limit, int count, std::uint64_t* bits) {
    constexpr std::size_t word_bits = 64;
    const auto cells = static_cast<std::size_t>(count);
    std::fill_n(bits, (cells + word_bits - 1) / word_bits, std::uint64_t{0});
    if (count < 3) return;
    const auto loop = [&](auto doubles, std::size_t at) HWY_ATTR {
        const std::size_t x = at + 1;
        const auto along = fall(doubles, here + x, here + x - 1, here + x + 1);
        const auto across = fall(doubles, here + x, south + x, north + x);
        const auto square = hn::Add(hn::Mul(hn::Mul(along, along), hn::Set(doubles, wx)),
                                    hn::Mul(hn::Mul(across, across), hn::Set(doubles, wy)));
        const auto steep = hn::Gt(square, hn::Set(doubles, limit));
        if (hn::AllFalse(doubles, steep)) return;
        HWY_ALIGN std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(doubles, steep, bytes);
        const std::uint64_t found = bytes[0];
        const std::size_t shift = x % word_bits;
        bits[x / word_bits] |= found << shift;
        if (shift + hn::Lanes(doubles) > word_bits)
            bits[x / word_bits + 1] |= found >> (word_bits - shift);
    };
    for_each_vector(count - 2, loop);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::slope_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::slope_vectors {

HWY_EXPORT(mark_steep);

void mark_steep(const std::int64_t* south, const std::int64_t* here, const std::int64_t* north,
                double wx, double wy, double limit, int count, std::uint64_t* bits) {
    HWY_DYNAMIC_DISPATCH(mark_steep)(south, here, north, wx, wy, limit, count, bits);
}

}  // namespace fumon::slope_vectors
#endif
