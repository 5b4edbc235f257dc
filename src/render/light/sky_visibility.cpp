#include "render/light/sky_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/elementary_angle.h"
#include "base/worker_pool.h"
#include "render/light/light_vectors.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

/// Lines swept together: their cells lie side by side in memory (one cache line of floats).
constexpr int bundle = 16;

/// A family of parallel lattice lines that cross every row: x = first + shear·y.
struct Family {
    int shear;
    float spacing;  ///< length between two cells of a line
    float weight;   ///< Δφ of one direction over 2π
};

/// A place of a line's hull, in cells along it.
struct HullPoint {
    float place;
    float height;
};

/// For each cell of a line, taken in steps of `step`, the tangent of the horizon's elevation
/// looking back to those before, never below the horizontal.
template <std::ptrdiff_t step>
void sweep_horizon(const float* z, int count, float* tangent, HullPoint* hull) {
    HullPoint* top = hull;
    *top = {0.0F, z[0]};
    tangent[0] = 0.0F;
    for (int i = 1; i < count; ++i) {
        const float here = z[i * step];
        const auto place = static_cast<float>(i);
        float rise = top->height - here;
        float run = place - top->place;
        while (top != hull) {
            const float next_rise = top[-1].height - here;
            const float next_run = place - top[-1].place;
            if (next_rise * run < rise * next_run) break;
            --top;
            rise = next_rise;
            run = next_run;
        }
        tangent[i * step] = rise / run;
        *++top = {place, here};
    }
}

/// What one thread needs for a line of up to `length` cells.
struct Scratch {
    explicit Scratch(int length)
        : heights(static_cast<std::size_t>(length) + 2),
          back(static_cast<std::size_t>(length)),
          ahead(static_cast<std::size_t>(length)),
          hull(static_cast<std::size_t>(length)) {}
    std::vector<float> heights;  ///< with one place of padding at each end
    std::vector<float> back;
    std::vector<float> ahead;
    std::vector<HullPoint> hull;
};

bool is_flat(const float* z, int count) {
    return std::isfinite(z[0]) && std::all_of(z, z + count, [z](float at) { return at == z[0]; });
}

/// Cells from `begin` on, up to the one before `end`.
struct Stretch {
    int begin = 0;
    int end = 0;
};

/// Sweeps the line in scratch.heights[1 … count] both ways and adds the sky of its cells within
/// `wanted` to `sum`.
void sweep_line(Scratch& scratch, int count, const Stretch& wanted, float spacing, float weight,
                float* sum) {
    float* z = scratch.heights.data() + 1;
    if (is_flat(z, count)) {
        const float whole = weight * 2.0F;  // what the sweeps would find, to the bit
        for (int i = wanted.begin; i < wanted.end; ++i) sum[i] += whole;
        return;
    }
    // At the ends the slope is taken one-sided, by a padding that continues the line straight on.
    z[-1] = count > 1 ? 2.0F * z[0] - z[1] : z[0];
    z[count] = count > 1 ? 2.0F * z[count - 1] - z[count - 2] : z[0];
    sweep_horizon<1>(z, count, scratch.back.data(), scratch.hull.data());
    sweep_horizon<-1>(z + count - 1, count, scratch.ahead.data() + count - 1, scratch.hull.data());
    const int first = wanted.begin;
    light_vectors::add_sky(z + first, wanted.end - first, scratch.back.data() + first,
                           scratch.ahead.data() + first, spacing, weight, sum + first);
}

void sweep_rows(const Field<float>& heights, int margin, float spacing, float weight,
                Field<float>& sum, const Stretch& rows) {
    const int nx = heights.nx();
    Scratch scratch(nx);
    for (int y = rows.begin; y < rows.end; ++y) {
        std::copy_n(heights.row(y).data(), nx, scratch.heights.begin() + 1);
        sweep_line(scratch, nx, {margin, nx - margin}, spacing, weight, sum.row(y).data());
    }
}

/// The rows in which the line through column x of row 0 lies within a margin.
Stretch rows_within(const Field<float>& heights, int margin, int shear, int x) {
    const int nx = heights.nx();
    const Stretch rows{margin, heights.ny() - margin};
    if (shear > 0) return {std::max(rows.begin, margin - x), std::min(rows.end, nx - margin - x)};
    if (shear < 0)
        return {std::max(rows.begin, x - nx + margin + 1), std::min(rows.end, x - margin + 1)};
    return x >= margin && x < nx - margin ? rows : Stretch{};
}

/// Sweeps `bundle` neighbouring lines, the first through column `first` of row 0.
void sweep_bundle(const Field<float>& heights, int margin, const Family& family, int first,
                  Scratch& scratch, std::vector<float>& lines, std::vector<float>& sums,
                  Field<float>& sum) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    const auto length = static_cast<std::size_t>(ny);
    const auto columns = [&](int y) {
        const int x0 = first + family.shear * y;
        return std::array<int, 3>{x0, std::clamp(-x0, 0, bundle), std::clamp(nx - x0, 0, bundle)};
    };
    for (int y = 0; y < ny; ++y) {
        const auto [x0, begin, end] = columns(y);
        const float* row = heights.row(y).data() + x0;
        for (int lane = begin; lane < end; ++lane)
            lines[static_cast<std::size_t>(lane) * length + static_cast<std::size_t>(y)] =
                row[lane];
    }
    for (int lane = 0; lane < bundle; ++lane) {
        const int x = first + lane;  // at row 0; the rows with 0 ≤ x + shear·y < nx belong to it
        const auto [begin, end] = rows_within(heights, 0, family.shear, x);
        const Stretch wanted = rows_within(heights, margin, family.shear, x);
        if (wanted.begin >= wanted.end) continue;
        const float* line = lines.data() + static_cast<std::size_t>(lane) * length;
        float* line_sum = sums.data() + static_cast<std::size_t>(lane) * length;
        std::fill(line_sum + begin, line_sum + end, 0.0F);
        std::copy(line + begin, line + end, scratch.heights.begin() + 1);
        sweep_line(scratch, end - begin, {wanted.begin - begin, wanted.end - begin}, family.spacing,
                   family.weight, line_sum + begin);
    }
    for (int y = margin; y < ny - margin; ++y) {
        const auto [x0, begin, end] = columns(y);
        float* row = sum.row(y).data() + x0;
        for (int lane = begin; lane < end; ++lane)
            row[lane] +=
                sums[static_cast<std::size_t>(lane) * length + static_cast<std::size_t>(y)];
    }
}

void sweep_family(const Field<float>& heights, int margin, const Family& family, Field<float>& sum,
                  WorkerPool& pool) {
    const int ny = heights.ny();
    const int last_row = ny - margin - 1;
    const int first = margin - (family.shear > 0 ? last_row : family.shear < 0 ? -margin : 0);
    const int last = heights.nx() - margin - 1 +
                     (family.shear < 0   ? last_row
                      : family.shear > 0 ? -margin
                                         : 0);
    const int bundles = (last - first + bundle) / bundle;
    pool.for_ranges(bundles, [&](int begin, int end) {
        Scratch scratch(ny);
        std::vector<float> lines(static_cast<std::size_t>(bundle) * static_cast<std::size_t>(ny));
        std::vector<float> sums(lines.size());
        for (int i = begin; i < end; ++i)
            sweep_bundle(heights, margin, family, first + i * bundle, scratch, lines, sums, sum);
    });
}

}  // namespace

Field<float> sky_visibility(const Field<float>& heights, float dx, float dy, WorkerPool& pool,
                            int margin) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    Field<float> sum(nx, ny, 0.0F);
    // Each direction stands for the azimuths nearer to it than to its neighbours.
    const auto diagonal_angle = static_cast<float>(elementary::atan2(dy, dx));
    constexpr float circle = 2.0F * std::numbers::pi_v<float>;
    const float weight_x = diagonal_angle / circle;
    const float weight_y = (0.25F * circle - diagonal_angle) / circle;
    const float diagonal = std::sqrt(dx * dx + dy * dy);
    pool.for_ranges(ny - 2 * margin, [&](int begin, int end) {
        sweep_rows(heights, margin, dx, weight_x, sum, {begin + margin, end + margin});
    });
    sweep_family(heights, margin, {0, dy, weight_y}, sum, pool);
    sweep_family(heights, margin, {1, diagonal, 0.125F}, sum, pool);
    sweep_family(heights, margin, {-1, diagonal, 0.125F}, sum, pool);
    pool.for_ranges(ny - 2 * margin, [&](int begin, int end) {
        std::vector<float> row(static_cast<std::size_t>(nx) + 2);
        for (int y = begin + margin; y < end + margin; ++y) {
            const int south = std::max(y - 1, 0);
            const int north = std::min(y + 1, ny - 1);
            std::copy_n(heights.row(y).data(), nx, row.begin() + 1);
            const auto last = static_cast<std::size_t>(nx);
            row.front() = nx > 1 ? 2.0F * row[1] - row[2] : row[1];
            row.back() = nx > 1 ? 2.0F * row[last] - row[last - 1] : row[last];
            const float scale_y =
                north > south ? 1.0F / (dy * static_cast<float>(north - south)) : 0.0F;
            light_vectors::multiply_by_normal({heights.row(south).data(), row.data(),
                                               heights.row(north).data(), 0.5F / dx, scale_y},
                                              nx, sum.row(y).data());
        }
    });
    return margin > 0 ? without_margin(sum, margin) : sum;
}

}  // namespace fumon
