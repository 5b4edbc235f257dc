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

/// Calls body(doubles, x, bits) for vectors of cells within a word of cells that the bits of
/// `words` name, from cell 1 to count − 2; the bits that are left go to `left`.
template <class Body>
HWY_INLINE void for_cells(const std::uint64_t* words, int count, std::uint64_t* left,
                          const Body& body) {
    constexpr std::size_t word_bits = 64;
    const hn::ScalableTag<double> doubles;
    const std::size_t lanes = hn::Lanes(doubles);
    const std::uint64_t of_vector = (std::uint64_t{1} << lanes) - 1;
    const auto cells = static_cast<std::size_t>(count);
    for (std::size_t w = 0; w * word_bits < cells; ++w) {
        left[w] = 0;
        if (words[w] == 0) continue;
        for (std::size_t shift = 0; shift < word_bits; shift += lanes) {
            const std::uint64_t bits = (words[w] >> shift) & of_vector;
            if (bits == 0) continue;
            const std::size_t x = w * word_bits + shift;
            if (x == 0 || x + lanes >= cells) {
                left[w] |= bits << shift;
            } else {
                left[w] |= body(doubles, x, bits) << shift;
            }
        }
    }
}

template <class D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint64_t bits) {
    HWY_ALIGN std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
    return hn::LoadMaskBits(d, bytes);
}

template <class D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
    HWY_ALIGN std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0];
}

void slide(const SlideRows& rows, const SlideRule& rule, int count, const std::uint64_t* candidates,
           const Slides& slides, std::uint64_t* left) {
    for_cells(
        candidates, count, left, [&](auto doubles, std::size_t x, std::uint64_t bits) HWY_ATTR {
            constexpr std::size_t word_bits = 64;
            const hn::RebindToSigned<decltype(doubles)> whole;
            const auto h = hn::LoadU(whole, rows.here + x);
            const auto to_west = hn::Sub(h, hn::LoadU(whole, rows.here + x - 1));
            const auto to_east = hn::Sub(h, hn::LoadU(whole, rows.here + x + 1));
            const auto to_south = hn::Sub(h, hn::LoadU(whole, rows.south + x));
            const auto to_north = hn::Sub(h, hn::LoadU(whole, rows.north + x));
            const auto zero = hn::Zero(doubles);
            const auto real = [&](auto value) HWY_ATTR { return hn::ConvertTo(doubles, value); };
            const auto fall_x = greater(greater(real(to_west), real(to_east)), zero);
            const auto fall_y = greater(greater(real(to_south), real(to_north)), zero);
            const auto a = hn::Mul(fall_x, hn::Set(doubles, rule.slope_of_unit_x));
            const auto b = hn::Mul(fall_y, hn::Set(doubles, rule.slope_of_unit_y));
            const auto square = hn::Add(hn::Mul(a, a), hn::Mul(b, b));
            const auto rest = rows.tangents == nullptr ? hn::Set(doubles, rule.tangent)
                                                       : hn::LoadU(doubles, rows.tangents + x);
            const auto start = hn::Mul(rest, hn::Set(doubles, rule.start_ratio));
            const auto loose = hn::Sub(h, hn::LoadU(whole, rows.floor + x));
            auto slides_here =
                hn::And(hn::Gt(square, hn::Mul(start, start)), mask_of(doubles, bits));
            slides_here = hn::And(slides_here, hn::Gt(square, hn::Set(doubles, rule.least_square)));
            slides_here =
                hn::And(slides_here, hn::RebindMask(doubles, hn::Gt(loose, hn::Zero(whole))));
            if (hn::AllFalse(doubles, slides_here)) return std::uint64_t{0};
            const auto one = hn::Set(doubles, 1.0);
            const auto safe = hn::IfThenElse(slides_here, square, one);
            const auto share =
                hn::Mul(hn::Set(doubles, rule.share), hn::Sub(one, hn::Div(rest, hn::Sqrt(safe))));
            const auto along =
                hn::ConvertTo(whole, hn::IfThenElseZero(slides_here, hn::Mul(fall_x, share)));
            const auto across =
                hn::ConvertTo(whole, hn::IfThenElseZero(slides_here, hn::Mul(fall_y, share)));
            const auto scarce = hn::And(
                slides_here, hn::RebindMask(doubles, hn::Gt(hn::Add(along, across), loose)));
            const auto moves = hn::AndNot(
                scarce, hn::And(slides_here, hn::RebindMask(doubles, hn::Gt(hn::Add(along, across),
                                                                            hn::Zero(whole)))));
            const auto signed_way = [&](auto amount, auto to_low, auto to_high) HWY_ATTR {
                return hn::IfThenElse(hn::Lt(to_high, to_low), hn::Neg(amount), amount);
            };
            hn::StoreU(signed_way(along, to_west, to_east), whole, slides.x + x);
            hn::StoreU(signed_way(across, to_south, to_north), whole, slides.y + x);
            slides.sliding[x / word_bits] |= bits_of(doubles, moves) << (x % word_bits);
            return bits_of(doubles, scarce);
        });
}

void settle(const SettledRows& rows, int count, const std::uint64_t* candidates,
            std::int64_t* surface, std::uint64_t* left) {
    for_cells(candidates, count, left, [&](auto doubles, std::size_t x, std::uint64_t) HWY_ATTR {
        constexpr std::size_t word_bits = 64;
        const hn::RebindToSigned<decltype(doubles)> whole;
        const std::size_t w = x / word_bits;
        const std::size_t shift = x % word_bits;
        const auto zero = hn::Zero(whole);
        const auto of = [&](const std::uint64_t* words, auto values) HWY_ATTR {
            return hn::IfThenElseZero(mask_of(whole, (words[w] >> shift) & 0xFFU), values);
        };
        const auto at = [&](const std::int64_t* values)
                            HWY_ATTR { return hn::LoadU(whole, values + x); };
        const auto positive = [&](auto values) HWY_ATTR {
            return hn::IfThenElseZero(hn::Gt(values, zero), values);
        };
        const auto absolute = [&](auto values) HWY_ATTR {
            return hn::IfThenElse(hn::Lt(values, zero), hn::Neg(values), values);
        };
        auto change =
            of(rows.sliding, hn::Neg(hn::Add(absolute(at(rows.x)), absolute(at(rows.y)))));
        change = hn::Add(change, of(rows.from_west, positive(at(rows.x - 1))));
        change = hn::Add(change, of(rows.from_east, positive(hn::Neg(at(rows.x + 1)))));
        change = hn::Add(change, of(rows.from_south, positive(at(rows.y_south))));
        change = hn::Add(change, of(rows.from_north, positive(hn::Neg(at(rows.y_north)))));
        hn::StoreU(hn::Add(at(surface), change), whole, surface + x);
        return std::uint64_t{0};
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::slope_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::slope_vectors {

HWY_EXPORT(mark_steep);
HWY_EXPORT(slide);
HWY_EXPORT(settle);

void slide(const SlideRows& rows, const SlideRule& rule, int count, const std::uint64_t* candidates,
           const Slides& slides, std::uint64_t* left) {
    HWY_DYNAMIC_DISPATCH(slide)(rows, rule, count, candidates, slides, left);
}

void settle(const SettledRows& rows, int count, const std::uint64_t* candidates,
            std::int64_t* surface, std::uint64_t* left) {
    HWY_DYNAMIC_DISPATCH(settle)(rows, count, candidates, surface, left);
}

void mark_steep(const std::int64_t* south, const std::int64_t* here, const std::int64_t* north,
                double wx, double wy, double limit, int count, std::uint64_t* bits) {
    HWY_DYNAMIC_DISPATCH(mark_steep)(south, here, north, wx, wy, limit, count, bits);
}

}  // namespace fumon::slope_vectors
#endif
