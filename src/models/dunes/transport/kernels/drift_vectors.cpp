#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/dunes/transport/kernels/drift_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include "models/dunes/transport/kernels/drift_vectors.h"
#include "vectors/integers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::drift_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Wholes = hn::RebindToSigned<Doubles>;

/// Whole numbers below 2⁵¹ as reals. Few targets have an instruction for it: beside 3·2⁵¹ the next
/// real number is one more.
template <class D>
HWY_INLINE hn::Vec<D> real_of(D doubles, hn::Vec<hn::RebindToSigned<D>> number) {
#if HWY_TARGET <= HWY_AVX3
    return hn::ConvertTo(doubles, number);
#else
    const hn::RebindToSigned<D> whole;
    const auto moved = hn::Add(number, hn::Set(whole, vectors::HWY_NAMESPACE::integer_offset_bits));
    return hn::Sub(hn::BitCast(doubles, moved),
                   hn::Set(doubles, vectors::HWY_NAMESPACE::integer_offset));
#endif
}

/// Reals below 2⁵¹ as whole numbers, toward zero.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> whole_of(D doubles, hn::Vec<D> number) {
    const hn::RebindToSigned<D> whole;
#if HWY_TARGET <= HWY_AVX3
    (void)doubles;
    return hn::ConvertTo(whole, number);
#else
    const auto moved =
        hn::Add(hn::Trunc(number), hn::Set(doubles, vectors::HWY_NAMESPACE::integer_offset));
    return hn::Sub(hn::BitCast(whole, moved),
                   hn::Set(whole, vectors::HWY_NAMESPACE::integer_offset_bits));
#endif
}

/// Calls loop(tag, x) for whole vectors of cells, then cell by cell.
template <class Loop>
HWY_INLINE void for_cells(std::size_t begin, std::size_t end, const Loop& loop) {
    const Doubles doubles;
    const hn::CappedTag<double, 1> one;
    std::size_t x = begin;
    for (; x + hn::Lanes(doubles) <= end; x += hn::Lanes(doubles)) loop(doubles, x);
#pragma GCC unroll 1
    for (; x < end; ++x) loop(one, x);
}

void spread(const std::int64_t* amounts, std::size_t count, const std::array<double, 3>& along,
            const std::array<double, 3>& across, Pieces& pieces) {
    constexpr std::size_t middle = 4;
    for_cells(0, count, [&](auto d, std::size_t x) HWY_ATTR {
        const hn::RebindToSigned<decltype(d)> whole;
        const auto amount = hn::LoadU(whole, amounts + x);
        const auto real = real_of(d, amount);
        auto rest = amount;
        for (std::size_t j = 0; j < 3; ++j) {
            const auto of_row = hn::Mul(real, hn::Set(d, across[j]));
            for (std::size_t i = 0; i < 3; ++i) {
                if (3 * j + i == middle) continue;
                const auto piece = whole_of(d, hn::Mul(of_row, hn::Set(d, along[i])));
                hn::StoreU(piece, whole, pieces.rows[3 * j + i].data() + margin + x);
                rest = hn::Sub(rest, piece);
            }
        }
        hn::StoreU(rest, whole, pieces.rows[middle].data() + margin + x);
    });
    for (auto& row : pieces.rows) {
        for (std::size_t k = 0; k < margin; ++k) row[margin + count + k] = 0;
    }
}

void add(const Pieces& pieces, std::size_t j, std::size_t first, std::size_t cells,
         std::int64_t* to) {
    const std::int64_t* west = pieces.rows[3 * j].data() + margin + first;
    const std::int64_t* middle = pieces.rows[3 * j + 1].data() + margin + first - 1;
    const std::int64_t* east = pieces.rows[3 * j + 2].data() + margin + first - 2;
    for_cells(0, cells, [&](auto d, std::size_t x) HWY_ATTR {
        const hn::RebindToSigned<decltype(d)> whole;
        const auto sum = hn::Add(hn::Add(hn::LoadU(whole, west + x), hn::LoadU(whole, middle + x)),
                                 hn::LoadU(whole, east + x));
        hn::StoreU(hn::Add(hn::LoadU(whole, to + x), sum), whole, to + x);
    });
}

/// A quarter, toward zero.
template <class V>
HWY_INLINE V quarter(V number) {
    const hn::DFromV<V> whole;
    const auto up = hn::IfThenElseZero(hn::Lt(number, hn::Zero(whole)), hn::Set(whole, 3));
    return hn::ShiftRight<2>(hn::Add(number, up));
}

void drift_down(const Slopes& row, std::size_t begin, std::size_t end, double share_x,
                double share_y, std::int64_t* after) {
    for_cells(begin, end, [&](auto d, std::size_t x) HWY_ATTR {
        const hn::RebindToSigned<decltype(d)> whole;
        const auto here = hn::LoadU(whole, row.surface + x);
        const auto most_here = quarter(hn::Sub(here, hn::LoadU(whole, row.rock + x)));
        const auto got = [&](const std::int64_t* surface, const std::int64_t* rock,
                             double share) HWY_ATTR {
            const auto there = hn::LoadU(whole, surface);
            const auto most_there = quarter(hn::Sub(there, hn::LoadU(whole, rock)));
            const auto is_higher = hn::Gt(there, here);
            const auto difference = hn::Abs(hn::Sub(there, here));
            const auto wanted = whole_of(d, hn::Mul(hn::Set(d, share), real_of(d, difference)));
            const auto given = hn::Min(wanted, hn::IfThenElse(is_higher, most_there, most_here));
            return hn::IfThenElse(is_higher, given, hn::Neg(given));
        };
        const auto along = hn::Add(got(row.surface + x - 1, row.rock + x - 1, share_x),
                                   got(row.surface + x + 1, row.rock + x + 1, share_x));
        const auto across = hn::Add(got(row.south_surface + x, row.south_rock + x, share_y),
                                    got(row.north_surface + x, row.north_rock + x, share_y));
        hn::StoreU(hn::Add(here, hn::Add(along, across)), whole, after + x);
    });
}

void lift(std::size_t count, double layer, double greatest, const double* shade,
          const double* shear, const std::int64_t* rock, std::int64_t* surface,
          std::int64_t* moving) {
    for_cells(0, count, [&](auto d, std::size_t x) HWY_ATTR {
        const hn::RebindToSigned<decltype(d)> whole;
        const auto one = hn::Set(d, 1.0);
        auto factor = hn::Sub(one, hn::LoadU(d, shade + x));
        if (shear != nullptr) {
            const auto stress = hn::Add(one, hn::LoadU(d, shear + x));
            factor = hn::Mul(factor, hn::Min(hn::Max(stress, hn::Zero(d)), hn::Set(d, greatest)));
        }
        const auto wanted = whole_of(d, hn::Mul(hn::Set(d, layer), factor));
        const auto here = hn::LoadU(whole, surface + x);
        const auto lifted = hn::Min(wanted, hn::Sub(here, hn::LoadU(whole, rock + x)));
        hn::StoreU(hn::Sub(here, lifted), whole, surface + x);
        hn::StoreU(hn::Add(hn::LoadU(whole, moving + x), lifted), whole, moving + x);
    });
}

void deposit(std::size_t count, const Staying& share, const double* shade, const std::int64_t* rock,
             std::int64_t* arrived, std::int64_t* surface, std::int64_t* moving,
             std::int64_t* landed) {
    for_cells(0, count, [&](auto d, std::size_t x) HWY_ATTR {
        const hn::RebindToSigned<decltype(d)> whole;
        const auto here = hn::LoadU(whole, surface + x);
        const auto sand = real_of(d, hn::Sub(here, hn::LoadU(whole, rock + x)));
        const auto cover =
            hn::Min(hn::Mul(sand, hn::Set(d, share.per_full_cover)), hn::Set(d, 1.0));
        const auto by_cover =
            hn::Add(hn::Set(d, share.on_rock), hn::Mul(hn::Set(d, share.more_on_sand), cover));
        const auto all =
            hn::Mul(hn::Max(hn::LoadU(d, shade + x), by_cover), hn::Set(d, share.landing));
        const auto came = hn::LoadU(whole, arrived + x);
        const auto stays = whole_of(d, hn::Mul(all, real_of(d, came)));
        hn::StoreU(hn::Add(here, stays), whole, surface + x);
        hn::StoreU(hn::Sub(came, stays), whole, moving + x);
        hn::StoreU(hn::Zero(whole), whole, arrived + x);
        if (landed != nullptr)
            hn::StoreU(hn::Add(hn::LoadU(whole, landed + x), came), whole, landed + x);
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::drift_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::drift_vectors {

HWY_EXPORT(spread);
HWY_EXPORT(add);
HWY_EXPORT(drift_down);
HWY_EXPORT(lift);
HWY_EXPORT(deposit);

void spread(const std::int64_t* amounts, std::size_t count, const std::array<double, 3>& along,
            const std::array<double, 3>& across, Pieces& pieces) {
    HWY_DYNAMIC_DISPATCH(spread)(amounts, count, along, across, pieces);
}

void add(const Pieces& pieces, std::size_t j, std::size_t first, std::size_t cells,
         std::int64_t* to) {
    HWY_DYNAMIC_DISPATCH(add)(pieces, j, first, cells, to);
}

void drift_down(const Slopes& row, std::size_t begin, std::size_t end, double share_x,
                double share_y, std::int64_t* after) {
    HWY_DYNAMIC_DISPATCH(drift_down)(row, begin, end, share_x, share_y, after);
}

void lift(std::size_t count, double layer, double greatest, const double* shade,
          const double* shear, const std::int64_t* rock, std::int64_t* surface,
          std::int64_t* moving) {
    HWY_DYNAMIC_DISPATCH(lift)(count, layer, greatest, shade, shear, rock, surface, moving);
}

void deposit(std::size_t count, const Staying& share, const double* shade, const std::int64_t* rock,
             std::int64_t* arrived, std::int64_t* surface, std::int64_t* moving,
             std::int64_t* landed) {
    HWY_DYNAMIC_DISPATCH(deposit)(count, share, shade, rock, arrived, surface, moving, landed);
}

}  // namespace fumon::drift_vectors
#endif
