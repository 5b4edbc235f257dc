// Whole numbers as reals and back, compiled once for each target (see vectors/target.h). Few
// targets have an instruction for it.

#if defined(FUMON_VECTORS_WHOLE_NUMBERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMON_VECTORS_WHOLE_NUMBERS_INL_H
#undef FUMON_VECTORS_WHOLE_NUMBERS_INL_H
#else
#define FUMON_VECTORS_WHOLE_NUMBERS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace fumon::vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Beside 3·2⁵¹ the next real number is one more: a whole number n from −2⁵¹ to 2⁵¹ added to its
/// bits makes the real number n + 3·2⁵¹. Differences of such are exact.
constexpr double integer_offset = 0x3p51;
constexpr std::int64_t integer_offset_bits = 0x4338000000000000;

/// n + `integer_offset` of whole numbers n.
template <class D>
HWY_INLINE hn::Vec<D> load_offset_integers(D doubles, const std::int64_t* numbers) {
    const hn::RebindToSigned<D> whole;
    return hn::BitCast(doubles,
                       hn::Add(hn::LoadU(whole, numbers), hn::Set(whole, integer_offset_bits)));
}

/// The same of one n in all lanes.
template <class D>
HWY_INLINE hn::Vec<D> set_offset_integer(D doubles, std::int64_t number) {
    const hn::RebindToSigned<D> whole;
    return hn::BitCast(doubles, hn::Set(whole, number + integer_offset_bits));
}

/// Puts n where the vector has n + `integer_offset`.
template <class V>
HWY_INLINE void store_offset_integers(V number, std::int64_t* numbers) {
    const hn::RebindToSigned<hn::DFromV<V>> whole;
    hn::StoreU(hn::Sub(hn::BitCast(whole, number), hn::Set(whole, integer_offset_bits)), whole,
               numbers);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::vectors
HWY_AFTER_NAMESPACE();

#endif
