#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/air/grain_lanes_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <cstddef>
#include <cstdint>

#include "models/air/grain_lanes_vectors.h"
#include "vectors/functions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

using Indices = hn::RebindToSigned<Doubles>;

/// Within [0, high]; 0 for what is not a number.
HWY_INLINE Vector within(Vector value, Vector high) {
    return lesser(greater(value, hn::Zero(Doubles())), high);
}

HWY_INLINE Vector mixed(Vector a, Vector b, Vector share) {
    return a + share * (b - a);
}

/// Of whole numbers from 0 to 2^51: the low bits of their sums with 2^52.
HWY_INLINE hn::Vec<Indices> index_of(Vector whole) {
    constexpr double two_to_52 = 0x1p52;
    const Indices indices;
    const auto sum = hn::BitCast(indices, whole + constant(two_to_52));
    return hn::Xor(sum, hn::BitCast(indices, constant(two_to_52)));
}

/// drag::short_log_of_normal.
HWY_INLINE Vector short_log_of_normal(Vector x) {
    using namespace elementary::detail;
    const auto parts = vectors::HWY_NAMESPACE::parts_of_normal(x);
    const Vector f = parts.mantissa - constant(1.0);
    const Vector s = f / (constant(2.0) + f);
    const Vector z = s * s;
    const Vector tail = vectors::HWY_NAMESPACE::artanh_tail(constant(2.0 / 23.0), z);
    const Vector low = parts.k * constant(ln2_low) + s * (z * tail);
    return parts.k * constant(ln2_high) + (low + constant(2.0) * s);
}

/// drag::schiller_naumann_factor.
HWY_INLINE Vector schiller_naumann_factor(Vector reynolds_squared) {
    constexpr double smallest = 1e-60;
    constexpr double half_exponent = 0.687 / 2.0;
    const Vector log = short_log_of_normal(greater(reynolds_squared, constant(smallest)));
    const Vector power = vectors::HWY_NAMESPACE::exp(constant(half_exponent) * log);
    return constant(1.0) + constant(0.15) * power;
}

struct Nodes {
    hn::Vec<Indices> west_below;
    std::ptrdiff_t stride;
    Vector east;
    Vector up;

    /// Bilinear between the four nodes of each lane's cell.
    HWY_INLINE Vector between(const double* field) const {
        const Doubles d;
        const auto at = [&](const double* first)
                            HWY_ATTR { return hn::GatherIndex(d, first, west_below); };
        const Vector below = mixed(at(field), at(field + 1), east);
        const Vector above = mixed(at(field + stride), at(field + stride + 1), east);
        return mixed(below, above, up);
    }
};

/// One step of the lanes from `first` on.
template <bool beyond_stokes>
HWY_INLINE void advance_vector(GrainLanes& lanes, const LaneAir& air, std::size_t first) {
    const Doubles d;
    const Vector zero = hn::Zero(d);
    const Vector one = constant(1.0);
    const Vector width = constant(air.nx * air.dx);
    const Vector dt = constant(air.time_step);
    const auto load = [&](const GrainLanes::Values& values)
                          HWY_ATTR { return hn::Load(d, values.data() + first); };
    const auto store = [&](Vector value, GrainLanes::Values& values)
                           HWY_ATTR { hn::Store(value, d, values.data() + first); };

    const Vector moves = load(lanes.flying);
    const Vector vx = load(lanes.speed_x);
    const Vector vz = load(lanes.speed_z);
    const Vector flown = load(lanes.x) + moves * (dt * vx);
    const Vector z = load(lanes.z) + moves * (dt * vz);
    const Vector turned_east = hn::IfThenElseZero(hn::Ge(flown, width), one);
    const Vector turned_west = hn::IfThenElseZero(hn::Lt(flown, zero), one);
    const Vector turned = turned_east - turned_west;
    const Vector x = flown - turned * width;

    const Vector column = within(x * constant(1.0 / air.dx), constant(air.nx));
    const Vector i = hn::Trunc(column);
    const Vector east = column - i;
    const hn::Vec<Indices> bed_at = index_of(i);
    const Vector ground =
        mixed(hn::GatherIndex(d, air.bed, bed_at), hn::GatherIndex(d, air.bed + 1, bed_at), east);
    const Vector row = within(z * constant(1.0 / air.dz), constant(air.nz - 1));
    const Vector k = hn::Trunc(row);
    const int stride = air.nx + 2;
    const Nodes nodes{index_of(k * constant(stride) + i), stride, east, row - k};

    const Vector slip_x = vx - nodes.between(air.velocity_x);
    const Vector slip_z = vz - nodes.between(air.velocity_z);
    const Vector slip = slip_x * slip_x + slip_z * slip_z;
    Vector drag = constant(air.rate);
    if constexpr (beyond_stokes)
        drag = drag * schiller_naumann_factor(constant(air.reynolds_scale) * slip);

    const Vector lid = constant((air.nz - 1) * air.dz);
    const Vector above_bed = hn::IfThenElse(hn::Le(z, ground), zero, one);
    const Vector below_lid = hn::IfThenElse(hn::Gt(z, lid), zero, one);
    const Vector goes_on = moves * (above_bed * below_lid);
    store(x, lanes.x);
    store(z, lanes.z);
    store(load(lanes.turns) + turned, lanes.turns);
    store(load(lanes.steps) + moves, lanes.steps);
    store(vx - goes_on * (dt * (drag * slip_x)), lanes.speed_x);
    store(vz - goes_on * (dt * (constant(air.gravity) + drag * slip_z)), lanes.speed_z);
    store(greater(load(lanes.fastest), goes_on * slip), lanes.fastest);
    store(goes_on, lanes.flying);
}

template <bool beyond_stokes>
HWY_INLINE void advance_lanes(GrainLanes& lanes, const LaneAir& air, int count, int steps) {
    constexpr std::size_t width = hn::MaxLanes(Doubles());
    static_assert(GrainLanes::most % width == 0);
    for (int step = 0; step < steps; ++step) {
        for (std::size_t first = 0; first < static_cast<std::size_t>(count); first += width)
            advance_vector<beyond_stokes>(lanes, air, first);
    }
}

void advance_stokes(GrainLanes& lanes, const LaneAir& air, int count, int steps) {
    advance_lanes<false>(lanes, air, count, steps);
}

void advance_schiller_naumann(GrainLanes& lanes, const LaneAir& air, int count, int steps) {
    advance_lanes<true>(lanes, air, count, steps);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon {

HWY_EXPORT(advance_stokes);
HWY_EXPORT(advance_schiller_naumann);

void advance_stokes(GrainLanes& lanes, const LaneAir& air, int count, int steps) {
    HWY_DYNAMIC_DISPATCH(advance_stokes)(lanes, air, count, steps);
}

void advance_schiller_naumann(GrainLanes& lanes, const LaneAir& air, int count, int steps) {
    HWY_DYNAMIC_DISPATCH(advance_schiller_naumann)(lanes, air, count, steps);
}

}  // namespace fumon
#endif
