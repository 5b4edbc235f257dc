#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/finite_volume_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/finite_volume_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::finite_volume {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

constexpr double speed_floor = 1e-300;

struct LoadCells {
    SourceRow from;
    double sign_y;
    LoadedRow to;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto depth = hn::LoadU(d, from.depth + k);
        hn::StoreU(depth, d, to.depth + k);
        hn::StoreU(depth + hn::LoadU(d, from.bed + k), d, to.surface + k);
        hn::StoreU(hn::LoadU(d, from.velocity_x + k), d, to.velocity_x + k);
        hn::StoreU(hn::Set(d, sign_y) * hn::LoadU(d, from.velocity_y + k), d, to.velocity_y + k);
        hn::StoreU(hn::Set(d, 1.0), d, to.inside + k);
    }
};

/// Takes from a face's level what a partly wet cell's lies over the water's plane
/// (shore_vectors.h), and raises that of a dry cell to the cell's middle; both but for the velocity
/// head.
template <class V>
HWY_INLINE V level_at_shore(V level, V half_slope, V depth, V surface, V head) {
    const V zero = constant<V>(0.0);
    const V over = larger(hn::Abs(half_slope) - depth, zero);
    const V lift = over * over / larger(constant<V>(4.0) * depth, constant<V>(speed_floor));
    const auto is_wet = hn::Gt(depth, constant<V>(dry_depth));
    return hn::IfThenElse(is_wet, level - smaller(lift, head), larger(level, surface - head));
}

/// Where `only_bed`, the bed's own steps alone stop water; where `partly_wet`, a shore lies within
/// its cell.
template <bool only_bed, bool partly_wet>
struct FaceFluxes {
    CellRow l;
    HalfSlopes ls;
    CellRow r;
    HalfSlopes rs;
    double gravity;
    Fluxes out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        const V half = hn::Set(d, 0.5);
        const V two = hn::Set(d, 2.0);
        const V g = hn::Set(d, gravity);
        const V middle_l = hn::LoadU(d, l.depth + k);
        const V middle_r = hn::LoadU(d, r.depth + k);
        const V surface_at_l = hn::LoadU(d, l.surface + k);
        const V surface_at_r = hn::LoadU(d, r.surface + k);
        V depth_l = middle_l + hn::LoadU(d, ls.depth + k);
        V depth_r = middle_r - hn::LoadU(d, rs.depth + k);
        V level_l = surface_at_l + hn::LoadU(d, ls.surface + k);
        V level_r = surface_at_r - hn::LoadU(d, rs.surface + k);
        if constexpr (partly_wet) {
            const auto squared_speed = [&](const CellRow& cell) HWY_ATTR {
                const V u = hn::LoadU(d, cell.normal + k);
                const V v = hn::LoadU(d, cell.transverse + k);
                return u * u + v * v;
            };
            const V head = larger(squared_speed(l), squared_speed(r)) * hn::Set(d, 0.5 / gravity);
            level_l =
                level_at_shore(level_l, hn::LoadU(d, ls.depth + k), middle_l, surface_at_l, head);
            level_r =
                level_at_shore(level_r, hn::LoadU(d, rs.depth + k), middle_r, surface_at_r, head);
            depth_l = larger(depth_l, zero);
            depth_r = larger(depth_r, zero);
        }
        const V ground_l = level_l - depth_l;
        const V ground_r = level_r - depth_r;
        const auto outside_l = hn::Eq(hn::LoadU(d, l.inside + k), zero);
        const auto outside_r = hn::Eq(hn::LoadU(d, r.inside + k), zero);
        const V bed_l = hn::IfThenElse(outside_l, ground_r, ground_l);
        const V bed_r = hn::IfThenElse(outside_r, ground_l, ground_r);
        const V surface_l = hn::IfThenElse(outside_l, ground_r, level_l);
        const V surface_r = hn::IfThenElse(outside_r, ground_l, level_r);

        // Hydrostatic reconstruction (Audusse et al. 2004; Chen & Noelle 2017): with surfaces e and
        // beds z, z* = min(max(z_l, z_r), min(e_l, e_r)), h* = min(e - z*, h).
        const V step = smaller(larger(bed_l, bed_r), smaller(surface_l, surface_r));
        const V above_l = surface_l - step;
        const V above_r = surface_r - step;
        const V hl = smaller(above_l, depth_l);
        const V hr = smaller(above_r, depth_r);

        // HLLC (Toro 2001) with the wave speeds of two rarefactions:
        //     u* = (u_l + u_r)/2 + c_l - c_r,        c* = (c_l + c_r)/2 + (u_l - u_r)/4,
        //     S_l = min(u_l - c_l, u* - c*, 0),      S_r = max(u_r + c_r, u* + c*, 0).
        // A dry side has the velocity of the front, u_r - 2 c_r or u_l + 2 c_l.
        const V cl = hn::Sqrt(g * hl);
        const V cr = hn::Sqrt(g * hr);
        const V un_l = hn::LoadU(d, l.normal + k) + hn::LoadU(d, ls.normal + k);
        const V un_r = hn::LoadU(d, r.normal + k) - hn::LoadU(d, rs.normal + k);
        const V front_l = un_r - two * cr;
        const V front_r = un_l + two * cl;
        const V ul = hn::IfThenElse(hn::Gt(hl, zero), un_l, front_l);
        const V ur = hn::IfThenElse(hn::Gt(hr, zero), un_r, front_r);
        const V u_star = half * (ul + ur) + (cl - cr);
        const V c_star = half * (cl + cr) + hn::Set(d, 0.25) * (ul - ur);
        const V slowest = smaller(smaller(ul - cl, u_star - c_star), zero);
        const V quickest = larger(larger(ur + cr, u_star + c_star), zero);
        const V share = hn::Set(d, 1.0) / larger(quickest - slowest, hn::Set(d, speed_floor));

        // Mass and normal momentum are HLL's, (S_r F_l - S_l F_r + S_l S_r (U_r - U_l)) / (S_r -
        // S_l), the momentum without each cell's own pressure g h*^2/2; the transverse velocity is
        // that of the side from which the mass comes, as behind HLLC's contact wave.
        const V ql = hl * ul;
        const V qr = hr * ur;
        const V both = slowest * quickest;
        const V mass = ((quickest * ql - slowest * qr) + both * (hr - hl)) * share;
        const V carried = (quickest * (ql * ul) - slowest * (qr * ur)) + both * (qr - ql);
        const V half_gravity = half * g;
        const V pressure_rise = half_gravity * ((hr - hl) * (hr + hl));
        // What a step of the bed does: the weight of the water that falls down it, g/2 (h + h*)
        // (h* - (e - z*)), and the momentum of water that it stops (see the header).
        V falling_l = depth_l + hl;
        V falling_r = depth_r + hr;
        if constexpr (partly_wet) {  // a thin cell may be deep at its face
            falling_l = smaller(falling_l, hn::Set(d, 4.0) * middle_l);
            falling_r = smaller(falling_r, hn::Set(d, 4.0) * middle_r);
        }
        const V fall_l = half_gravity * (falling_l * (hl - above_l));
        const V fall_r = half_gravity * (falling_r * (hr - above_r));
        const V against_l = larger(un_l, zero);
        const V against_r = smaller(un_r, zero);
        V blocked_l = depth_l - hl;
        V blocked_r = depth_r - hr;
        if constexpr (only_bed) {
            const V end_l = (surface_at_l - middle_l) + hn::LoadU(d, ls.bed + k);
            const V end_r = (surface_at_r - middle_r) - hn::LoadU(d, rs.bed + k);
            const V rise = end_r - end_l;
            blocked_l = larger(smaller(blocked_l - hl, rise), zero);
            blocked_r = larger(smaller(blocked_r - hr, zero - rise), zero);
        }
        const V stopped_l = blocked_l * (against_l * against_l);
        const V stopped_r = blocked_r * (against_r * against_r);
        const V along_l = hn::LoadU(d, l.transverse + k) + hn::LoadU(d, ls.transverse + k);
        const V along_r = hn::LoadU(d, r.transverse + k) - hn::LoadU(d, rs.transverse + k);
        hn::StoreU(mass, d, out.mass + k);
        hn::StoreU((carried - slowest * pressure_rise) * share + (fall_l + stopped_l), d,
                   out.left + k);
        hn::StoreU((carried - quickest * pressure_rise) * share + (fall_r + stopped_r), d,
                   out.right + k);
        hn::StoreU(larger(mass, zero) * along_l + smaller(mass, zero) * along_r, d,
                   out.transverse + k);
    }
};

struct Outward {
    const double* mass_west;
    const double* mass_east;
    const double* mass_south;
    const double* mass_north;
    double dt_dx;
    double dt_dy;

    template <class D>
    HWY_INLINE hn::Vec<D> operator()(D d, std::size_t k) const {
        const auto zero = hn::Zero(d);
        const auto gone = [&](const double* forward, const double* back) HWY_ATTR {
            return larger(hn::LoadU(d, forward + k), zero) - smaller(hn::LoadU(d, back + k), zero);
        };
        return hn::Set(d, dt_dx) * gone(mass_east, mass_west) +
               hn::Set(d, dt_dy) * gone(mass_north, mass_south);
    }
};

struct ShortOfWater {
    Outward outward;
    const double* depth;
    bool* found;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto asks_more = hn::Gt(outward(d, k), hn::LoadU(d, depth + k));
        *found = *found | !hn::AllFalse(d, asks_more);
    }
};

struct PayableShares {
    Outward outward;
    const double* depth;
    double* shares;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto out = outward(d, k);
        const auto there = hn::LoadU(d, depth + k);
        const auto share = hn::IfThenElse(hn::Gt(out, there), there / out, hn::Set(d, 1.0));
        hn::StoreU(share, d, shares + k);
    }
};

struct CutToShares {
    Fluxes fluxes;
    const double* left_shares;
    const double* right_shares;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto mass = hn::LoadU(d, fluxes.mass + k);
        const auto share = hn::IfThenElse(hn::Gt(mass, hn::Zero(d)), hn::LoadU(d, left_shares + k),
                                          hn::LoadU(d, right_shares + k));
        hn::StoreU(mass * share, d, fluxes.mass + k);
        for (double* flux : {fluxes.left, fluxes.right, fluxes.transverse})
            hn::StoreU(hn::LoadU(d, flux + k) * share, d, flux + k);
    }
};

/// The rate of the Courant condition, (|u| + c)/dx + (|v| + c)/dy with c = √(g h).
/// Rates as whole numbers: positive doubles order as their bits do, and NaN is above them all.
/// Where `has_factors`, dx and dy are powers of two, by whose inverses a product has the same bits.
template <bool has_factors>
struct Rates {
    const double* depth;
    const double* velocity_x;
    const double* velocity_y;
    double gravity;
    double dx;
    double dy;

    template <class D>
    HWY_INLINE hn::Vec<hn::RebindToSigned<D>> operator()(D d, std::size_t k) const {
        const auto c = hn::Sqrt(hn::Set(d, gravity) * hn::LoadU(d, depth + k));
        const auto over = [&](auto speed, double length) HWY_ATTR {
            if constexpr (has_factors) {
                return speed * hn::Set(d, 1.0 / length);
            } else {
                return speed / hn::Set(d, length);
            }
        };
        const auto rate = over(hn::Abs(hn::LoadU(d, velocity_x + k)) + c, dx) +
                          over(hn::Abs(hn::LoadU(d, velocity_y + k)) + c, dy);
        return hn::BitCast(hn::RebindToSigned<D>(), hn::Abs(rate));
    }
};

void load_cells(const SourceRow& from, double sign_y, const LoadedRow& to, int count) {
    for_each_vector_overlapping(count, LoadCells{from, sign_y, to});
}

template <bool partly_wet>
HWY_INLINE void compute_fluxes(const CellRow& left, const HalfSlopes& left_slopes,
                               const CellRow& right, const HalfSlopes& right_slopes, double gravity,
                               const Fluxes& out, int count) {
    if (left_slopes.bed != nullptr) {
        for_each_vector_overlapping(
            count,
            FaceFluxes<true, partly_wet>{left, left_slopes, right, right_slopes, gravity, out});
    } else {
        for_each_vector_overlapping(
            count,
            FaceFluxes<false, partly_wet>{left, left_slopes, right, right_slopes, gravity, out});
    }
}

void face_fluxes(const CellRow& left, const HalfSlopes& left_slopes, const CellRow& right,
                 const HalfSlopes& right_slopes, double gravity, bool partly_wet, const Fluxes& out,
                 int count) {
    if (partly_wet) {
        compute_fluxes<true>(left, left_slopes, right, right_slopes, gravity, out, count);
    } else {
        compute_fluxes<false>(left, left_slopes, right, right_slopes, gravity, out, count);
    }
}

bool payable_shares(const double* depth, const double* mass_west, const double* mass_east,
                    const double* mass_south, const double* mass_north, double dt_dx, double dt_dy,
                    double* shares, int count) {
    bool is_short = false;
    const Outward outward{mass_west, mass_east, mass_south, mass_north, dt_dx, dt_dy};
    for_each_vector_overlapping(count, ShortOfWater{outward, depth, &is_short});
    if (is_short) for_each_vector_overlapping(count, PayableShares{outward, depth, shares});
    return is_short;
}

void cut_to_shares(const Fluxes& fluxes, const double* left_shares, const double* right_shares,
                   int count) {
    for_each_vector(count, CutToShares{fluxes, left_shares, right_shares});
}

template <class RatesOf>
HWY_INLINE double largest_rate(const RatesOf& rates, int count) {
    const Doubles doubles;
    const hn::RebindToSigned<Doubles> whole;
    const hn::CappedTag<double, 1> one;
    constexpr std::size_t lanes = hn::MaxLanes(doubles);
    const auto cells = static_cast<std::size_t>(count);
    auto most = hn::Zero(whole);
    std::size_t k = 0;
    for (; k + lanes <= cells; k += lanes) {
        const auto bits = rates(doubles, k);
        most = hn::IfThenElse(hn::Gt(bits, most), bits, most);
    }
    HWY_ALIGN std::int64_t some[lanes];
    hn::Store(most, whole, some);
    std::int64_t found = 0;
    for (const std::int64_t bits : some) found = bits > found ? bits : found;
    for (; k < cells; ++k) {
        const std::int64_t bits = hn::GetLane(rates(one, k));
        found = bits > found ? bits : found;
    }
    return std::bit_cast<double>(found);
}

bool is_power_of_two(double length) {
    constexpr std::uint64_t mantissa_bits = 0x000fffffffffffff;
    return (std::bit_cast<std::uint64_t>(length) & mantissa_bits) == 0;
}

double fastest(const double* depth, const double* velocity_x, const double* velocity_y,
               double gravity, double dx, double dy, int count) {
    if (is_power_of_two(dx) && is_power_of_two(dy)) {
        return largest_rate(Rates<true>{depth, velocity_x, velocity_y, gravity, dx, dy}, count);
    }
    return largest_rate(Rates<false>{depth, velocity_x, velocity_y, gravity, dx, dy}, count);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::finite_volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::finite_volume {

HWY_EXPORT(load_cells);
HWY_EXPORT(face_fluxes);
HWY_EXPORT(payable_shares);
HWY_EXPORT(cut_to_shares);
HWY_EXPORT(fastest);

void load_cells(const SourceRow& from, double sign_y, const LoadedRow& to, int count) {
    HWY_DYNAMIC_DISPATCH(load_cells)(from, sign_y, to, count);
}

void face_fluxes(const CellRow& left, const HalfSlopes& left_slopes, const CellRow& right,
                 const HalfSlopes& right_slopes, double gravity, bool partly_wet, const Fluxes& out,
                 int count) {
    HWY_DYNAMIC_DISPATCH(face_fluxes)
    (left, left_slopes, right, right_slopes, gravity, partly_wet, out, count);
}

bool payable_shares(const double* depth, const double* mass_west, const double* mass_east,
                    const double* mass_south, const double* mass_north, double dt_dx, double dt_dy,
                    double* shares, int count) {
    return HWY_DYNAMIC_DISPATCH(payable_shares)(depth, mass_west, mass_east, mass_south, mass_north,
                                                dt_dx, dt_dy, shares, count);
}

void cut_to_shares(const Fluxes& fluxes, const double* left_shares, const double* right_shares,
                   int count) {
    HWY_DYNAMIC_DISPATCH(cut_to_shares)(fluxes, left_shares, right_shares, count);
}

double fastest(const double* depth, const double* velocity_x, const double* velocity_y,
               double gravity, double dx, double dy, int count) {
    return HWY_DYNAMIC_DISPATCH(fastest)(depth, velocity_x, velocity_y, gravity, dx, dy, count);
}

}  // namespace fumon::finite_volume
#endif
