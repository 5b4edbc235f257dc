#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "numerics/poisson_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include "numerics/poisson_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::poisson {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Four = hn::CappedTag<double, 4>;
using V = hn::Vec<Four>;
constexpr std::size_t lanes = hn::MaxLanes(Four());
constexpr std::size_t groups = modes_together / lanes;  // vectors of modes

/// Columns become rows. Of a block as wide as a vector.
template <std::size_t side>
HWY_INLINE void transpose([[maybe_unused]] V (&block)[side]) {
    [[maybe_unused]] const Four d;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (side == 4) {
        const V a = hn::InterleaveLower(d, block[0], block[1]);
        const V b = hn::InterleaveUpper(d, block[0], block[1]);
        const V c = hn::InterleaveLower(d, block[2], block[3]);
        const V e = hn::InterleaveUpper(d, block[2], block[3]);
        block[0] = hn::ConcatLowerLower(d, c, a);
        block[1] = hn::ConcatLowerLower(d, e, b);
        block[2] = hn::ConcatUpperUpper(d, c, a);
        block[3] = hn::ConcatUpperUpper(d, e, b);
    } else if constexpr (side == 2) {
        const V a = hn::InterleaveLower(d, block[0], block[1]);
        block[1] = hn::InterleaveUpper(d, block[0], block[1]);
        block[0] = a;
    }
#endif
}

/// Node k of the modes' solution, modes side by side.
struct Nodes {
    double* real;
    double* imaginary;

    [[nodiscard]] HWY_INLINE double* re(std::size_t k) const { return real + k * modes_together; }
    [[nodiscard]] HWY_INLINE double* im(std::size_t k) const {
        return imaginary + k * modes_together;
    }
};

/// Nodes k … k + lanes − 1 of all modes, times a scale.
HWY_INLINE void gather(const double* from, std::size_t stride, std::size_t k, V scale,
                       V (&to)[groups][lanes]) {
    for (std::size_t g = 0; g < groups; ++g) {
        for (std::size_t j = 0; j < lanes; ++j)
            to[g][j] = scale * hn::LoadU(Four(), from + (g * lanes + j) * stride + k);
        transpose(to[g]);
    }
}

HWY_INLINE void scatter(const double* solved, bool anew, std::size_t stride, std::size_t k,
                        double* to) {
    const Four d;
    for (std::size_t g = 0; g < groups; ++g) {
        V block[lanes];
        for (std::size_t j = 0; j < lanes; ++j)
            block[j] = hn::LoadU(d, solved + (k + j) * modes_together + g * lanes);
        transpose(block);
        for (std::size_t j = 0; j < lanes; ++j) {
            double* cells = to + (g * lanes + j) * stride + k;
            hn::StoreU(anew ? block[j] : hn::LoadU(d, cells) + block[j], d, cells);
        }
    }
}

void eliminate(const Modes& modes, const double* inverse_pivots, const Nodes& nodes) {
    const Four d;
    const V zero = hn::Zero(d);
    const V scale = hn::Set(d, modes.scale);
    V last_re[groups], last_im[groups];
    for (std::size_t g = 0; g < groups; ++g) last_re[g] = last_im[g] = zero;
    for (std::size_t k = 0; k < modes.nodes; k += lanes) {
        V re[groups][lanes], im[groups][lanes];
        if (k < modes.filled) {
            gather(modes.real, modes.stride, k, scale, re);
            gather(modes.imaginary, modes.stride, k, scale, im);
        }
        for (std::size_t j = 0; j < lanes; ++j) {
            const bool known = k + j < modes.filled;
            for (std::size_t g = 0; g < groups; ++g) {
                const V inverse =
                    hn::LoadU(d, inverse_pivots + (k + j) * modes_together + g * lanes);
                last_re[g] = ((known ? re[g][j] : zero) - last_re[g]) * inverse;
                last_im[g] = ((known ? im[g][j] : zero) - last_im[g]) * inverse;
                hn::StoreU(last_re[g], d, nodes.re(k + j) + g * lanes);
                hn::StoreU(last_im[g], d, nodes.im(k + j) + g * lanes);
            }
        }
    }
}

void substitute_back(const Modes& modes, const double* inverse_pivots, const Nodes& nodes) {
    const Four d;
    V last_re[groups], last_im[groups];
    for (std::size_t g = 0; g < groups; ++g) last_re[g] = last_im[g] = hn::Zero(d);
    for (std::size_t k = modes.nodes; k-- > 0;) {
        for (std::size_t g = 0; g < groups; ++g) {
            const V inverse = hn::LoadU(d, inverse_pivots + k * modes_together + g * lanes);
            double* re = nodes.re(k) + g * lanes;
            double* im = nodes.im(k) + g * lanes;
            last_re[g] = hn::LoadU(d, re) - inverse * last_re[g];
            last_im[g] = hn::LoadU(d, im) - inverse * last_im[g];
            hn::StoreU(last_re[g], d, re);
            hn::StoreU(last_im[g], d, im);
        }
    }
}

void solve_modes(const Modes& modes, const double* inverse_pivots, double* scratch) {
    const Nodes nodes{scratch, scratch + (modes.nodes + 8) * modes_together};
    eliminate(modes, inverse_pivots, nodes);
    substitute_back(modes, inverse_pivots, nodes);
    for (std::size_t k = modes.nodes; k < modes.nodes + lanes; ++k) {
        for (std::size_t m = 0; m < modes_together; ++m) nodes.re(k)[m] = nodes.im(k)[m] = 0.0;
    }
    for (std::size_t k = 0; k < modes.nodes; k += lanes) {
        scatter(nodes.real, modes.anew, modes.stride, k, modes.solved_real);
        scatter(nodes.imaginary, modes.anew, modes.stride, k, modes.solved_imaginary);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::poisson
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::poisson {

HWY_EXPORT(solve_modes);

void solve_modes(const Modes& modes, const double* inverse_pivots, double* scratch) {
    HWY_DYNAMIC_DISPATCH(solve_modes)(modes, inverse_pivots, scratch);
}

}  // namespace fumon::poisson
#endif
