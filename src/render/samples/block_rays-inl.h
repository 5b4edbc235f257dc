// Points that samples of a block see. Included once for each target, after highway.h.
#if defined(FUMON_RENDER_SAMPLES_BLOCK_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FUMON_RENDER_SAMPLES_BLOCK_RAYS_INL_H
#undef FUMON_RENDER_SAMPLES_BLOCK_RAYS_INL_H
#else
#define FUMON_RENDER_SAMPLES_BLOCK_RAYS_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "render/samples/block_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::block_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where the samples of a row of pixels see something, 0 … 1 along an axis of the block.
template <class Real>
HWY_INLINE Real position_at(const Rays& rays, Real column, Real depth) {
    const hn::ScalableTag<float> d;
    const auto origin = hn::Set(d, rays.origin) + hn::Set(d, rays.origin_by_column) * column;
    const auto direction =
        hn::Set(d, rays.direction) + hn::Set(d, rays.direction_by_column) * column;
    return hn::Min(hn::Max(origin + depth * direction, hn::Zero(d)), hn::Set(d, 1.0F));
}

/// How far along its ray a sample sees something.
template <class Word>
HWY_INLINE auto depth_of(const Depths& depths, Word sample) {
    const hn::ScalableTag<float> d;
    const hn::ScalableTag<std::uint32_t> words;
    const auto low = hn::Set(words, rasteriser_vectors::kind_bits);
    const auto reversed_z = hn::BitCast(d, hn::AndNot(low, sample));
    return depths.perspective
               ? hn::Set(d, depths.numerator) / reversed_z
               : hn::Set(d, depths.first) + hn::Set(d, depths.by_reversed_z) * reversed_z;
}

/// The columns of the left samples of pixels from one on.
HWY_INLINE auto columns_from(int first_column, std::size_t pixel) {
    const hn::ScalableTag<float> d;
    return hn::Set(d, static_cast<float>(first_column) + 2.0F * static_cast<float>(pixel) + 0.5F) +
           hn::Set(d, 2.0F) * hn::Iota(d, 0.0F);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::block_vectors
HWY_AFTER_NAMESPACE();

#endif
