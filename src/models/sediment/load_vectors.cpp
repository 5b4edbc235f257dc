#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/sediment/load_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/sediment/load_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::loads {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

constexpr double speed_floor = 1e-150;
constexpr double least_stress = 1e-30;    // θ: below it nothing moves
constexpr double least_threshold = 1e-3;  // of θ_c down a slope, over θ_c
constexpr double surely_less = 0.999;     // whatever is rounded

struct Concentrate {
    const double* load;
    const double* depth;
    double* concentration;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto deep = larger(hn::LoadU(d, depth + x), hn::Set(d, thin_water));
        hn::StoreU(hn::LoadU(d, load + x) / deep, d, concentration + x);
    }
};

template <bool averaged>
struct AdvectLoad {
    AdvectedRow r;
    const double* load;
    const double* before;
    double dt_dx;
    double dt_dy;
    double* carried;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto zero = hn::Zero(d);
        const auto here = hn::LoadU(d, r.here + x);
        const auto through = [&](const double* flow, auto low, auto high) HWY_ATTR {
            const auto q = hn::LoadU(d, flow + x);
            return larger(q, zero) * low + smaller(q, zero) * high;
        };
        const auto west = through(r.flow_west, hn::LoadU(d, r.here - 1 + x), here);
        const auto east = through(r.flow_east, here, hn::LoadU(d, r.here + 1 + x));
        const auto south = through(r.flow_south, hn::LoadU(d, r.south + x), here);
        const auto north = through(r.flow_north, here, hn::LoadU(d, r.north + x));
        const auto lost = hn::Set(d, dt_dx) * (east - west) + hn::Set(d, dt_dy) * (north - south);
        auto after = hn::LoadU(d, load + x) - lost;
        if constexpr (averaged) after = hn::Set(d, 0.5) * (hn::LoadU(d, before + x) + after);
        hn::StoreU(after, d, carried + x);
    }
};

template <bool manning, bool bed_load, bool entrains>
struct PickUp {
    PickUpLaw law;
    PickUpRow r;
    double per_length;
    double per_area;
    PickedUp out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        const V one = hn::Set(d, 1.0);
        const V h = hn::LoadU(d, r.depth + x);
        const V u = hn::LoadU(d, r.u + x);
        const V v = hn::LoadU(d, r.v + x);
        const V deep = larger(h, hn::Set(d, thin_water));
        const V square = u * u + v * v;
        V stress = hn::IfThenElseZero(hn::Gt(h, hn::Set(d, thin_water)), square);
        if constexpr (manning && entrains && !bed_load) {
            // Most water takes up nothing, which is seen without a root: τ < τ_e where
            // (friction · U² / (τ_e/ρ))³ < h.
            const V pull =
                stress * (hn::LoadU(d, r.friction + x) * hn::Set(d, law.per_entrainment_stress));
            const auto rests = hn::Lt(pull * pull * pull, hn::Set(d, surely_less) * deep);
            if (hn::AllTrue(d, rests)) {
                hn::StoreU(zero, d, out.entrainment + x);
                hn::StoreU(zero, d, out.bed_rate + x);
                return;
            }
        }
        if constexpr (manning) {
            const V third = hn::Set(d, -1.0 / 3.0);
            stress = stress * hn::LoadU(d, r.friction + x) *
                     vectors::HWY_NAMESPACE::exp(third * log_of_normal(deep));
        } else {
            stress = stress * hn::LoadU(d, r.friction + x);
        }
        V bed_rate = zero;
        if constexpr (bed_load) {
            const V per_speed = one / larger(hn::Sqrt(square), hn::Set(d, speed_floor));
            const V ex = u * per_speed;
            const V ey = v * per_speed;
            const V rise_x = (hn::LoadU(d, r.bed + 1 + x) - hn::LoadU(d, r.bed - 1 + x)) *
                                 hn::Set(d, law.half_per_x) +
                             hn::Set(d, law.slope_x);
            const V rise_y = (hn::LoadU(d, r.bed_north + x) - hn::LoadU(d, r.bed_south + x)) *
                                 hn::Set(d, law.half_per_y) +
                             hn::Set(d, law.slope_y);
            const V uphill = (ex * rise_x + ey * rise_y) * hn::Set(d, law.per_tangent);
            const V theta = larger(stress * hn::Set(d, law.per_stress), hn::Set(d, least_stress));
            const V threshold =
                hn::Set(d, law.critical) * larger(one + uphill, hn::Set(d, least_threshold));
            const V above = larger(theta - threshold, zero);
            V amount = zero;
            if (law.ashida_michiue) {
                const V ratio = smaller(threshold / theta, one);
                amount = hn::Set(d, 17.0) * (theta * hn::Sqrt(theta)) * (one - ratio) *
                         (one - hn::Sqrt(ratio));
            } else {
                amount = hn::Set(d, 8.0) * (above * hn::Sqrt(above));
            }
            const V q = hn::Set(d, law.unit) * amount;
            const V down = hn::Set(d, law.turning) * q / hn::Sqrt(theta);
            hn::StoreU(q * ex, d, out.along_x + x);
            hn::StoreU(q * ey, d, out.along_y + x);
            hn::StoreU(down, d, out.down_slope + x);
            bed_rate =
                hn::Set(d, 3.0 * per_length) * (q / deep) + hn::Set(d, 2.0 * per_area) * down;
        }
        if constexpr (entrains) {
            const V excess = larger(stress * hn::Set(d, law.per_entrainment_stress) - one, zero);
            const V taken = hn::Set(d, law.entrainment) * excess;
            hn::StoreU(taken, d, out.entrainment + x);
            bed_rate = bed_rate + taken / (deep + hn::Set(d, 0.1 / per_length));
        }
        hn::StoreU(bed_rate, d, out.bed_rate + x);
    }
};

struct HoldAbove {
    const double* floor;
    const double* bed;
    double per_height;
    double* entrainment;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto above = hn::LoadU(d, bed + x) - hn::LoadU(d, floor + x);
        const auto most = hn::Set(d, per_height) * larger(above, hn::Zero(d));
        hn::StoreU(smaller(hn::LoadU(d, entrainment + x), most), d, entrainment + x);
    }
};

struct BedRate {
    const double* bed_rate;
    template <class D>
    HWY_INLINE auto operator()(D d, std::size_t x) const {
        return hn::LoadU(d, bed_rate + x);
    }
};

struct Face {
    FaceRow r;
    double per_length;
    double mean_slope;
    double* flux;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto zero = hn::Zero(d);
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from + x); };
        const auto with_flow = larger(load(r.along_low), zero) + smaller(load(r.along_high), zero);
        const auto rise =
            (load(r.bed_high) - load(r.bed_low)) * hn::Set(d, per_length) + hn::Set(d, mean_slope);
        const auto down = hn::Set(d, 0.5) * (load(r.down_low) + load(r.down_high));
        hn::StoreU(with_flow - down * rise, d, flux + x);
    }
};

template <bool entrains, bool bed_load>
struct Settle {
    SettledRow r;
    SettlingFactors f;
    double* load;
    double* bed;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        const V h = hn::LoadU(d, r.depth + x);
        const V before = hn::LoadU(d, load + x);
        V with_taken = before;
        if constexpr (entrains)
            with_taken = before + hn::Set(d, f.dt) * hn::LoadU(d, r.entrainment + x);
        const V deep = larger(h, hn::Set(d, thin_water));
        const V kept = with_taken * deep / (deep + hn::Set(d, f.dt * f.settling));
        const V counted = hn::IfThenZeroElse(hn::Lt(hn::Abs(kept), hn::Set(d, least_load)), kept);
        const V after = hn::IfThenElse(hn::Gt(h, hn::Set(d, thin_water)), counted, zero);
        V gain = before - after;
        if constexpr (bed_load) {
            gain = gain -
                   (hn::Set(d, f.dt_dx) * (hn::LoadU(d, r.east + x) - hn::LoadU(d, r.west + x)) +
                    hn::Set(d, f.dt_dy) * (hn::LoadU(d, r.north + x) - hn::LoadU(d, r.south + x)));
        }
        hn::StoreU(after, d, load + x);
        hn::StoreU(hn::LoadU(d, bed + x) + hn::Set(d, f.bed_factor) * gain, d, bed + x);
    }
};

void concentrate_row(const double* load, const double* depth, int count, double* concentration) {
    for_each_vector_overlapping(count, Concentrate{load, depth, concentration});
}

void advect_load_row(const AdvectedRow& row, const double* load, const double* before, double dt_dx,
                     double dt_dy, int count, double* carried) {
    if (before != nullptr) {
        for_each_vector(count, AdvectLoad<true>{row, load, before, dt_dx, dt_dy, carried});
    } else {
        for_each_vector(count, AdvectLoad<false>{row, load, before, dt_dx, dt_dy, carried});
    }
}

template <bool manning>
void pick_up(const PickUpLaw& law, const PickUpRow& row, double per_length, double per_area,
             int count, const PickedUp& out) {
    if (law.unit > 0.0 && law.entrainment > 0.0) {
        for_each_vector_overlapping(
            count, PickUp<manning, true, true>{law, row, per_length, per_area, out});
    } else if (law.unit > 0.0) {
        for_each_vector_overlapping(
            count, PickUp<manning, true, false>{law, row, per_length, per_area, out});
    } else {
        for_each_vector_overlapping(
            count, PickUp<manning, false, true>{law, row, per_length, per_area, out});
    }
}

void pick_up_row(const PickUpLaw& law, const PickUpRow& row, double per_length, double per_area,
                 int count, const PickedUp& out) {
    if (law.manning) {
        pick_up<true>(law, row, per_length, per_area, count, out);
    } else {
        pick_up<false>(law, row, per_length, per_area, count, out);
    }
}

void hold_above_row(const double* floor, const double* bed, double per_height, int count,
                    double* entrainment) {
    for_each_vector(count, HoldAbove{floor, bed, per_height, entrainment});
}

double largest_bed_rate(const double* bed_rate, int count) {
    return largest_of_row(count, BedRate{bed_rate});
}

void face_row(const FaceRow& row, double per_length, double mean_slope, int count, double* flux) {
    for_each_vector_overlapping(count, Face{row, per_length, mean_slope, flux});
}

void settle_row(const SettledRow& row, const SettlingFactors& factors, int count, double* load,
                double* bed) {
    const bool entrains = row.entrainment != nullptr;
    const bool bed_load = row.west != nullptr;
    if (entrains && bed_load) {
        for_each_vector(count, Settle<true, true>{row, factors, load, bed});
    } else if (bed_load) {
        for_each_vector(count, Settle<false, true>{row, factors, load, bed});
    } else if (entrains) {
        for_each_vector(count, Settle<true, false>{row, factors, load, bed});
    } else {
        for_each_vector(count, Settle<false, false>{row, factors, load, bed});
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::loads
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::loads {

HWY_EXPORT(concentrate_row);
HWY_EXPORT(advect_load_row);
HWY_EXPORT(pick_up_row);
HWY_EXPORT(hold_above_row);
HWY_EXPORT(largest_bed_rate);
HWY_EXPORT(face_row);
HWY_EXPORT(settle_row);

void concentrate_row(const double* load, const double* depth, int count, double* concentration) {
    HWY_DYNAMIC_DISPATCH(concentrate_row)(load, depth, count, concentration);
}

void advect_load_row(const AdvectedRow& row, const double* load, const double* before, double dt_dx,
                     double dt_dy, int count, double* carried) {
    HWY_DYNAMIC_DISPATCH(advect_load_row)(row, load, before, dt_dx, dt_dy, count, carried);
}

void pick_up_row(const PickUpLaw& law, const PickUpRow& row, double per_length, double per_area,
                 int count, const PickedUp& out) {
    HWY_DYNAMIC_DISPATCH(pick_up_row)(law, row, per_length, per_area, count, out);
}

void hold_above_row(const double* floor, const double* bed, double per_height, int count,
                    double* entrainment) {
    HWY_DYNAMIC_DISPATCH(hold_above_row)(floor, bed, per_height, count, entrainment);
}

double largest_bed_rate(const double* bed_rate, int count) {
    return HWY_DYNAMIC_DISPATCH(largest_bed_rate)(bed_rate, count);
}

void face_row(const FaceRow& row, double per_length, double mean_slope, int count, double* flux) {
    HWY_DYNAMIC_DISPATCH(face_row)(row, per_length, mean_slope, count, flux);
}

void settle_row(const SettledRow& row, const SettlingFactors& factors, int count, double* load,
                double* bed) {
    HWY_DYNAMIC_DISPATCH(settle_row)(row, factors, count, load, bed);
}

}  // namespace fumon::loads
#endif
