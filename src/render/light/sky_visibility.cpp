// How sky_visibility() is made fast. The method (see the header) asks for the highest horizon of
// each cell in eight directions: along each lattice line the upper convex hull of what has been
// passed, a stack whose top is the horizon once the points that the cell hides are gone.
//
// 1. A cell waits for the hull that the one before it left. Four sweeps that do not wait for each
//    other run together: two lines, each both ways.
// 2. On rough ground no processor foresees how many points a cell hides. The first three are tested
//    and counted without a branch; only where all three are hidden does a loop go on. Below the
//    hull lie three points that hide nothing, so that the test needs no bound.
// 3. Rows lie in memory as they are swept. Of columns and diagonals 16 neighbouring lines, a cache
//    line of floats, are copied first, and their sums back the same way. Lines of a bundle begin an
//    odd number of cache lines apart, since caches have few places for what lies powers of two
//    apart.
// 4. Level ends of a line (the plain that a block stands on) need no hull, and a line that is level
//    as a whole gets at once what sweeps would find, to the bit.
// 5. Integrating the sky above the horizons is a loop over vectors (light_vectors.h).
//
//    heights, and a bundle of diagonals        its lines in memory
//    y = 2   .   .   0   1   2  …  15          line 0   │ y = 0, 1, 2 …  │ padding │
//    y = 1   .   0   1   2  …  15   .    ──►   line 1   │ y = 0, 1, 2 …  │ padding │
//    y = 0   0   1   2  …  15   .   .          line 15  │ y = 0, 1, 2 …  │ padding │

#include "render/light/sky_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "base/elementary_angle.h"
#include "base/worker_pool.h"
#include "render/light/light_vectors.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

/// Lines swept together: their cells lie side by side in memory (one cache line of floats).
constexpr int lines_per_bundle = 16;

/// Floats from one line of a bundle to the next: an odd number of cache lines, since caches have
/// only few places for what lies powers of two apart.
std::size_t line_stride(int length) {
    return static_cast<std::size_t>(lines_per_bundle) *
           static_cast<std::size_t>((length / lines_per_bundle + 1) | 1);
}

/// A family of parallel lattice lines that cross every row: x = first + shear·y.
struct LineFamily {
    int shear;
    float spacing;  ///< length between two cells of a line
    float weight;   ///< Δφ of one direction over 2π
};

/// A place of a line's hull, in cells along it.
struct HullPoint {
    float position;
    float height;
};

/// Points that a new one may hide and that are all looked at, whether it does or not: which of them
/// it hides no processor foresees on rough ground.
constexpr int hull_points_tested = 3;

/// How many cells of a line are as high as its first one, in steps of `step`; 1 where that has no
/// height.
template <std::ptrdiff_t step>
int leading_level_cells(const float* z, int count) {
    int cells = 1;
    if (!std::isfinite(z[0])) return cells;
    while (cells < count && z[cells * step] == z[0]) ++cells;
    return cells;
}

/// A line that is not level as a whole, on the way through its cells in steps of `step`, and the
/// hull of those behind. Below the hull lie as many points that hide nothing, so that of the last
/// ones none is ever missing. The level ground that a block stands on needs no look at the hull:
/// before the block it sees no horizon, and behind it none of it hides anything.
template <std::ptrdiff_t step>
struct Sweep {
    const float* z;
    float* tangent;
    int count;
    int next;  ///< the cell that is swept next
    int last;  ///< from here on the line is level
    HullPoint* bottom;
    HullPoint* top;

    Sweep(const float* z_, float* tangent_, int count_, std::vector<HullPoint>& hull)
        : z(z_),
          tangent(tangent_),
          count(count_),
          next(leading_level_cells<step>(z, count)),
          last(count - leading_level_cells<-step>(z + (count - 1) * step, count)),
          bottom(hull.data() + hull_points_tested),
          top(bottom) {
        std::fill(hull.data(), bottom, HullPoint{-1.0F, -std::numeric_limits<float>::infinity()});
        *bottom = {0.0F, z[0]};
        for (int i = 0; i < next; ++i) tangent[i * step] = 0.0F;
        if (next > 1) *++top = {static_cast<float>(next - 1), z[(next - 1) * step]};
    }

    [[nodiscard]] int left() const { return last + 1 - next; }  ///< cells before sweep_level_end()
};

/// Finds, for cell i of a line that is taken in steps of `step`, the tangent of the horizon's
/// elevation looking back to those before, never below the horizontal.
template <std::ptrdiff_t step>
inline void sweep_cell(Sweep<step>& sweep) {
    const int i = sweep.next++;
    const float here = sweep.z[i * step];
    const auto position = static_cast<float>(i);
    std::array<float, hull_points_tested + 1> rise{};
    std::array<float, hull_points_tested + 1> run{};
    for (std::size_t k = 0; k <= hull_points_tested; ++k) {
        const HullPoint& point = *(sweep.top - k);
        rise[k] = point.height - here;
        run[k] = position - point.position;
    }
    unsigned all_hidden = 1;
    std::ptrdiff_t hidden = 0;
    for (std::size_t k = 0; k < hull_points_tested; ++k) {
        all_hidden &= static_cast<unsigned>(rise[k + 1] * run[k] >= rise[k] * run[k + 1]);
        hidden += all_hidden;
    }
    HullPoint* top = std::max(sweep.top - hidden, sweep.bottom);
    if (all_hidden != 0) [[unlikely]] {
        while (top != sweep.bottom && (top[-1].height - here) * (position - top->position) >=
                                          (top->height - here) * (position - top[-1].position))
            --top;
    }
    sweep.tangent[i * step] = (top->height - here) / (position - top->position);
    *++top = {position, here};
    sweep.top = top;
}

/// The same for the level cells that are left, the first of which is swept and lies on the hull.
template <std::ptrdiff_t step>
void sweep_level_end(const Sweep<step>& sweep) {
    const float here = sweep.z[sweep.last * step];
    const HullPoint* top = sweep.top - 1;
    const bool horizon = top->height - here >= 0.0F;
    for (int i = sweep.next; i < sweep.count; ++i) {
        const auto position = static_cast<float>(i);
        while (horizon && top != sweep.bottom &&
               (top[-1].height - here) * (position - top->position) >=
                   (top->height - here) * (position - top[-1].position))
            --top;
        sweep.tangent[i * step] =
            horizon ? (top->height - here) / (position - top->position) : 0.0F;
    }
}

bool is_flat(const float* z, int count) {
    return std::isfinite(z[0]) && std::all_of(z, z + count, [z](float at) { return at == z[0]; });
}

/// Cells from `begin` on, up to the one before `end`.
struct CellRange {
    int begin = 0;
    int end = 0;
};

/// Sweeps lines both ways and adds the sky that their cells see. Two lines are swept at once: each
/// cell waits for the one before it, and meanwhile the processor is at another line.
class LineSweeps {
  public:
    /// Of lines of up to `length` cells.
    LineSweeps(int length, float spacing, float weight)
        : lines_{Line(length), Line(length)}, spacing_(spacing), weight_(weight) {}

    /// Where the heights of the line are to be written that is added next.
    [[nodiscard]] float* heights() { return lines_[waiting_].heights.data() + 1; }

    /// Adds a line; `sum` gets the sky of its cells within `wanted`, at the latest by finish().
    void add(int count, const CellRange& wanted, float* sum) {
        float* z = heights();
        if (is_flat(z, count)) {
            const float whole = weight_ * 2.0F;  // what the sweeps would find, to the bit
            for (int i = wanted.begin; i < wanted.end; ++i) sum[i] += whole;
            return;
        }
        // At the ends the slope is taken one-sided, by a padding that continues the line straight
        // on.
        z[-1] = count > 1 ? 2.0F * z[0] - z[1] : z[0];
        z[count] = count > 1 ? 2.0F * z[count - 1] - z[count - 2] : z[0];
        Line& line = lines_[waiting_];
        line.count = count;
        line.wanted = wanted;
        line.sum = sum;
        if (++waiting_ == lines_.size()) finish();
    }

    void finish() {
        if (waiting_ == 0) return;
        Line& one = lines_.front();
        Line& other = lines_.back();
        Sweep<1> back = one.sweep_back();
        Sweep<-1> ahead = one.sweep_ahead();
        if (waiting_ == lines_.size()) {
            Sweep<1> other_back = other.sweep_back();
            Sweep<-1> other_ahead = other.sweep_ahead();
            const int together =
                std::min({back.left(), ahead.left(), other_back.left(), other_ahead.left()});
            for (int i = 0; i < together; ++i) {
                sweep_cell(back);
                sweep_cell(ahead);
                sweep_cell(other_back);
                sweep_cell(other_ahead);
            }
            sweep_rest(other_back, other_ahead);
            add_sky(other);
        }
        sweep_rest(back, ahead);
        add_sky(one);
        waiting_ = 0;
    }

  private:
    struct Line {
        explicit Line(int length)
            : heights(static_cast<std::size_t>(length) + 2),
              back(static_cast<std::size_t>(length)),
              ahead(static_cast<std::size_t>(length)),
              hull_behind(static_cast<std::size_t>(length + hull_points_tested)),
              hull_ahead(hull_behind.size()) {}
        [[nodiscard]] Sweep<1> sweep_back() {
            return {heights.data() + 1, back.data(), count, hull_behind};
        }
        [[nodiscard]] Sweep<-1> sweep_ahead() {
            return {heights.data() + count, ahead.data() + count - 1, count, hull_ahead};
        }

        std::vector<float> heights;  ///< with one place of padding at each end
        std::vector<float> back;
        std::vector<float> ahead;
        std::vector<HullPoint> hull_behind;
        std::vector<HullPoint> hull_ahead;
        int count = 0;
        CellRange wanted;
        float* sum = nullptr;
    };

    static void sweep_rest(Sweep<1>& back, Sweep<-1>& ahead) {
        while (back.left() > 0 && ahead.left() > 0) {
            sweep_cell(back);
            sweep_cell(ahead);
        }
        while (back.left() > 0) sweep_cell(back);
        while (ahead.left() > 0) sweep_cell(ahead);
        sweep_level_end(back);
        sweep_level_end(ahead);
    }

    void add_sky(const Line& line) const {
        const int first = line.wanted.begin;
        light_vectors::add_sky(line.heights.data() + 1 + first, line.wanted.end - first,
                               line.back.data() + first, line.ahead.data() + first, spacing_,
                               weight_, line.sum + first);
    }

    std::array<Line, 2> lines_;
    std::size_t waiting_ = 0;
    float spacing_;
    float weight_;
};

void sweep_rows(const Field<float>& heights, int margin, float spacing, float weight,
                Field<float>& sum, const CellRange& rows) {
    const int nx = heights.nx();
    LineSweeps sweeps(nx, spacing, weight);
    for (int y = rows.begin; y < rows.end; ++y) {
        std::copy_n(heights.row(y).data(), nx, sweeps.heights());
        sweeps.add(nx, {margin, nx - margin}, sum.row(y).data());
    }
    sweeps.finish();
}

/// The rows in which the line through column x of row 0 lies within a margin.
CellRange rows_within(const Field<float>& heights, int margin, int shear, int x) {
    const int nx = heights.nx();
    const CellRange rows{margin, heights.ny() - margin};
    if (shear > 0) return {std::max(rows.begin, margin - x), std::min(rows.end, nx - margin - x)};
    if (shear < 0)
        return {std::max(rows.begin, x - nx + margin + 1), std::min(rows.end, x - margin + 1)};
    return x >= margin && x < nx - margin ? rows : CellRange{};
}

/// Sweeps `bundle` neighbouring lines, the first through column `first` of row 0.
void sweep_bundle(const Field<float>& heights, int margin, const LineFamily& family, int first,
                  LineSweeps& sweeps, std::vector<float>& lines, std::vector<float>& sums,
                  Field<float>& sum) {
    const int nx = heights.nx();
    const int ny = heights.ny();
    const std::size_t stride = line_stride(ny);
    const auto columns = [&](int y) {
        const int x0 = first + family.shear * y;
        return std::array<int, 3>{x0, std::clamp(-x0, 0, lines_per_bundle),
                                  std::clamp(nx - x0, 0, lines_per_bundle)};
    };
    for (int y = 0; y < ny; ++y) {
        const auto [x0, begin, end] = columns(y);
        const float* row = heights.row(y).data() + x0;
        for (int lane = begin; lane < end; ++lane)
            lines[static_cast<std::size_t>(lane) * stride + static_cast<std::size_t>(y)] =
                row[lane];
    }
    for (int lane = 0; lane < lines_per_bundle; ++lane) {
        const int x = first + lane;  // at row 0; the rows with 0 ≤ x + shear·y < nx belong to it
        const auto [begin, end] = rows_within(heights, 0, family.shear, x);
        const CellRange wanted = rows_within(heights, margin, family.shear, x);
        if (wanted.begin >= wanted.end) continue;
        const float* line = lines.data() + static_cast<std::size_t>(lane) * stride;
        float* line_sum = sums.data() + static_cast<std::size_t>(lane) * stride;
        std::fill(line_sum + begin, line_sum + end, 0.0F);
        std::copy(line + begin, line + end, sweeps.heights());
        sweeps.add(end - begin, {wanted.begin - begin, wanted.end - begin}, line_sum + begin);
    }
    sweeps.finish();
    for (int y = margin; y < ny - margin; ++y) {
        const auto [x0, begin, end] = columns(y);
        float* row = sum.row(y).data() + x0;
        for (int lane = begin; lane < end; ++lane)
            row[lane] +=
                sums[static_cast<std::size_t>(lane) * stride + static_cast<std::size_t>(y)];
    }
}

void sweep_family(const Field<float>& heights, int margin, const LineFamily& family,
                  Field<float>& sum, WorkerPool& pool) {
    const int ny = heights.ny();
    const int last_row = ny - margin - 1;
    const int first = margin - (family.shear > 0 ? last_row : family.shear < 0 ? -margin : 0);
    const int last = heights.nx() - margin - 1 +
                     (family.shear < 0   ? last_row
                      : family.shear > 0 ? -margin
                                         : 0);
    const int bundles = (last - first + lines_per_bundle) / lines_per_bundle;
    pool.for_ranges(bundles, [&](int begin, int end) {
        LineSweeps sweeps(ny, family.spacing, family.weight);
        std::vector<float> lines(static_cast<std::size_t>(lines_per_bundle) * line_stride(ny));
        std::vector<float> sums(lines.size());
        for (int i = begin; i < end; ++i)
            sweep_bundle(heights, margin, family, first + i * lines_per_bundle, sweeps, lines, sums,
                         sum);
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
