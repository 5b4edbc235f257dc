#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/sediment_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/sediment_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::sediment {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// Squares of speeds and slopes up to this count as standing water and a level bed: their powers
/// are 0 in all that matters.
constexpr double tiny = 1e-300;

/// What of `amount` goes down a drop of which it may take up to `most`.
template <class V>
HWY_INLINE V within(V amount, V most, V zero) {
    return hn::IfThenElseZero(hn::Gt(most, zero), amount * most / (most + amount));
}

HWY_INLINE Vector log_of_square(Vector square) {
    return log_of_normal(greater(square, constant(tiny)));
}

struct Steepness {
    FluxLaw law;
    Sides bed;
    double* steepness;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto slope_x =
            (hn::LoadU(d, bed.east + x) - hn::LoadU(d, bed.west + x)) * hn::Set(d, law.half_per_x) -
            hn::Set(d, law.mean_slope_x);
        const auto slope_y = hn::Set(d, law.mean_slope) +
                             (hn::LoadU(d, bed.north + x) - hn::LoadU(d, bed.south + x)) *
                                 hn::Set(d, law.half_per_y);
        hn::StoreU(slope_x * slope_x + slope_y * slope_y, d, steepness + x);
    }
};

struct Downhill {
    FluxLaw law;
    const double* here;
    Sides bed;
    double* steepness;
    double* drop;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto zero = hn::Zero(d);
        const double per_y = 2.0 * law.half_per_y;
        const auto plane = hn::Set(d, law.mean_slope / per_y);  // its fall over a cell
        const auto plane_x = hn::Set(d, law.mean_slope_x / (2.0 * law.half_per_x));
        const auto z = hn::LoadU(d, here + x);
        const auto below = [&](const double* side) HWY_ATTR { return z - hn::LoadU(d, side + x); };
        const auto drop_x =
            larger(larger(below(bed.west) - plane_x, below(bed.east) + plane_x), zero);
        const auto drop_y =
            larger(larger(below(bed.south) + plane, below(bed.north) - plane), zero);
        const auto slope_x = drop_x * hn::Set(d, 2.0 * law.half_per_x);
        const auto slope_y = drop_y * hn::Set(d, per_y);
        hn::StoreU(slope_x * slope_x + slope_y * slope_y, d, steepness + x);
        hn::StoreU(larger(drop_x, drop_y), d, drop + x);
    }
};

struct Direct {
    const double* flux;
    const double* u;
    const double* v;
    double* flux_x;
    double* flux_y;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto along_x = hn::LoadU(d, u + x);
        const auto along_y = hn::LoadU(d, v + x);
        const auto speed = along_x * along_x + along_y * along_y;
        const auto moves = hn::Gt(speed, hn::Set(d, tiny));
        const auto per_speed =
            hn::LoadU(d, flux + x) / hn::Sqrt(hn::IfThenElse(moves, speed, hn::Set(d, 1.0)));
        hn::StoreU(per_speed * along_x, d, flux_x + x);
        hn::StoreU(per_speed * along_y, d, flux_y + x);
    }
};

struct SumAsPrinted {
    Sides flux_x;
    Sides flux_y;
    double per_x;
    double per_y;
    double* change;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto along_y = hn::LoadU(d, flux_y.north + x) + hn::LoadU(d, flux_y.south + x);
        const auto along_x = hn::LoadU(d, flux_x.east + x) + hn::LoadU(d, flux_x.west + x);
        hn::StoreU(hn::Set(d, per_y) * along_y - hn::Set(d, per_x) * along_x, d, change + x);
    }
};

struct Diverge {
    Sides flux_x;
    Sides flux_y;
    double per_x;
    double per_y;
    double* change;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto along_y = hn::LoadU(d, flux_y.south + x) - hn::LoadU(d, flux_y.north + x);
        const auto along_x = hn::LoadU(d, flux_x.west + x) - hn::LoadU(d, flux_x.east + x);
        hn::StoreU(hn::Set(d, per_y) * along_y + hn::Set(d, per_x) * along_x, d, change + x);
    }
};

struct InciseDownhill {
    const double* flux;
    const double* drop;
    double dt;
    double* change;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto asked = hn::Set(d, dt) * hn::LoadU(d, flux + x);
        hn::StoreU(hn::Neg(within(asked, hn::LoadU(d, drop + x), hn::Zero(d))), d, change + x);
    }
};

struct SettleDownhill {
    const double* here;
    Sides bed;
    const double* flux_x_here;
    Sides flux_x;
    const double* flux_y_here;
    Sides flux_y;
    double per_x;
    double per_y;
    double plane;    ///< the mean plane's fall over a cell, m
    double plane_x;  ///< … eastward
    double* change;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        constexpr double most = 0.125;  // of a drop, through one of a cell's four faces
        const V zero = hn::Zero(d);
        const V down = hn::Set(d, plane);
        const V down_x = hn::Set(d, plane_x);
        const V z = hn::LoadU(d, here + x);
        const auto drop_to = [&](const double* side)
                                 HWY_ATTR { return z - hn::LoadU(d, side + x); };
        const auto given = [&](V drop, V out, V in) HWY_ATTR {
            return within(larger(out, zero), hn::Set(d, most) * drop, zero) -
                   within(larger(in, zero), hn::Set(d, -most) * drop, zero);
        };
        const auto inward = [&](double factor, const double* flux)
                                HWY_ATTR { return hn::Set(d, factor) * hn::LoadU(d, flux + x); };
        const V fx = inward(per_x, flux_x_here);
        const V fy = inward(per_y, flux_y_here);
        const V east = given(drop_to(bed.east) + down_x, fx, inward(-per_x, flux_x.east));
        const V west = given(drop_to(bed.west) - down_x, hn::Neg(fx), inward(per_x, flux_x.west));
        const V north = given(drop_to(bed.north) - down, fy, inward(-per_y, flux_y.north));
        const V south = given(drop_to(bed.south) + down, hn::Neg(fy), inward(per_y, flux_y.south));
        hn::StoreU(hn::Neg((east + west) + (north + south)), d, change + x);
    }
};

struct HoldBetweenNeighbours {
    const double* here;
    Sides bed;
    double plane;
    double plane_x;
    double* change;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        const V down = hn::Set(d, plane);
        const V down_x = hn::Set(d, plane_x);
        const V z = hn::LoadU(d, here + x);
        const V west = (z - hn::LoadU(d, bed.west + x)) - down_x;
        const V east = (z - hn::LoadU(d, bed.east + x)) + down_x;
        const V south = (z - hn::LoadU(d, bed.south + x)) + down;
        const V north = (z - hn::LoadU(d, bed.north + x)) - down;
        const V drop = larger(larger(west, east), larger(south, north));
        const V rise =
            larger(larger(hn::Neg(west), hn::Neg(east)), larger(hn::Neg(south), hn::Neg(north)));
        const V wanted = hn::LoadU(d, change + x);
        const V cut = within(larger(hn::Neg(wanted), zero), drop, zero);
        const V fill = within(larger(wanted, zero), rise, zero);
        hn::StoreU(fill - cut, d, change + x);
    }
};

void steepness_row(const FluxLaw& law, const Sides& bed, int count, double* steepness) {
    for_each_vector(count, Steepness{law, bed, steepness});
}

void downhill_row(const FluxLaw& law, const double* here, const Sides& bed, int count,
                  double* steepness, double* drop) {
    for_each_vector(count, Downhill{law, here, bed, steepness, drop});
}

/// In place of S² of a row, the stress above the critical one: K_t U^q S^γ − τ_c, none below 0, and
/// 0 where the water stands.
void stress_row(const FluxLaw& law, const double* u, const double* v, int count, double* excess) {
    const double half_q = 0.5 * law.velocity_exponent;
    const double half_gamma = 0.5 * law.slope_exponent;
    // Two loops: of one as long as both the processor sees too few cells ahead to work on several.
    const auto log_of_power = [half_q, half_gamma](Vector steepness, Vector along_x, Vector along_y)
                                  HWY_ATTR {
                                      const Vector speed = along_x * along_x + along_y * along_y;
                                      return constant(half_q) * log_of_square(speed) +
                                             constant(half_gamma) * log_of_square(steepness);
                                  };
    const auto stress_above = [&law](Vector log_of_it, Vector along_x, Vector along_y) HWY_ATTR {
        const Vector speed = along_x * along_x + along_y * along_y;
        const Vector power = vectors::HWY_NAMESPACE::exp(log_of_it);
        const Vector stress = constant(law.stress_factor) * power - constant(law.critical_stress);
        const Vector above = greater(stress, hn::Zero(Doubles()));
        return hn::IfThenElseZero(hn::Gt(speed, constant(tiny)), above);
    };
    for_each_cell(count, excess, log_of_power, excess, u, v);
    for_each_cell(count, excess, stress_above, excess, u, v);
}

/// In place of positive values, their powers; 0 stays.
void raise_row(double exponent, int count, double* values) {
    const auto raised = [exponent](Vector value) HWY_ATTR {
        const Vector power = vectors::HWY_NAMESPACE::exp(constant(exponent) * log_of_square(value));
        return hn::IfThenElseZero(hn::Gt(value, constant(tiny)), power);
    };
    for_each_cell(count, values, raised, values);
}

void scale_row(double factor, const double* in, int count, double* out) {
    const auto scaled = [factor](Vector value) HWY_ATTR { return constant(factor) * value; };
    for_each_cell(count, out, scaled, in);
}

void flux_row(const FluxLaw& law, const double* u, const double* v, int count, double* flux) {
    stress_row(law, u, v, count, flux);
    if (law.transport_exponent != 1.0) raise_row(law.transport_exponent, count, flux);
    if (law.transport_factor != 1.0) scale_row(law.transport_factor, flux, count, flux);
}

void direct_row(const double* flux, const double* u, const double* v, int count, double* flux_x,
                double* flux_y) {
    for_each_vector(count, Direct{flux, u, v, flux_x, flux_y});
}

void sum_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
             double* change) {
    for_each_vector(count,
                    SumAsPrinted{flux_x, flux_y, dt * law.half_per_x, dt * law.half_per_y, change});
}

void diverge_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
                 double* change) {
    for_each_vector(count,
                    Diverge{flux_x, flux_y, dt * law.half_per_x, dt * law.half_per_y, change});
}

void incise_row(const double* flux, double dt, int count, double* change) {
    scale_row(-dt, flux, count, change);
}

void incise_downhill_row(const double* flux, const double* drop, double dt, int count,
                         double* change) {
    for_each_vector(count, InciseDownhill{flux, drop, dt, change});
}

void settle_downhill_row(const FluxLaw& law, const double* here, const Sides& bed,
                         const double* flux_x_here, const Sides& flux_x, const double* flux_y_here,
                         const Sides& flux_y, double dt, int count, double* change) {
    for_each_vector(count, SettleDownhill{here, bed, flux_x_here, flux_x, flux_y_here, flux_y,
                                          2.0 * dt * law.half_per_x, 2.0 * dt * law.half_per_y,
                                          law.mean_slope / (2.0 * law.half_per_y),
                                          law.mean_slope_x / (2.0 * law.half_per_x), change});
}

void hold_between_neighbours(const FluxLaw& law, const double* here, const Sides& bed, int count,
                             double* change) {
    for_each_vector(count,
                    HoldBetweenNeighbours{here, bed, law.mean_slope / (2.0 * law.half_per_y),
                                          law.mean_slope_x / (2.0 * law.half_per_x), change});
}

double row_sum(const double* values, int count) {
    constexpr std::size_t sums = 8;  // cells 0, 8, 16 … in the first of them
    const hn::CappedTag<double, sums> d;
    constexpr std::size_t lanes = hn::MaxLanes(d);
    hn::Vec<decltype(d)> sum[sums / lanes];
    for (auto& some : sum) some = hn::Zero(d);
    const auto cells = static_cast<std::size_t>(count);
    std::size_t x = 0;
    for (; x + sums <= cells; x += sums) {
        for (std::size_t k = 0; k < sums / lanes; ++k)
            sum[k] = sum[k] + hn::LoadU(d, values + x + k * lanes);
    }
    HWY_ALIGN double lane[sums];
    for (std::size_t k = 0; k < sums / lanes; ++k) hn::Store(sum[k], d, lane + k * lanes);
    for (; x < cells; ++x) lane[x % sums] += values[x];
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) +
           ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::sediment
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::sediment {

HWY_EXPORT(steepness_row);
HWY_EXPORT(downhill_row);
HWY_EXPORT(flux_row);
HWY_EXPORT(direct_row);
HWY_EXPORT(sum_row);
HWY_EXPORT(diverge_row);
HWY_EXPORT(incise_row);
HWY_EXPORT(incise_downhill_row);
HWY_EXPORT(settle_downhill_row);
HWY_EXPORT(hold_between_neighbours);
HWY_EXPORT(row_sum);

void steepness_row(const FluxLaw& law, const Sides& bed, int count, double* steepness) {
    HWY_DYNAMIC_DISPATCH(steepness_row)(law, bed, count, steepness);
}

void downhill_row(const FluxLaw& law, const double* here, const Sides& bed, int count,
                  double* steepness, double* drop) {
    HWY_DYNAMIC_DISPATCH(downhill_row)(law, here, bed, count, steepness, drop);
}

void flux_row(const FluxLaw& law, const double* u, const double* v, int count, double* flux) {
    HWY_DYNAMIC_DISPATCH(flux_row)(law, u, v, count, flux);
}

void direct_row(const double* flux, const double* u, const double* v, int count, double* flux_x,
                double* flux_y) {
    HWY_DYNAMIC_DISPATCH(direct_row)(flux, u, v, count, flux_x, flux_y);
}

void sum_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
             double* change) {
    HWY_DYNAMIC_DISPATCH(sum_row)(law, flux_x, flux_y, dt, count, change);
}

void diverge_row(const FluxLaw& law, const Sides& flux_x, const Sides& flux_y, double dt, int count,
                 double* change) {
    HWY_DYNAMIC_DISPATCH(diverge_row)(law, flux_x, flux_y, dt, count, change);
}

void incise_row(const double* flux, double dt, int count, double* change) {
    HWY_DYNAMIC_DISPATCH(incise_row)(flux, dt, count, change);
}

void incise_downhill_row(const double* flux, const double* drop, double dt, int count,
                         double* change) {
    HWY_DYNAMIC_DISPATCH(incise_downhill_row)(flux, drop, dt, count, change);
}

void settle_downhill_row(const FluxLaw& law, const double* here, const Sides& bed,
                         const double* flux_x_here, const Sides& flux_x, const double* flux_y_here,
                         const Sides& flux_y, double dt, int count, double* change) {
    HWY_DYNAMIC_DISPATCH(settle_downhill_row)
    (law, here, bed, flux_x_here, flux_x, flux_y_here, flux_y, dt, count, change);
}

void hold_between_neighbours(const FluxLaw& law, const double* here, const Sides& bed, int count,
                             double* change) {
    HWY_DYNAMIC_DISPATCH(hold_between_neighbours)(law, here, bed, count, change);
}

double row_sum(const double* values, int count) {
    return HWY_DYNAMIC_DISPATCH(row_sum)(values, count);
}

}  // namespace fumon::sediment
#endif
