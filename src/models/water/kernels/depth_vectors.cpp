#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/depth_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/depth_vectors.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::cip {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

/// As published: h = h* − dt h ∇·u + dt·rain with h* advected by CIP.
struct Thin {
    const double* depth;
    const double* advected;
    Stencil u;
    Stencil v;
    double half_x;
    double half_y;
    double fallen;
    double* after;
    double* gained;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto spread_x = hn::LoadU(d, u.here + x + 1) - hn::LoadU(d, u.here + x - 1);
        const auto spread_y = hn::LoadU(d, v.north + x) - hn::LoadU(d, v.south + x);
        const auto spread = hn::Set(d, half_x) * spread_x + hn::Set(d, half_y) * spread_y;
        const auto gain = hn::Set(d, fallen) - hn::LoadU(d, depth + x) * spread;
        hn::StoreU(gain, d, gained + x);
        hn::StoreU(hn::LoadU(d, advected + x) + gain, d, after + x);
    }
};

/// With ν = u dt/dx at the face, ν (h_up + (sgn ν − ν)/2 · δ): Lax & Wendroff's second order in
/// space and time, limited by van Leer's (1977) monotonised central difference δ.
struct ThroughFaces {
    FaceCells c;
    double per_cell;
    double* faces;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        using V = hn::Vec<D>;
        const V zero = hn::Zero(d);
        const V half = hn::Set(d, 0.5);
        const V two = hn::Set(d, 2.0);
        const V one = hn::Set(d, 1.0);
        const V shift = hn::Set(d, 0.5 * per_cell) *
                        (hn::LoadU(d, c.speed_here + x) + hn::LoadU(d, c.speed_next + x));
        const auto onward = hn::Gt(shift, zero);
        const V here = hn::LoadU(d, c.depth_here + x);
        const V next = hn::LoadU(d, c.depth_next + x);
        const V rise = next - here;
        const V behind = hn::IfThenElse(onward, here - hn::LoadU(d, c.depth_before + x),
                                        hn::LoadU(d, c.depth_after + x) - next);
        const V twice = two * hn::IfThenElse(hn::Lt(behind * behind, rise * rise), behind, rise);
        const V middle = half * (behind + rise);
        const V steep = hn::IfThenElse(hn::Lt(twice * twice, middle * middle), twice, middle);
        const V limited = hn::IfThenElseZero(hn::Gt(behind * rise, zero), steep);
        const V reach = hn::IfThenElse(onward, one, hn::Neg(one)) - shift;
        const V upwind = hn::IfThenElse(onward, here, next);
        hn::StoreU(shift * (upwind + half * reach * limited), d, faces + x);
    }
};

/// A depth that is not a number does not count as short of water.
struct Settle {
    const double* before;
    const double* faces_x;
    const double* faces_south;
    const double* faces_north;
    double rain;
    double* after;
    bool* overdrawn;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto along_x = hn::LoadU(d, faces_x + x - 1) - hn::LoadU(d, faces_x + x);
        const auto along_y = hn::LoadU(d, faces_south + x) - hn::LoadU(d, faces_north + x);
        const auto depth = (hn::LoadU(d, before + x) + hn::Set(d, rain)) + (along_x + along_y);
        *overdrawn = *overdrawn | !hn::AllFalse(d, hn::Lt(depth, hn::Zero(d)));
        hn::StoreU(depth, d, after + x);
    }
};

void thin_row(const double* depth, const double* advected, const Stencil& u, const Stencil& v,
              const SubStep& step, double rain, int count, double* after, double* gained) {
    for_each_vector(count, Thin{depth, advected, u, v, 0.5 * step.dt / step.dx,
                                0.5 * step.dt / step.dy, step.dt * rain, after, gained});
}

void through_faces(const FaceCells& cells, double per_cell, int count, double* faces) {
    for_each_vector_overlapping(count, ThroughFaces{cells, per_cell, faces});
}

bool settle_row(const double* before, const double* faces_x, const double* faces_south,
                const double* faces_north, double rain, int count, double* after) {
    bool overdrawn = false;
    for_each_vector_overlapping(
        count, Settle{before, faces_x, faces_south, faces_north, rain, after, &overdrawn});
    return overdrawn;
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::cip
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::cip {

HWY_EXPORT(thin_row);
HWY_EXPORT(through_faces);
HWY_EXPORT(settle_row);

void thin_row(const double* depth, const double* advected, const Stencil& u, const Stencil& v,
              const SubStep& step, double rain, int count, double* after, double* gained) {
    HWY_DYNAMIC_DISPATCH(thin_row)(depth, advected, u, v, step, rain, count, after, gained);
}

void through_faces(const FaceCells& cells, double per_cell, int count, double* faces) {
    HWY_DYNAMIC_DISPATCH(through_faces)(cells, per_cell, count, faces);
}

bool settle_row(const double* before, const double* faces_x, const double* faces_south,
                const double* faces_north, double rain, int count, double* after) {
    return HWY_DYNAMIC_DISPATCH(settle_row)(before, faces_x, faces_south, faces_north, rain, count,
                                            after);
}

}  // namespace fumon::cip
#endif
