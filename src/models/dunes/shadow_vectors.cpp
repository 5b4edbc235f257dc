#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/dunes/shadow_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/dunes/shadow_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::shadow_vectors {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

void fall(const Lines& lines, double soft_drop, double full_drop) {
    const auto loop = [&](auto doubles, std::size_t i) HWY_ATTR {
        const auto soft = hn::Sub(hn::LoadU(doubles, lines.soft + i), hn::Set(doubles, soft_drop));
        const auto full = hn::Sub(hn::LoadU(doubles, lines.full + i), hn::Set(doubles, full_drop));
        hn::StoreU(soft, doubles, lines.soft + i);
        hn::StoreU(full, doubles, lines.full + i);
    };
    for_each_vector(lines.count, loop);
}

void shade(const Lines& lines, const Between& between, double* shade, double* envelope) {
    const double near = 1.0 - between.beyond;
    const auto loop = [&](auto doubles, std::size_t i) HWY_ATTR {
        const auto blend = [&](const double* line) HWY_ATTR {
            return hn::Add(hn::Mul(hn::LoadU(doubles, line + i + 1), hn::Set(doubles, near)),
                           hn::Mul(hn::LoadU(doubles, line + i), hn::Set(doubles, between.beyond)));
        };
        constexpr double thinnest = 1e-9;  // m: a hard edge
        const auto ground = hn::LoadU(doubles, between.heights + i + 1);
        const auto soft = blend(lines.soft);
        const auto full = blend(lines.full);
        const auto room = greater(hn::Sub(soft, full), hn::Set(doubles, thinnest));
        const auto below = hn::Div(hn::Sub(soft, ground), room);
        const auto one = hn::Set(doubles, 1.0);
        hn::StoreU(lesser(greater(below, hn::Zero(doubles)), one), doubles, shade + i);
        hn::StoreU(greater(full, ground), doubles, envelope + i);
    };
    for_each_vector(lines.count - 1, loop);
}

void lift(const Lines& lines, const Between& between) {
    const double near = 1.0 - between.beyond;
    const auto loop = [&](auto doubles, std::size_t i) HWY_ATTR {
        const auto ground = hn::Add(
            hn::Mul(hn::LoadU(doubles, between.heights + i), hn::Set(doubles, near)),
            hn::Mul(hn::LoadU(doubles, between.heights + i + 1), hn::Set(doubles, between.beyond)));
        hn::StoreU(greater(hn::LoadU(doubles, lines.soft + i), ground), doubles, lines.soft + i);
        hn::StoreU(greater(hn::LoadU(doubles, lines.full + i), ground), doubles, lines.full + i);
    };
    for_each_vector(lines.count, loop);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::shadow_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::shadow_vectors {

HWY_EXPORT(fall);
HWY_EXPORT(shade);
HWY_EXPORT(lift);

void fall(const Lines& lines, double soft_drop, double full_drop) {
    HWY_DYNAMIC_DISPATCH(fall)(lines, soft_drop, full_drop);
}

void shade(const Lines& lines, const Between& between, double* shade, double* envelope) {
    HWY_DYNAMIC_DISPATCH(shade)(lines, between, shade, envelope);
}

void lift(const Lines& lines, const Between& between) {
    HWY_DYNAMIC_DISPATCH(lift)(lines, between);
}

}  // namespace fumon::shadow_vectors
#endif
