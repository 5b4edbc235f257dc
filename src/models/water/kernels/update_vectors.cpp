#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/update_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/update_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::finite_volume {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// The depth after an Euler step.
struct NextDepth {
    UpdateInput i;
    UpdateFactors f;

    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, std::size_t k) const {
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + k); };
        const auto lost = hn::Set(d, f.dt_dx) * (load(i.east.mass) - load(i.west.mass)) +
                          hn::Set(d, f.dt_dy) * (load(i.north.mass) - load(i.south.mass));
        return larger((load(i.cells.depth) - lost) + hn::Set(d, f.dt) * load(i.rain), hn::Zero(d)) *
               load(i.cells.inside);
    }
};

/// log h^(−1/3).
struct LogOfRoughness {
    NextDepth next_depth;
    double* out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto deep = larger(next_depth(d, k), hn::Set(d, dry_depth));
        hn::StoreU(hn::Set(d, -1.0 / 3.0) * log_of_normal(deep), d, out + k);
    }
};

struct Exponential {
    double* values;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        hn::StoreU(vectors::HWY_NAMESPACE::exp(hn::LoadU(d, values + k)), d, values + k);
    }
};

/// What a stage gives: its own end; the mean with the step's start; or shares of both.
enum class Mix : std::uint8_t { none, half, shares };

/// An Euler step of the finite volumes, h1 = h − Σ dt/dx ΔF + dt·rain and momenta alike, with
/// friction implicit: u1 (1 + dt C_f |u1| / h1) = q / h1, or C_f = g n² h1^(−1/3) after Manning;
/// then the share of the step's start by which stages make Heun's or Shu & Osher's (1988) method.
template <Mix mix, bool manning, bool bounded>
struct Update {
    UpdateInput i;
    UpdateFactors f;
    const double* roughness;  ///< h^(−1/3), or null
    double* depth;
    double* velocity_x;
    double* velocity_y;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        using V = hn::Vec<D>;
        const V one = hn::Set(d, 1.0);
        const V two = hn::Set(d, 2.0);
        const V dry = hn::Set(d, dry_depth);
        const V dt_dx = hn::Set(d, f.dt_dx);
        const V dt_dy = hn::Set(d, f.dt_dy);
        const V h = hn::LoadU(d, i.cells.depth + k);
        const V weight = hn::Set(d, 2.0 * f.gravity) * h;
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + k); };
        const V lost_x =
            dt_dx * ((load(i.east.left) - load(i.west.right)) + weight * load(i.surface_x)) +
            dt_dy * (load(i.north.transverse) - load(i.south.transverse));
        const V lost_y =
            dt_dy * ((load(i.north.left) - load(i.south.right)) + weight * load(i.surface_y)) +
            dt_dx * (load(i.east.transverse) - load(i.west.transverse));
        V h1 = NextDepth{i, f}(d, k);
        const V qx = (h * load(i.cells.normal) - lost_x) - hn::Set(d, f.dt * f.pull_x) * h;
        const V qy = (h * load(i.cells.transverse) - lost_y) - hn::Set(d, f.dt * f.pull) * h;
        const V per_depth = one / larger(h1, dry);
        const V ux = qx * per_depth;
        const V uy = qy * per_depth;
        const V speed = hn::Sqrt(ux * ux + uy * uy);
        V drag = hn::Set(d, 4.0 * f.dt) * load(i.friction);
        if constexpr (manning) drag = drag * load(roughness);
        const V kept = two / (one + hn::Sqrt(one + drag * (speed * per_depth)));
        V u1 = hn::IfThenElseZero(hn::Gt(h1, dry), ux * kept);
        V v1 = hn::IfThenElseZero(hn::Gt(h1, dry), uy * kept);
        if constexpr (bounded) {
            const V speed1 = speed * kept;
            const V most = load(i.most_speed);
            const auto too_fast = hn::And(hn::Le(h1, load(i.thin)), hn::Gt(speed1, most));
            const V share = hn::IfThenElse(too_fast, most / speed1, one);
            u1 = u1 * share;
            v1 = v1 * share;
        }
        if constexpr (mix != Mix::none) {
            const V h0 = load(i.depth_before);
            V h_mean;
            V whole;  // of which the momenta are shares
            V of_start;
            V of_stage;
            if constexpr (mix == Mix::half) {
                const V half = hn::Set(d, 0.5);
                h_mean = half * (h0 + h1);
                whole = half / larger(h_mean, dry);
                of_start = h0;
                of_stage = h1;
            } else {
                const V added = one - hn::Set(d, f.kept);
                h_mean = h0 + added * (h1 - h0);  // no drift where the two are the same
                whole = one / larger(h_mean, dry);
                of_start = hn::Set(d, f.kept) * h0;
                of_stage = added * h1;
            }
            const V ux_mean = (of_start * load(i.x_before) + of_stage * u1) * whole;
            const V uy_mean = (of_start * load(i.y_before) + of_stage * v1) * whole;
            h1 = h_mean;
            u1 = hn::IfThenElseZero(hn::Gt(h_mean, dry), ux_mean);
            v1 = hn::IfThenElseZero(hn::Gt(h_mean, dry), uy_mean);
        }
        hn::StoreU(h1, d, depth + k);
        hn::StoreU(u1, d, velocity_x + k);
        hn::StoreU(v1, d, velocity_y + k);
    }
};

template <bool manning, bool bounded>
HWY_INLINE void compute_update(const UpdateInput& in, const UpdateFactors& factors, double* depth,
                               double* velocity_x, double* velocity_y, int count) {
    const double* roughness = nullptr;
    HWY_ALIGN double some[widest_update];
    if constexpr (manning) {
        // Three loops: of one as long as all the processor sees too few cells ahead to work on
        // several.
        for_each_vector_overlapping(count, LogOfRoughness{{in, factors}, some});
        for_each_vector(count, Exponential{some});
        roughness = some;
    }
    if (in.depth_before == nullptr) {
        for_each_vector_overlapping(
            count, Update<Mix::none, manning, bounded>{in, factors, roughness, depth, velocity_x,
                                                       velocity_y});
    } else if (factors.kept == 0.5) {
        for_each_vector(count, Update<Mix::half, manning, bounded>{in, factors, roughness, depth,
                                                                   velocity_x, velocity_y});
    } else {
        for_each_vector(count, Update<Mix::shares, manning, bounded>{in, factors, roughness, depth,
                                                                     velocity_x, velocity_y});
    }
}

template <bool manning>
HWY_INLINE void compute_update(const UpdateInput& in, const UpdateFactors& factors, double* depth,
                               double* velocity_x, double* velocity_y, int count) {
    if (in.most_speed == nullptr) {
        compute_update<manning, false>(in, factors, depth, velocity_x, velocity_y, count);
    } else {
        compute_update<manning, true>(in, factors, depth, velocity_x, velocity_y, count);
    }
}

void update(const UpdateInput& in, const UpdateFactors& factors, double* depth, double* velocity_x,
            double* velocity_y, int count) {
    if (factors.manning) {
        compute_update<true>(in, factors, depth, velocity_x, velocity_y, count);
    } else {
        compute_update<false>(in, factors, depth, velocity_x, velocity_y, count);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::finite_volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::finite_volume {

HWY_EXPORT(update);

void update(const UpdateInput& in, const UpdateFactors& factors, double* depth, double* velocity_x,
            double* velocity_y, int count) {
    HWY_DYNAMIC_DISPATCH(update)(in, factors, depth, velocity_x, velocity_y, count);
}

}  // namespace fumon::finite_volume
#endif
