#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "numerics/fourier_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include "numerics/fourier_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::fourier {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Four = hn::CappedTag<double, half>;
using V = hn::Vec<Four>;
constexpr std::size_t lanes = hn::MaxLanes(Four());

HWY_INLINE V load(const double* from) {
    return hn::LoadU(Four(), from);
}

HWY_INLINE void store(V value, double* to) {
    hn::StoreU(value, Four(), to);
}

struct Turn {
    V c;
    V s;

    HWY_INLINE Turn(const double* cosine, const double* sine)
        : c(hn::Set(Four(), *cosine)), s(hn::Set(Four(), *sine)) {}

    [[nodiscard]] HWY_INLINE V real(V a, V b) const { return a * c + b * s; }
    [[nodiscard]] HWY_INLINE V imaginary(V a, V b) const { return b * c - a * s; }
};

/// Where a stage reads its points and where it writes them.
struct Points {
    const double* from;
    std::size_t reach;  ///< from an input of a butterfly to the next
    double* real;
    double* imaginary;
    std::size_t next;  ///< from an output to the next
    std::size_t from_step;
    std::size_t to_step;

    HWY_INLINE Points(const Stage& stage, const double* values, double* to)
        : from(values),
          reach(stage.parts * stage.stride * stage.from_step),
          real(to + (stage.mirrored ? half : 0)),
          imaginary(to + (stage.mirrored ? 0 : half)),
          next(stage.stride * stage.to_step),
          from_step(stage.from_step),
          to_step(stage.to_step) {}

    /// (a + ib)·(c − is) to output t of the butterfly that writes from `at` on.
    HWY_INLINE void put(const Turn& by, V a, V b, std::size_t t, std::size_t at) const {
        store(by.real(a, b), real + at + t * next);
        store(by.imaginary(a, b), imaginary + at + t * next);
    }
    HWY_INLINE void put(V a, V b, std::size_t at) const {
        store(a, real + at);
        store(b, imaginary + at);
    }
};

void butterflies_of_four(const Stage& stage, const double* from, double* to) {
    const Points points(stage, from, to);
    const std::size_t reach = points.reach;
    for (std::size_t p = 0; p < stage.parts; ++p) {
        const std::size_t turn = p * stage.stride;
        const Turn one(stage.cosine + turn, stage.sine + turn);
        const Turn two(stage.cosine + 2 * turn, stage.sine + 2 * turn);
        const Turn three(stage.cosine + 3 * turn, stage.sine + 3 * turn);
        for (std::size_t q = 0; q < stage.stride; ++q) {
            for (std::size_t l = 0; l < half; l += lanes) {
                const double* x0 = points.from + (p * stage.stride + q) * points.from_step + l;
                const double* x1 = x0 + reach;
                const double* x2 = x1 + reach;
                const double* x3 = x2 + reach;
                const std::size_t at = (4 * p * stage.stride + q) * points.to_step + l;
                const V sum_re = load(x0) + load(x2);
                const V sum_im = load(x0 + half) + load(x2 + half);
                const V off_re = load(x0) - load(x2);
                const V off_im = load(x0 + half) - load(x2 + half);
                const V odd_re = load(x1) + load(x3);
                const V odd_im = load(x1 + half) + load(x3 + half);
                const V cross_re = load(x1) - load(x3);
                const V cross_im = load(x1 + half) - load(x3 + half);
                points.put(sum_re + odd_re, sum_im + odd_im, at);
                points.put(one, off_re + cross_im, off_im - cross_re, 1, at);
                points.put(two, sum_re - odd_re, sum_im - odd_im, 2, at);
                points.put(three, off_re - cross_im, off_im + cross_re, 3, at);
            }
        }
    }
}

void butterflies_of_five(const Stage& stage, const double* from, double* to) {
    const Points points(stage, from, to);
    const std::size_t reach = points.reach;
    const std::size_t fifth = stage.length / 5;
    const Turn once(stage.cosine + fifth, stage.sine + fifth);
    const Turn twice(stage.cosine + 2 * fifth, stage.sine + 2 * fifth);
    const V c1 = once.c, s1 = once.s, c2 = twice.c, s2 = twice.s;
    for (std::size_t p = 0; p < stage.parts; ++p) {
        const std::size_t turn = p * stage.stride;
        const Turn one(stage.cosine + turn, stage.sine + turn);
        const Turn two(stage.cosine + 2 * turn, stage.sine + 2 * turn);
        const Turn three(stage.cosine + 3 * turn, stage.sine + 3 * turn);
        const Turn four(stage.cosine + 4 * turn, stage.sine + 4 * turn);
        for (std::size_t q = 0; q < stage.stride; ++q) {
            for (std::size_t l = 0; l < half; l += lanes) {
                const double* x0 = points.from + (p * stage.stride + q) * points.from_step + l;
                const double* x1 = x0 + reach;
                const double* x2 = x1 + reach;
                const double* x3 = x2 + reach;
                const double* x4 = x3 + reach;
                const std::size_t at = (5 * p * stage.stride + q) * points.to_step + l;
                const V x0_re = load(x0), x0_im = load(x0 + half);
                const V t1 = load(x1) + load(x4), u1 = load(x1 + half) + load(x4 + half);
                const V t2 = load(x2) + load(x3), u2 = load(x2 + half) + load(x3 + half);
                const V d1 = load(x1) - load(x4), e1 = load(x1 + half) - load(x4 + half);
                const V d2 = load(x2) - load(x3), e2 = load(x2 + half) - load(x3 + half);
                points.put(x0_re + (t1 + t2), x0_im + (u1 + u2), at);
                const V r1 = x0_re + (c1 * t1 + c2 * t2), i1 = x0_im + (c1 * u1 + c2 * u2);
                const V v1 = s1 * d1 + s2 * d2, z1 = s1 * e1 + s2 * e2;
                points.put(one, r1 + z1, i1 - v1, 1, at);
                points.put(four, r1 - z1, i1 + v1, 4, at);
                const V r2 = x0_re + (c2 * t1 + c1 * t2), i2 = x0_im + (c2 * u1 + c1 * u2);
                const V v2 = s2 * d1 - s1 * d2, z2 = s2 * e1 - s1 * e2;
                points.put(two, r2 + z2, i2 - v2, 2, at);
                points.put(three, r2 - z2, i2 + v2, 3, at);
            }
        }
    }
}

void butterflies(const Stage& stage, const double* from, double* to) {
    const Points points(stage, from, to);
    const std::size_t part = stage.length / stage.radix;
    for (std::size_t p = 0; p < stage.parts; ++p) {
        for (std::size_t t = 0; t < stage.radix; ++t) {
            const std::size_t turn = p * t * stage.stride;
            const Turn last(stage.cosine + turn, stage.sine + turn);
            for (std::size_t q = 0; q < stage.stride; ++q) {
                for (std::size_t l = 0; l < half; l += lanes) {
                    const double* x = points.from + (p * stage.stride + q) * points.from_step + l;
                    V a = hn::Zero(Four());
                    V b = a;
                    for (std::size_t j = 0; j < stage.radix; ++j) {
                        const std::size_t angle = (j * t) % stage.radix * part;
                        const Turn by(stage.cosine + angle, stage.sine + angle);
                        const V re = load(x + j * points.reach);
                        const V im = load(x + j * points.reach + half);
                        a = a + by.real(re, im);
                        b = b + by.imaginary(re, im);
                    }
                    points.put(last, a, b, t,
                               (stage.radix * p * stage.stride + q) * points.to_step + l);
                }
            }
        }
    }
}

void rotate_points(double* z, const double* c, const double* s, std::size_t points) {
    for (std::size_t i = 0; i < points; ++i) {
        const Turn by(c + i, s + i);
        for (std::size_t l = 0; l < half; l += lanes) {
            double* point = z + i * rows + l;
            const V a = load(point);
            const V b = load(point + half);
            store(by.real(a, b), point);
            store(by.imaginary(a, b), point + half);
        }
    }
}

void multiply_conjugate(double* z, const double* c, const double* s, std::size_t points) {
    for (std::size_t i = 0; i < points; ++i) {
        const Turn by(c + i, s + i);
        for (std::size_t l = 0; l < half; l += lanes) {
            double* point = z + i * rows + l;
            const V a = load(point);
            const V b = load(point + half);
            store(a * by.c - b * by.s, point);
            store(hn::Neg(a * by.s + b * by.c), point + half);
        }
    }
}

void split_spectra(const double* z, std::size_t length, const Spectra& to) {
    const V scale = hn::Set(Four(), 0.5);
    for (std::size_t m = 0; m <= length / 2; ++m) {
        for (std::size_t l = 0; l < half; l += lanes) {
            const double* here = z + m * rows + l;
            const double* mirrored = z + (m == 0 ? 0 : length - m) * rows + l;
            double* re = to.real + m * to.stride + l;
            double* im = to.imaginary + m * to.stride + l;
            const V a = load(here), b = load(here + half);
            const V c = load(mirrored), d = load(mirrored + half);
            store(scale * (a + c), re);
            store(scale * (b - d), im);
            store(scale * (b + d), re + half);
            store(scale * (c - a), im + half);
        }
    }
}

void merge_spectra(const ConstSpectra& from, std::size_t length, double* z) {
    for (std::size_t m = 0; m <= length / 2; ++m) {
        for (std::size_t l = 0; l < half; l += lanes) {
            const double* re = from.real + m * from.stride + l;
            const double* im = from.imaginary + m * from.stride + l;
            double* here = z + m * rows + l;
            double* mirrored = z + (m == 0 ? 0 : length - m) * rows + l;
            const V a = load(re), b = load(im);
            const V c = load(re + half), d = load(im + half);
            store(a + d, mirrored + half);
            store(c - b, mirrored);
            store(a - d, here + half);
            store(c + b, here);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::fourier
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::fourier {

HWY_EXPORT(butterflies_of_four);
HWY_EXPORT(butterflies_of_five);
HWY_EXPORT(butterflies);
HWY_EXPORT(rotate_points);
HWY_EXPORT(multiply_conjugate);
HWY_EXPORT(split_spectra);
HWY_EXPORT(merge_spectra);

void butterflies_of_four(const Stage& stage, const double* from, double* to) {
    HWY_DYNAMIC_DISPATCH(butterflies_of_four)(stage, from, to);
}

void butterflies_of_five(const Stage& stage, const double* from, double* to) {
    HWY_DYNAMIC_DISPATCH(butterflies_of_five)(stage, from, to);
}

void butterflies(const Stage& stage, const double* from, double* to) {
    HWY_DYNAMIC_DISPATCH(butterflies)(stage, from, to);
}

void rotate_points(double* z, const double* c, const double* s, std::size_t points) {
    HWY_DYNAMIC_DISPATCH(rotate_points)(z, c, s, points);
}

void multiply_conjugate(double* z, const double* c, const double* s, std::size_t points) {
    HWY_DYNAMIC_DISPATCH(multiply_conjugate)(z, c, s, points);
}

void split_spectra(const double* z, std::size_t length, const Spectra& to) {
    HWY_DYNAMIC_DISPATCH(split_spectra)(z, length, to);
}

void merge_spectra(const ConstSpectra& from, std::size_t length, double* z) {
    HWY_DYNAMIC_DISPATCH(merge_spectra)(from, length, z);
}

}  // namespace fumon::fourier
#endif
