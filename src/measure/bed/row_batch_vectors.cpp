#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measure/bed/row_batch_vectors.cpp"
#include <hwy/foreach_target.h>
// Those below are included once for each target.
#include <hwy/highway.h>

#include <cstdint>
#include <limits>

#include "measure/bed/row_batch.h"
#include "measure/bed/row_batch_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace fumon::row_batch_vectors {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Rows = hn::CappedTag<double, rows>;
using V = hn::Vec<Rows>;

constexpr double detrended_rounding = 1e-12;

/// The rows of one vector, from `values` on.
void detrend_some(double* values, std::size_t nx, bool periodic, double* squares) {
    const Rows d;
    const auto count = static_cast<double>(nx);
    const double middle = 0.5 * (count - 1.0);
    V sum = hn::Zero(d);
    V largest = hn::Zero(d);
    for (std::size_t x = 0; x < nx; ++x) {
        const V height = hn::LoadU(d, values + x * rows);
        sum = hn::Add(sum, height);
        largest = hn::Max(largest, hn::Abs(height));
    }
    const V mean = hn::Div(sum, hn::Set(d, count));
    V slope = hn::Zero(d);
    if (!periodic && nx > 1) {
        V moment = hn::Zero(d);
        for (std::size_t x = 0; x < nx; ++x) {
            const V height = hn::LoadU(d, values + x * rows);
            const V place = hn::Set(d, static_cast<double>(x) - middle);
            moment = hn::Add(moment, hn::Mul(place, hn::Sub(height, mean)));
        }
        slope =
            hn::Div(hn::Mul(hn::Set(d, 12.0), moment), hn::Set(d, count * (count * count - 1.0)));
    }
    V largest_departure = hn::Zero(d);
    V square = hn::Zero(d);
    for (std::size_t x = 0; x < nx; ++x) {
        const V height = hn::LoadU(d, values + x * rows);
        const V line = hn::Mul(slope, hn::Set(d, static_cast<double>(x) - middle));
        const V departure = hn::Sub(hn::Sub(height, mean), line);
        largest_departure = hn::Max(largest_departure, hn::Abs(departure));
        square = hn::Add(square, hn::Mul(departure, departure));
        hn::StoreU(departure, d, values + x * rows);
    }
    const auto level = hn::Le(largest_departure, hn::Mul(hn::Set(d, detrended_rounding), largest));
    hn::StoreU(hn::IfThenZeroElse(level, square), d, squares);
    if (hn::AllFalse(d, level)) return;
    for (std::size_t x = 0; x < nx; ++x) {
        const V departure = hn::LoadU(d, values + x * rows);
        hn::StoreU(hn::IfThenZeroElse(level, departure), d, values + x * rows);
    }
}

void detrend(double* values, std::size_t nx, bool periodic, double* squares) {
    for (std::size_t k = 0; k < rows; k += hn::Lanes(Rows()))
        detrend_some(values + k, nx, periodic, squares + k);
}

void smooth(const double* widened, std::size_t nx, std::size_t width, double* means) {
    const Rows d;
    const V scale = hn::Set(d, 1.0 / static_cast<double>(width));
    for (std::size_t k = 0; k < rows; k += hn::Lanes(d)) {
        V sum = hn::Zero(d);
        for (std::size_t i = 0; i < width; ++i)
            sum = hn::Add(sum, hn::LoadU(d, widened + i * rows + k));
        const double* out = widened + k;
        const double* in = out + width * rows;
        for (std::size_t x = 0; x < nx; ++x) {
            hn::StoreU(hn::Mul(sum, scale), d, means + x * rows + k);
            sum = hn::Add(sum, hn::Sub(hn::LoadU(d, in + x * rows), hn::LoadU(d, out + x * rows)));
        }
    }
}

void find_some_waves(const double* values, std::size_t nx, WaveSearch& search, std::size_t first) {
    const Rows d;
    const V high = hn::LoadU(d, search.threshold.data() + first);
    const V low = hn::Neg(high);
    const V infinite = hn::Set(d, std::numeric_limits<double>::infinity());
    auto armed = hn::Gt(hn::LoadU(d, search.armed.data() + first), hn::Zero(d));
    V lowest = infinite;
    V highest = hn::Neg(infinite);
    for (std::size_t x = 0; x < nx; ++x) {
        const V departure = hn::LoadU(d, values + x * rows);
        const auto above = hn::Gt(departure, high);
        const auto crossed = hn::And(armed, above);
        if (!hn::AllFalse(d, crossed)) {
            HWY_ALIGN double lows[rows];
            HWY_ALIGN double highs[rows];
            HWY_ALIGN std::uint8_t bytes[8] = {};
            hn::Store(lowest, d, lows);
            hn::Store(highest, d, highs);
            hn::StoreMaskBits(d, crossed, bytes);
            for (unsigned bits = bytes[0]; bits != 0; bits &= bits - 1) {
                const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
                RowWaves& row = *search.waves[first + lane];
                row.last = static_cast<int>(x);
                if (row.crossings++ == 0) {
                    row.first = static_cast<int>(x);
                    search.lowest_before[first + lane] = lows[lane];
                    search.highest_before[first + lane] = highs[lane];
                } else {
                    row.reliefs[static_cast<std::size_t>(row.crossings) - 2] =
                        highs[lane] - lows[lane];
                }
            }
            lowest = hn::IfThenElse(crossed, infinite, lowest);
            highest = hn::IfThenElse(crossed, hn::Neg(infinite), highest);
        }
        lowest = hn::Min(lowest, departure);
        highest = hn::Max(highest, departure);
        armed = hn::Or(hn::Lt(departure, low), hn::AndNot(above, armed));
    }
    hn::StoreU(lowest, d, search.lowest.data() + first);
    hn::StoreU(highest, d, search.highest.data() + first);
}

void find_waves(const double* values, std::size_t nx, WaveSearch& search) {
    for (std::size_t k = 0; k < rows; k += hn::Lanes(Rows()))
        find_some_waves(values + k, nx, search, k);
}

}  // namespace HWY_NAMESPACE
}  // namespace fumon::row_batch_vectors
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fumon::row_batch_vectors {

HWY_EXPORT(detrend);
HWY_EXPORT(smooth);
HWY_EXPORT(find_waves);

void detrend(double* values, std::size_t nx, bool periodic, double* squares) {
    HWY_DYNAMIC_DISPATCH(detrend)(values, nx, periodic, squares);
}

void smooth(const double* widened, std::size_t nx, std::size_t width, double* means) {
    HWY_DYNAMIC_DISPATCH(smooth)(widened, nx, width, means);
}

void find_waves(const double* values, std::size_t nx, WaveSearch& search) {
    HWY_DYNAMIC_DISPATCH(find_waves)(values, nx, search);
}

}  // namespace fumon::row_batch_vectors
#endif
