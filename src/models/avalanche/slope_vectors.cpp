#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/avalanche/slope_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <algorithm>
#include <cstddef>

#include "models/avalanche/slope_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/integers-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::slope_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

constexpr std::size_t word_bits = 64;

/// max(h − a, h − b, 0).
template <class V>
HWY_INLINE V fall(V here, V a, V b) {
    return hn::Sub(here, lesser(here, lesser(a, b)));
}

void mark_steep(const std::int64_t* south, const std::int64_t* here, const std::int64_t* north,
                double wx, double wy, double limit, int count, std::uint64_t* bits) {
    const auto cells = static_cast<std::size_t>(count);
    std::fill_n(bits, (cells + word_bits - 1) / word_bits, std::uint64_t{0});
    if (count < 3) return;
    const auto loop = [&](auto doubles, std::size_t at) HWY_ATTR {
        const std::size_t x = at + 1;
        const auto h = load_offset_integers(doubles, here + x);
        const auto along = fall(h, load_offset_integers(doubles, here + x - 1),
                                load_offset_integers(doubles, here + x + 1));
        const auto across = fall(h, load_offset_integers(doubles, south + x),
                                 load_offset_integers(doubles, north + x));
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
/// `words` name, from cell 1 to count − 2; bits of cells that do not lie there go to `left`. Calls
/// done(w, found) with the bits that body returned for each word.
template <class Body, class Done>
HWY_INLINE void for_cells(const std::uint64_t* words, int count, std::uint64_t* left,
                          const Body& body, const Done& done) {
    const hn::ScalableTag<double> doubles;
    const std::size_t lanes = hn::Lanes(doubles);
    const std::uint64_t of_vector = (std::uint64_t{1} << lanes) - 1;
    const auto cells = static_cast<std::size_t>(count);
    for (std::size_t w = 0; w * word_bits < cells; ++w) {
        std::uint64_t at_ends = 0;
        std::uint64_t found = 0;
        for (std::uint64_t to_do = words[w]; to_do != 0;) {
            const auto bit = static_cast<std::size_t>(__builtin_ctzll(to_do));
            const std::size_t shift = bit - bit % lanes;
            const std::uint64_t bits = (to_do >> shift) & of_vector;
            to_do &= ~(of_vector << shift);
            const std::size_t x = w * word_bits + shift;
            if (x == 0 || x + lanes >= cells) {
                at_ends |= bits << shift;
            } else {
                found |= body(doubles, x, bits) << shift;
            }
        }
        left[w] = at_ends;
        done(w, found);
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

std::int64_t slide(const SlideRows& rows, const SlideRule& rule, int count,
                   const std::uint64_t* candidates, const Slides& slides, std::uint64_t* left) {
    std::int64_t slid = 0;
    const auto body = [&](auto doubles, std::size_t x, std::uint64_t bits) HWY_ATTR {
        const auto h = load_offset_integers(doubles, rows.here + x);
        const auto west = load_offset_integers(doubles, rows.here + x - 1);
        const auto east = load_offset_integers(doubles, rows.here + x + 1);
        const auto south = load_offset_integers(doubles, rows.south + x);
        const auto north = load_offset_integers(doubles, rows.north + x);
        const auto fall_x = fall(h, west, east);
        const auto fall_y = fall(h, south, north);
        const auto a = hn::Mul(fall_x, hn::Set(doubles, rule.slope_of_unit_x));
        const auto b = hn::Mul(fall_y, hn::Set(doubles, rule.slope_of_unit_y));
        const auto square = hn::Add(hn::Mul(a, a), hn::Mul(b, b));
        const auto rest = rows.tangents == nullptr ? hn::Set(doubles, rule.tangent)
                                                   : hn::LoadU(doubles, rows.tangents + x);
        const auto start = hn::Mul(rest, hn::Set(doubles, rule.start_ratio));
        const auto zero = hn::Zero(doubles);
        auto slides_here = hn::And(hn::Gt(square, hn::Mul(start, start)), mask_of(doubles, bits));
        slides_here = hn::And(slides_here, hn::Gt(square, hn::Set(doubles, rule.least_square)));
        if (hn::AllFalse(doubles, slides_here)) {
            hn::StoreU(zero, doubles, slides.x + x);
            hn::StoreU(zero, doubles, slides.y + x);
            return std::uint64_t{0};
        }
        const auto one = hn::Set(doubles, 1.0);
        const auto safe = hn::IfThenElse(slides_here, square, one);
        const auto share =
            hn::Mul(hn::Set(doubles, rule.share), hn::Sub(one, hn::Div(rest, hn::Sqrt(safe))));
        auto along = hn::Floor(hn::IfThenElseZero(slides_here, hn::Mul(fall_x, share)));
        auto across = hn::Floor(hn::IfThenElseZero(slides_here, hn::Mul(fall_y, share)));
        const bool known = rows.highest_floor != nullptr;
        const std::size_t w = x / word_bits;
        const bool near_floor = !known || [&]() HWY_ATTR {
            const auto above = hn::Sub(h, set_offset_integer(doubles, rows.highest_floor[w]));
            const auto needed = hn::Add(hn::Add(along, across), one);
            return !hn::AllFalse(doubles, hn::And(slides_here, hn::Gt(needed, above)));
        }();
        if (near_floor) {
            const bool level = known && rows.lowest_floor[w] == rows.highest_floor[w];
            const auto floor = level ? set_offset_integer(doubles, rows.lowest_floor[w])
                                     : load_offset_integers(doubles, rows.floor + x);
            const auto loose = hn::Sub(h, floor);
            const auto some = hn::Gt(loose, zero);
            along = hn::IfThenElseZero(some, along);
            across = hn::IfThenElseZero(some, across);
            const auto scarce =
                hn::And(hn::And(slides_here, some), hn::Gt(hn::Add(along, across), loose));
            const auto of_x = hn::Div(fall_x, hn::IfThenElse(scarce, hn::Add(fall_x, fall_y), one));
            const auto less = lesser(loose, hn::Floor(hn::Mul(loose, of_x)));
            along = hn::IfThenElse(scarce, less, along);
            across = hn::IfThenElse(scarce, hn::Sub(loose, less), across);
        }
        const auto with_direction = [&](auto amount, auto low, auto high) HWY_ATTR {
            return hn::IfThenElse(hn::Gt(high, low), hn::Neg(amount), amount);
        };
        hn::StoreU(with_direction(along, west, east), doubles, slides.x + x);
        hn::StoreU(with_direction(across, south, north), doubles, slides.y + x);
        return bits_of(doubles, hn::Gt(hn::Add(along, across), zero));
    };
    for_cells(candidates, count, left, body, [&](std::size_t w, std::uint64_t found) HWY_ATTR {
        slides.sliding[w] = found;
        slid += __builtin_popcountll(found);
    });
    return slid;
}

void settle(const SettledRows& rows, int count, const std::uint64_t* candidates,
            std::int64_t* surface, std::uint64_t* left) {
    const auto body = [&](auto doubles, std::size_t x, std::uint64_t) HWY_ATTR {
        const auto at = [&](const double* slides) HWY_ATTR { return hn::LoadU(doubles, slides); };
        const auto zero = hn::Zero(doubles);
        const auto from_low = [&](auto slides) HWY_ATTR { return greater(slides, zero); };
        const auto from_high = [&](auto slides) HWY_ATTR { return lesser(slides, zero); };
        const auto lost = hn::Add(hn::Abs(at(rows.x + x)), hn::Abs(at(rows.y + x)));
        const auto along = hn::Sub(from_low(at(rows.x + x - 1)), from_high(at(rows.x + x + 1)));
        const auto across =
            hn::Sub(from_low(at(rows.y_south + x)), from_high(at(rows.y_north + x)));
        const auto change = hn::Sub(hn::Add(along, across), lost);
        store_offset_integers(hn::Add(load_offset_integers(doubles, surface + x), change),
                              surface + x);
        return std::uint64_t{0};
    };
    for_cells(candidates, count, left, body, [](std::size_t, std::uint64_t) {});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::slope_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::slope_vectors {

HWY_EXPORT(mark_steep);
HWY_EXPORT(slide);
HWY_EXPORT(settle);

std::int64_t slide(const SlideRows& rows, const SlideRule& rule, int count,
                   const std::uint64_t* candidates, const Slides& slides, std::uint64_t* left) {
    return HWY_DYNAMIC_DISPATCH(slide)(rows, rule, count, candidates, slides, left);
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
