#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "models/shared/bed_diffusion_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <algorithm>

#include "models/shared/bed_diffusion_vectors.h"
#include "vectors/rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::bed_diffusion {
namespace HWY_NAMESPACE {

using namespace vectors::HWY_NAMESPACE;

struct ExplicitY {
    const double* south;
    const double* here;
    const double* north;
    const double* change;
    double r;
    double* out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto middle = hn::LoadU(d, here + x);
        const auto bent = (hn::LoadU(d, south + x) - middle) + (hn::LoadU(d, north + x) - middle);
        hn::StoreU((middle + hn::LoadU(d, change + x)) + hn::Set(d, r) * bent, d, out + x);
    }
};

template <class D>
HWY_INLINE auto with_diffusion_x(D d, const double* from, double r) {
    const auto middle = hn::LoadU(d, from);
    const auto bent = (hn::LoadU(d, from - 1) - middle) + (hn::LoadU(d, from + 1) - middle);
    return middle + hn::Set(d, r) * bent;
}

struct ExplicitX {
    const double* from;
    double r;
    double* to;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        hn::StoreU(with_diffusion_x(d, from + x, r), d, to + x);
    }
};

/// (what explicit_x gives + r·previous) · inverse.
struct Eliminate {
    const double* from;
    double r_x;
    const double* previous;
    double r;
    double inverse;
    double* row;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto known = with_diffusion_x(d, from + x, r_x);
        const auto sum = known + hn::Set(d, r) * hn::LoadU(d, previous + x);
        hn::StoreU(sum * hn::Set(d, inverse), d, row + x);
    }
};

/// values + factor · others.
struct AddMultiple {
    const double* values;
    double factor;
    const double* others;
    double* out;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto added = hn::Set(d, factor) * hn::LoadU(d, others + x);
        hn::StoreU(hn::LoadU(d, values + x) + added, d, out + x);
    }
};

struct FirstRow {
    const double* from;
    double r_x;
    double inverse;
    double* row;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        hn::StoreU(with_diffusion_x(d, from + x, r_x) * hn::Set(d, inverse), d, row + x);
    }
};

/// How much of the closing solution a periodic line takes.
struct ClosingFactor {
    const double* first;
    const double* last;
    double weight;
    double end;
    double* factors;

    template <class D>
    HWY_INLINE void operator()(D d, std::size_t x) const {
        const auto sum = hn::LoadU(d, first + x) + hn::Set(d, end) * hn::LoadU(d, last + x);
        hn::StoreU(hn::Set(d, weight) * sum, d, factors + x);
    }
};

void explicit_y(const double* south, const double* here, const double* north, const double* change,
                double r, int count, double* out) {
    for_each_vector_overlapping(count, ExplicitY{south, here, north, change, r, out});
}

void explicit_x(const double* from, double r_x, int count, double* to) {
    for_each_vector_overlapping(count, ExplicitX{from, r_x, to});
}

void add_multiple(const double* values, double factor, int count, double* to) {
    for_each_vector(count, AddMultiple{to, factor, values, to});
}

void cross_rows(const Rows& from, double r_x, const Lines& lines, int width, double* scratch,
                double* to, std::ptrdiff_t to_stride) {
    const int last = lines.count - 1;
    const auto source = [&](int y) { return from.first + y * from.stride; };
    const auto row = [&](int y) { return scratch + static_cast<std::ptrdiff_t>(y) * width; };
    const auto target = [&](int y) { return to + y * to_stride; };
    for_each_vector_overlapping(width, FirstRow{source(0), r_x, lines.inverse[0], row(0)});
    for (int y = 1; y <= last; ++y) {
        for_each_vector_overlapping(
            width, Eliminate{source(y), r_x, row(y - 1), lines.r, lines.inverse[y], row(y)});
    }
    if (lines.closing == nullptr) {
        std::copy_n(row(last), width, target(last));
        for (int y = last - 1; y >= 0; --y) {
            for_each_vector_overlapping(
                width, AddMultiple{row(y), lines.r * lines.inverse[y], target(y + 1), target(y)});
        }
        return;
    }
    for (int y = last - 1; y >= 0; --y) {
        for_each_vector(width, AddMultiple{row(y), lines.r * lines.inverse[y], row(y + 1), row(y)});
    }
    double* factors = row(lines.count);
    for_each_vector_overlapping(
        width, ClosingFactor{row(0), row(last), lines.closing_weight, lines.closing_end, factors});
    for (int y = 0; y <= last; ++y)
        for_each_vector_overlapping(width,
                                    AddMultiple{row(y), -lines.closing[y], factors, target(y)});
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::bed_diffusion
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::bed_diffusion {

HWY_EXPORT(explicit_y);
HWY_EXPORT(explicit_x);
HWY_EXPORT(add_multiple);
HWY_EXPORT(cross_rows);

void explicit_y(const double* south, const double* here, const double* north, const double* change,
                double r, int count, double* out) {
    HWY_DYNAMIC_DISPATCH(explicit_y)(south, here, north, change, r, count, out);
}

void explicit_x(const double* from, double r_x, int count, double* to) {
    HWY_DYNAMIC_DISPATCH(explicit_x)(from, r_x, count, to);
}

void add_multiple(const double* values, double factor, int count, double* to) {
    HWY_DYNAMIC_DISPATCH(add_multiple)(values, factor, count, to);
}

void cross_rows(const Rows& from, double r_x, const Lines& lines, int width, double* scratch,
                double* to, std::ptrdiff_t to_stride) {
    HWY_DYNAMIC_DISPATCH(cross_rows)(from, r_x, lines, width, scratch, to, to_stride);
}

}  // namespace fumon::bed_diffusion
#endif
