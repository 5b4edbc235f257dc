#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/water/kernels/speed_bound_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include "models/water/kernels/speed_bound_vectors.h"
#include "vectors/functions-inl.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::finite_volume {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

struct LargestInvariants {
    CellRow cells;
    double gravity;
    double* out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        const auto u = hn::LoadU(d, cells.normal + k);
        const auto v = hn::LoadU(d, cells.transverse + k);
        const auto c = hn::Sqrt(hn::Set(d, gravity) * hn::LoadU(d, cells.depth + k));
        hn::StoreU(hn::Sqrt(u * u + v * v) + hn::Set(d, 2.0) * c, d, out + k);
    }
};

/// max(|u| + 2√(g h)) + dt·g·|∇z| over a cell and the four beside it: Riemann invariants of the
/// exact flow, and what the bed's slope adds within a step.
struct BoundSpeeds {
    RowsAround rows;
    BoundFactors f;
    SpeedBounds out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t k) const {
        using V = hn::Vec<D>;
        const auto load = [&](const double* from) HWY_ATTR { return hn::LoadU(d, from); };
        const auto bed = [&](const CellRow& row, std::size_t at)
                             HWY_ATTR { return load(row.surface + at) - load(row.depth + at); };
        const V own_bed = bed(rows.here.cells, k + 1);
        const auto step = [&](const CellRow& row, std::size_t at) HWY_ATTR {
            return hn::Abs(bed(row, at) - own_bed) * load(row.inside + at);
        };
        const V step_x = larger(step(rows.here.cells, k), step(rows.here.cells, k + 2));
        const V step_y = larger(step(rows.south.cells, k + 1), step(rows.north.cells, k + 1));
        const V beside_x = larger(load(rows.here.largest + k), load(rows.here.largest + k + 2));
        const V beside_y =
            larger(load(rows.south.largest + k + 1), load(rows.north.largest + k + 1));
        const V largest = larger(larger(beside_x, beside_y), load(rows.here.largest + k + 1));
        const V slope_x = step_x * hn::Set(d, 1.0 / f.dx);
        const V slope_y = step_y * hn::Set(d, 1.0 / f.dy);
        const V pulled =
            hn::Set(d, f.dt * f.gravity) * hn::Sqrt(slope_x * slope_x + slope_y * slope_y);
        hn::StoreU(largest + (pulled + hn::Set(d, f.pulled)), d, out.speed + k);
        hn::StoreU(larger(step_x, step_y), d, out.thin + k);
    }
};

void largest_invariants(const CellRow& cells, double gravity, double* out, int count) {
    for_each_vector_overlapping(count, LargestInvariants{cells, gravity, out});
}

void speed_bounds(const RowsAround& rows, const BoundFactors& factors, const SpeedBounds& out,
                  int count) {
    for_each_vector_overlapping(count, BoundSpeeds{rows, factors, out});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::finite_volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::finite_volume {

HWY_EXPORT(largest_invariants);
HWY_EXPORT(speed_bounds);

void largest_invariants(const CellRow& cells, double gravity, double* out, int count) {
    HWY_DYNAMIC_DISPATCH(largest_invariants)(cells, gravity, out, count);
}

void speed_bounds(const RowsAround& rows, const BoundFactors& factors, const SpeedBounds& out,
                  int count) {
    HWY_DYNAMIC_DISPATCH(speed_bounds)(rows, factors, out, count);
}

}  // namespace fumon::finite_volume
#endif
