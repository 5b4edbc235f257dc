#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/sand/creep_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <algorithm>
#include <cstddef>

#include "models/sand/creep_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::creep_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

struct CreepInside {
    const double* south;
    const double* here;
    const double* north;
    double rate;
    double* after;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto at = [d, x](const double* row, int by)
                            HWY_ATTR { return hn::LoadU(d, row + x + 1 + by); };
        const auto h = at(here, 0);
        const auto nearest = (at(here, -1) + at(here, 1)) + (at(south, 0) + at(north, 0));
        const auto diagonal = (at(south, -1) + at(north, -1)) + (at(south, 1) + at(north, 1));
        const auto mean = hn::Set(d, 1.0 / 6.0) * nearest + hn::Set(d, 1.0 / 12.0) * diagonal;
        hn::StoreU(h + hn::Set(d, rate) * (mean - h), d, after + x + 1);
    }
};

struct TakeMaxima {
    const double* south;
    const double* here;
    const double* north;
    double* sides;
    double* column;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto side = greater(hn::LoadU(d, south + x), hn::LoadU(d, north + x));
        hn::StoreU(side, d, sides + x);
        hn::StoreU(greater(side, hn::LoadU(d, here + x)), d, column + x);
    }
};

/// Bits of cells x, x + 1, … as far as a vector goes.
template <class D>
HWY_INLINE std::uint64_t peaks(D d, const double* here, const double* sides, const double* column,
                               std::size_t x) {
    const auto beside = greater(hn::LoadU(d, column + x - 1), hn::LoadU(d, column + x + 1));
    const auto around = greater(beside, hn::LoadU(d, sides + x));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(hn::LoadU(d, here + x), around), bits);
    return bits[0];
}

void creep_inside(const double* south, const double* here, const double* north, double rate,
                  int count, double* after) {
    for_each_vector(count, CreepInside{south, here, north, rate, after});
}

void mark_maxima(const double* south, const double* here, const double* north, int count,
                 double* sides, double* column, std::uint64_t* marks) {
    const hn::ScalableTag<double> d;
    const hn::CappedTag<double, 1> one;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    constexpr std::size_t bits = 64;
    ++column;  // a cell to the west of the first and one to the east of the last are read
    for_each_vector(count, TakeMaxima{south, here, north, sides, column});
    const auto cells = static_cast<std::size_t>(count);
    for (std::size_t begin = 0; begin < cells; begin += bits) {
        const std::size_t end = std::min(begin + bits, cells);
        std::uint64_t word = 0;
        std::size_t x = begin;
        for (; x + lanes <= end; x += lanes)
            word |= peaks(d, here, sides, column, x) << (x - begin);
        for (; x < end; ++x) word |= peaks(one, here, sides, column, x) << (x - begin);
        marks[begin / bits] = word;
    }
    marks[0] |= 1;
    marks[(cells - 1) / bits] |= std::uint64_t{1} << ((cells - 1) % bits);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::creep_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::creep_vectors {

HWY_EXPORT(creep_inside);
HWY_EXPORT(mark_maxima);

void creep_inside(const double* south, const double* here, const double* north, double rate,
                  int count, double* after) {
    HWY_DYNAMIC_DISPATCH(creep_inside)(south, here, north, rate, count, after);
}

void mark_maxima(const double* south, const double* here, const double* north, int count,
                 double* sides, double* column, std::uint64_t* marks) {
    HWY_DYNAMIC_DISPATCH(mark_maxima)(south, here, north, count, sides, column, marks);
}

}  // namespace fumon::creep_vectors
#endif
