#include "render/sun_sweep.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "render/transpose.h"
#include "support/multiversion.h"

namespace fumon {

namespace {

/// One row's step of the sweep. Every span has one place of padding at each end.
struct RowStep {
    int count;
    int shift;        ///< whole columns between a cell and the point its ray crossed a row before
    float fraction;   ///< the rest, towards the next column
    float lower_drop; ///< how far the limbs' shadows sink between two rows
    float upper_drop;
};

FUMON_MULTIVERSION
void sweep_row(const RowStep& step, const float* __restrict heights,
               const float* __restrict lower_before, const float* __restrict upper_before,
               float* __restrict lower, float* __restrict upper, float* __restrict visibility) {
    const float near = 1.0F - step.fraction;
    const float far = step.fraction;
    for (int x = 0; x < step.count; ++x) {
        const float low =
            near * lower_before[x] + far * lower_before[x + 1] - step.lower_drop;
        const float high =
            near * upper_before[x] + far * upper_before[x + 1] - step.upper_drop;
        const float width = std::max(low - high, 1e-20F);
        const float share = (heights[x] - high) / width;
        visibility[x] = std::min(std::max(share, 0.0F), 1.0F);
        lower[x] = std::max(low, heights[x]);
        upper[x] = std::max(high, heights[x]);
    }
}

/// The sweep where the sun stands more along y than along x (in cells): rows follow each other.
Field<float> sweep_rows(const Field<float>& heights, float dx, float dy, const SunDirection& sun) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    const float columns_per_row = (sun.east / dx) / (std::abs(sun.north) / dy);
    const float run = dy / std::abs(sun.north);  // horizontal length of a ray between two rows
    RowStep step{};
    step.count = nx;
    const float whole = std::floor(columns_per_row);
    step.shift = static_cast<int>(whole);
    step.fraction = columns_per_row - whole;
    step.lower_drop = run * sun.lower_limb;
    step.upper_drop = run * sun.upper_limb;

    Field<float> visibility(nx, ny, 1.0F);
    const auto padded = static_cast<std::size_t>(nx) + 4;
    constexpr std::size_t pad = 2;
    std::vector<float> lower(padded);
    std::vector<float> upper(padded);
    std::vector<float> next_lower(padded);
    std::vector<float> next_upper(padded);
    const int first = sun.north > 0.0F ? ny - 1 : 0;
    const int direction = sun.north > 0.0F ? -1 : 1;
    const auto close_ends = [&](std::vector<float>& shadow) {
        // Beyond the border the shadow is that of the border cell: no false light leaks in.
        std::fill_n(shadow.begin(), pad, shadow[pad]);
        std::fill_n(shadow.end() - pad, pad, shadow[padded - pad - 1]);
    };
    std::copy_n(heights.row(first).data(), nx, lower.begin() + pad);
    std::copy_n(heights.row(first).data(), nx, upper.begin() + pad);
    for (int n = 1; n < ny; ++n) {
        close_ends(lower);
        close_ends(upper);
        const int y = first + n * direction;
        const auto start = static_cast<std::size_t>(static_cast<int>(pad) + step.shift);
        sweep_row(step, heights.row(y).data(), lower.data() + start, upper.data() + start,
                  next_lower.data() + pad, next_upper.data() + pad, visibility.row(y).data());
        lower.swap(next_lower);
        upper.swap(next_upper);
    }
    return visibility;
}

}  // namespace

Field<float> sun_visibility(const Field<float>& heights, float dx, float dy,
                            const SunDirection& sun) {
    if (std::abs(sun.north) / dy >= std::abs(sun.east) / dx) return sweep_rows(heights, dx, dy, sun);
    const SunDirection turned{sun.north, sun.east, sun.lower_limb, sun.upper_limb};
    return transposed(sweep_rows(transposed(heights), dy, dx, turned));
}

}  // namespace fumon
