#include "render/light/sun_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/grid.h"
#include "base/truncation.h"
#include "render/light/light_vectors.h"

namespace fumon {

namespace {

/// The field with x and y exchanged, tile by tile so that both sides stay in the cache, which has
/// only eight places for what lies powers of two apart.
template <class Number>
Field<Number> transposed(const Field<Number>& field) {
    constexpr int columns = 16;
    constexpr int rows = 8;
    Field<Number> result(field.ny(), field.nx());
    for (int y0 = 0; y0 < field.ny(); y0 += rows) {
        for (int x0 = 0; x0 < field.nx(); x0 += columns) {
            const int y1 = std::min(y0 + rows, field.ny());
            const int x1 = std::min(x0 + columns, field.nx());
            for (int x = x0; x < x1; ++x)
                for (int y = y0; y < y1; ++y) result(y, x) = field(x, y);
        }
    }
    return result;
}

/// The shadows of the two limbs over a row: the height each reaches, and how far apart both of its
/// occluder are. With places of padding at each end.
struct RowShadow {
    explicit RowShadow(std::size_t size)
        : lower(size), lower_width(size), upper(size), upper_width(size) {}
    [[nodiscard]] light_vectors::Shadow from(std::size_t position) {
        return {lower.data() + position, lower_width.data() + position, upper.data() + position,
                upper_width.data() + position};
    }
    std::vector<float> lower;
    std::vector<float> lower_width;
    std::vector<float> upper;
    std::vector<float> upper_width;

    friend bool operator==(const RowShadow&, const RowShadow&) = default;
};

constexpr std::size_t padding = 2;

/// Beyond the border the shadow is that of the border cell: no false light leaks in; or that of the
/// other side.
void close_ends(std::vector<float>& row, LatticeBorder border) {
    const std::size_t last = row.size() - padding;
    for (std::size_t i = 0; i < padding; ++i) {
        const bool around = border == LatticeBorder::periodic;
        row[padding - 1 - i] = around ? row[last - 1 - i % (last - padding)] : row[padding];
        row[last + i] = around ? row[padding + i % (last - padding)] : row[last - 1];
    }
}

constexpr int most_periods = 4;  // that the sweep begins away
constexpr int most_further_periods = 64;

/// Rows before the first over which shadows may reach it.
int rows_before(const Field<float>& heights, const light_vectors::ShadowStep& step,
                LatticeBorder border) {
    if (border == LatticeBorder::open) return 0;
    const auto [low, high] = std::ranges::minmax(heights.values());
    const float most = static_cast<float>(most_periods) * static_cast<float>(heights.ny());
    const float relief = high - low;
    // Twice, since neighbouring rays mix what they carry.
    if (2.0F * relief >= most * step.lower_drop) return most_periods * heights.ny();
    return truncated_within(static_cast<double>(2.0F * relief / step.lower_drop), 0,
                            most_periods * heights.ny()) +
           2;
}

/// The sweep where the sun stands more along y than along x (in cells): rows follow each other.
Field<float> sweep_rows(const Field<float>& heights, float dx, float dy, const SunDirection& sun,
                        const ShareBounds& bounds, LatticeBorder border) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    const float columns_per_row = (sun.east / dx) / (std::abs(sun.north) / dy);
    const float run = dy / std::abs(sun.north);  // horizontal length of a ray between two rows
    const float whole = std::floor(columns_per_row);
    const light_vectors::ShadowStep step{nx,
                                         columns_per_row - whole,
                                         run * sun.lower_limb,
                                         run * sun.upper_limb,
                                         bounds.lowest,
                                         bounds.highest};
    const auto shifted = static_cast<std::size_t>(static_cast<float>(padding) + whole);

    Field<float> visibility(nx, ny, bounds.highest);
    RowShadow shadow(static_cast<std::size_t>(nx) + 2 * padding);
    RowShadow next = shadow;
    const int before = rows_before(heights, step, border);
    const auto row_of = [&](int n) {  // counted away from the sun
        const int within = ((n % ny) + ny) % ny;
        return sun.north > 0.0F ? ny - 1 - within : within;
    };
    std::copy_n(heights.row(row_of(-before)).data(), nx, shadow.lower.begin() + padding);
    std::copy_n(heights.row(row_of(-before)).data(), nx, shadow.upper.begin() + padding);
    const auto close = [&] {
        for (auto* row : {&shadow.lower, &shadow.lower_width, &shadow.upper, &shadow.upper_width})
            close_ends(*row, border);
    };
    const auto sweep = [&](int from, int to) {
        for (int n = from; n < to; ++n) {
            close();
            const int y = row_of(n);
            light_vectors::sweep_shadow(step, heights.row(y).data(), shadow.from(shifted),
                                        next.from(padding), visibility.row(y).data());
            std::swap(shadow, next);
        }
    };
    if (border == LatticeBorder::open) {
        sweep(1, ny);
        return visibility;
    }
    sweep(1 - before, 0);
    // Shadows that do not end would go on for ever.
    const int most_further = step.lower_drop > 0.0F ? most_further_periods : 1;
    RowShadow coming_in = shadow;
    for (int period = 0; period < most_further; ++period) {
        close();
        coming_in = shadow;
        sweep(0, ny);
        close();
        if (shadow == coming_in) break;
    }
    return visibility;
}

}  // namespace

Field<float> sun_visibility(const Field<float>& heights, float dx, float dy,
                            const SunDirection& sun, const ShareBounds& bounds,
                            LatticeBorder border) {
    if (std::abs(sun.north) / dy >= std::abs(sun.east) / dx)
        return sweep_rows(heights, dx, dy, sun, bounds, border);
    const SunDirection rotated{sun.north, sun.east, sun.lower_limb, sun.upper_limb};
    return transposed(sweep_rows(transposed(heights), dy, dx, rotated, bounds, border));
}

}  // namespace fumon
