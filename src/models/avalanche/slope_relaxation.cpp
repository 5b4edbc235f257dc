// Avalanches as passes over the whole surface (the rule stands in slope_relaxation.h).
//
// 1. Heights are whole numbers of 2^-32 m, so that any order of additions gives the same sum: sand
//    is conserved exactly, and threads cannot change a bit.
// 2. A pass has two halves. Sliding reads the surface and notes what leaves each cell along x and
// y;
//    settling adds what left and what came. All cells of a pass thus read the ground before it.
// 3. Only cells that slid, and their four neighbours, can have become steeper. A bit set holds them
//    (CellBitset), with a flag a row for rows at rest. Vectors take whole rows (slope_vectors.h)
//    and leave the ends of rows, where neighbours wrap, to loops over cells.
// 4. The first pass starts slides beyond the static angle, later ones beyond the dynamic one.
// 5. Up to 16 passes go over the rows together, two rows apart (PassWavefront), so that the rows
//    between the first and the last stay in a processor's cache:
//
//        row      0  1  2  3  4  5  6  7  8  9
//        pass 0                        s  S         S: slides, s: settles
//        pass 1                  s  S
//        pass 2            s  S                     all move to the right ->
//
// 6. Threads take strips of rows. A pass needs the rows beside it as the pass before left them, so
//    a strip's later passes end two rows earlier; the wedges along the seams follow when all strips
//    are done:
//
//        pass 0   ##########|##########
//        pass 1   ########      ########      #: strips, the gap: of_seam()
//        pass 2   ######          ######
//
// 7. A few cells on one thread take a queue instead (relax_near), first in first out.
//
// The slope is that of Rouy & Tourin (1992).

#include "models/avalanche/slope_relaxation.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <utility>

#include "base/cancellation.h"
#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/avalanche/pass_wavefront.h"
#include "models/avalanche/slope_vectors.h"

namespace fumon {

namespace {

/// Of the excess fall to the lower neighbour, what a pass moves: the diffusion number along each
/// axis. Above ¼ the shortest diagonal waves grow.
constexpr double share_of_fall = 0.25;

/// Passes that go over the rows together: so many that what slides in them stays in a processor's
/// own cache.
constexpr int passes_at_once = 16;

double tangent(double degrees) {
    return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
}

template <class Body>
void for_each_bit(const CellBitset& cells, int y, const Body& body) {
    const CellBitset::Word* words = cells.row(y);
    for (int w = 0; w < cells.words(); ++w) {
        for (CellBitset::Word left = words[w]; left != 0; left &= left - 1)
            body(w * CellBitset::word_bits + std::countr_zero(left));
    }
}

}  // namespace

SlopeRelaxation::SlopeRelaxation(const AvalancheGround& ground, const ReposeAngles& angles,
                                 WorkerPool& pool)
    : ground_(ground),
      pool_(pool),
      moving_tangent_(tangent(angles.moving)),
      start_ratio_(tangent(angles.resting + tolerance) / moving_tangent_),
      sliding_ratio_(tangent(angles.moving + tolerance) / moving_tangent_),
      least_tangent_(moving_tangent_),
      slope_of_unit_x_(metres_per_unit / ground.dx),
      slope_of_unit_y_(metres_per_unit / ground.dy),
      candidates_(ground.nx, ground.ny),
      sliding_(ground.nx, ground.ny),
      left_(ground.nx, ground.ny),
      slides_x_(ground.nx, ground.ny),
      slides_y_(ground.nx, ground.ny),
      no_slides_(static_cast<std::size_t>(ground.nx)),
      places_(ground.ny) {}

void SlopeRelaxation::set_moving_angles(const Grid& degrees) {
    moving_tangents_ = Grid(nx(), ny());
    std::ranges::transform(degrees.values(), moving_tangents_.values().begin(), tangent);
    least_tangent_ = *std::ranges::min_element(moving_tangents_.values());
}

SlopeRelaxation::Falls SlopeRelaxation::falls_at(const FixedPointGrid& surface, int x,
                                                 int y) const {
    const std::int64_t here = surface(x, y);
    return {here - surface(west(x), y), here - surface(east(x), y), here - surface(x, south(y)),
            here - surface(x, north(y))};
}

SlopeRelaxation::Slide SlopeRelaxation::slide_at(const FixedPointGrid& surface,
                                                 const FixedPointGrid& floor, int x, int y,
                                                 double start_ratio) const {
    return slide_of(falls_at(surface, x, y), surface(x, y) - floor(x, y), tangent_at(x, y),
                    start_ratio);
}

SlopeRelaxation::Slide SlopeRelaxation::slide_of(const Falls& falls, std::int64_t loose,
                                                 double rest, double start_ratio) const {
    const double a = falls.x * slope_of_unit_x_;
    const double b = falls.y * slope_of_unit_y_;
    const double square = a * a + b * b;
    const double start = rest * start_ratio;
    if (!(square > start * start) || loose <= 0) return {};
    const double share = share_of_fall * (1.0 - rest / std::sqrt(square));
    auto along = static_cast<std::int64_t>(falls.x * share);
    auto across = static_cast<std::int64_t>(falls.y * share);
    if (along + across > loose) {
        const double of_x = falls.x / (falls.x + falls.y);
        along = std::min(loose, static_cast<std::int64_t>(static_cast<double>(loose) * of_x));
        across = falls.direction_y != 0 ? loose - along : 0;
        if (falls.direction_y == 0) along = loose;
    }
    return {along * falls.direction_x, across * falls.direction_y};
}

/// Candidates of the first pass: all cells of a row that are steep enough to start.
void SlopeRelaxation::mark_row(const FixedPointGrid& surface, int y) {
    const double start = least_tangent_ * start_ratio_;
    CellBitset::Word* words = candidates_.row(y);
    slope_vectors::mark_steep(surface.row(south(y)).data(), surface.row(y).data(),
                              surface.row(north(y)).data(), slope_of_unit_x_ * slope_of_unit_x_,
                              slope_of_unit_y_ * slope_of_unit_y_, start * start, nx(), words);
    words[0] |= 1U;
    words[(nx() - 1) / CellBitset::word_bits] |=
        CellBitset::Word{1} << static_cast<unsigned>((nx() - 1) % CellBitset::word_bits);
    candidates_.set_any(y, true);
}

std::int64_t SlopeRelaxation::slide_row(const FixedPointGrid& surface, const AvalancheFloor& floor,
                                        int y, double start_ratio) {
    CellBitset::Word* words = sliding_.row(y);
    if (!candidates_.any(y)) {
        if (sliding_.any(y)) std::fill_n(words, sliding_.words(), CellBitset::Word{0});
        sliding_.set_any(y, false);
        return 0;
    }
    const std::int64_t* here = surface.row(y).data();
    const std::int64_t* below = surface.row(south(y)).data();
    const std::int64_t* above = surface.row(north(y)).data();
    const std::int64_t* rock = floor.cells.row(y).data();
    double* slides_x = slides_x_.row(places_.of(y)).data();
    double* slides_y = slides_y_.row(places_.of(y)).data();
    const double least_start = least_tangent_ * start_ratio * least_tangent_ * start_ratio;
    const FloorRange* range = floor.range;
    const slope_vectors::SlideRows rows{
        below,
        here,
        above,
        rock,
        range == nullptr ? nullptr : range->lowest.row(y).data(),
        range == nullptr ? nullptr : range->highest.row(y).data(),
        moving_tangents_.empty() ? nullptr : moving_tangents_.row(y).data()};
    std::int64_t count =
        slope_vectors::slide(rows,
                             {slope_of_unit_x_, slope_of_unit_y_, moving_tangent_, start_ratio,
                              least_start, share_of_fall},
                             nx(), candidates_.row(y), {slides_x, slides_y, words}, left_.row(y));
    for_each_bit(left_, y, [&](int x) {
        slides_x[x] = slides_y[x] = 0.0;
        const Falls falls(here[x] - here[west(x)], here[x] - here[east(x)], here[x] - below[x],
                          here[x] - above[x]);
        const double a = falls.x * slope_of_unit_x_;
        const double b = falls.y * slope_of_unit_y_;
        if (!(a * a + b * b > least_start)) return;
        const Slide slide = slide_of(falls, here[x] - rock[x], tangent_at(x, y), start_ratio);
        if (!slide.any()) return;
        slides_x[x] = static_cast<double>(slide.x);
        slides_y[x] = static_cast<double>(slide.y);
        words[x / CellBitset::word_bits] |= CellBitset::Word{1}
                                            << static_cast<unsigned>(x % CellBitset::word_bits);
        ++count;
    });
    for (int w = 0; w < slid_.words(); ++w) slid_.row(y)[w] |= words[w];
    sliding_.set_any(y, count > 0);
    return count;
}

/// Moves what slides to, within and from a row. Where something slid, and beside it, the next pass
/// looks.
void SlopeRelaxation::settle_row(FixedPointGrid& surface, int y) {
    const int below = south(y);
    const int above = north(y);
    CellBitset::Word all = 0;
    if (sliding_.any(y) || sliding_.any(below) || sliding_.any(above)) {
        CellBitset::Word* words = candidates_.row(y);
        for (int w = 0; w < candidates_.words(); ++w) {
            words[w] = sliding_.row(y)[w] | sliding_.from_west(y, w, periodic_x()) |
                       sliding_.from_east(y, w, periodic_x()) | sliding_.row(below)[w] |
                       sliding_.row(above)[w];
            all |= words[w];
        }
    }
    candidates_.set_any(y, all != 0);
    if (all == 0) return;
    const auto from = [&](int row) {
        return row == y ? no_slides_.data() : slides_y_.row(places_.of(row)).data();
    };
    const double* slides_x = slides_x_.row(places_.of(y)).data();
    const double* slides_y = slides_y_.row(places_.of(y)).data();
    const double* from_below = from(below);
    const double* from_above = from(above);
    std::int64_t* heights = surface.row(y).data();
    slope_vectors::settle({slides_x, slides_y, from_below, from_above}, nx(), candidates_.row(y),
                          heights, left_.row(y));
    for_each_bit(left_, y, [&](int x) {
        double change = -(std::abs(slides_x[x]) + std::abs(slides_y[x]));
        const int w = west(x);
        const int e = east(x);
        if (w != x) change += std::max(slides_x[w], 0.0);
        if (e != x) change += std::max(-slides_x[e], 0.0);
        change += std::max(from_below[x], 0.0) + std::max(-from_above[x], 0.0);
        heights[x] += static_cast<std::int64_t>(change);
    });
}

/// The first pass looks at all cells.
std::int64_t SlopeRelaxation::slide_row_in_pass(const FixedPointGrid& surface,
                                                const AvalancheFloor& floor, int y, int pass) {
    if (pass > 0) return slide_row(surface, floor, y, sliding_ratio_);
    if (clears_slides_ || places_.are_few()) {
        std::ranges::fill(slides_x_.row(places_.of(y)), 0.0);
        std::ranges::fill(slides_y_.row(places_.of(y)), 0.0);
    }
    mark_row(surface, y);
    return slide_row(surface, floor, y, start_ratio_);
}

/// Goes on with at most so many passes from pass `done` on, all cells of one before those of the
/// next as far as results tell, and returns how many cells slid in each.
std::vector<std::int64_t> SlopeRelaxation::run_passes(FixedPointGrid& surface,
                                                      const AvalancheFloor& floor, const Plan& plan,
                                                      int done, int most) {
    const bool round = periodic_y() && ny() > 1;
    const bool seams = round || plan.strips > 1;
    const int margin = done == 0 && plan.prepare ? 1 : 0;
    const int rows = ny() / plan.strips;
    const int passes = seams ? std::min(most, PassWavefront::most_passes(rows, margin)) : most;
    const auto size = static_cast<std::size_t>(passes);
    std::vector<std::int64_t> counts(size);
    std::vector<std::int64_t> counts_of_strips(size * static_cast<std::size_t>(plan.strips));
    const auto go = [&](int n, const PassWavefront& front, const auto& before_first) {
        std::int64_t* slid = counts_of_strips.data() + size * static_cast<std::size_t>(n);
        front.go(
            passes,
            [&](int pass, int y) {
                if (pass == 0) {
                    throw_if_cancelled();
                    before_first(y);
                }
                slid[pass] += slide_row_in_pass(surface, floor, row_of(y), done + pass);
            },
            [&](int, int y) { settle_row(surface, row_of(y)); });
    };
    const auto over_strips = [&](const auto& body) {
        const auto several = [&](int begin, int end) {
            for (int n = begin; n < end; ++n) body(n);
        };
        if (plan.strips == 1) {
            several(0, 1);
        } else {
            pool_.for_ranges(plan.strips, several);
        }
    };
    over_strips([&](int n) {
        const int begin = PassWavefront::strip_begin(ny(), n, plan.strips);
        const int end = PassWavefront::strip_begin(ny(), n + 1, plan.strips);
        int next = margin > 0 ? begin : end;
        const auto prepare_to = [&](int last) {
            for (; next < std::min(last, end); ++next) plan.prepare(next);
        };
        go(n,
           PassWavefront::of_strip(begin, end, n > 0 || round, n + 1 < plan.strips || round,
                                   margin),
           [&](int y) { prepare_to(y + 2); });
        prepare_to(end);
    });
    over_strips([&](int n) {
        const int begin = PassWavefront::strip_begin(ny(), n, plan.strips);
        if (n > 0 || round) go(n, PassWavefront::of_seam(begin, margin), [](int) {});
    });
    for (std::size_t n = 0; n < counts_of_strips.size(); ++n)
        counts[n % size] += counts_of_strips[n];
    return counts;
}

SlopeRelaxation::Outcome SlopeRelaxation::relax(FixedPointGrid& surface,
                                                const AvalancheFloor& floor, int most_passes,
                                                RestCheck rest_check,
                                                const std::function<void(int)>& prepare) {
    constexpr std::int64_t least_shared_cells = 500;  // cells
    constexpr int least_rows = 16;
    Plan plan{std::clamp(ny() / least_rows, 1, pool_.size()), prepare};
    if (prepare && (ny() < least_rows || most_passes == 0)) {
        for (int y = 0; y < ny(); ++y) prepare(y);
        plan.prepare = nullptr;
    }
    clears_slides_ = std::exchange(slides_left_, true);
    if (most_passes == 1) {
        places_.take_few(plan.strips);
    } else {
        places_.take_all();
    }
    for (int done = 0; done < most_passes;) {
        const auto counts =
            run_passes(surface, floor, plan, done, std::min(passes_at_once, most_passes - done));
        const auto rest = std::ranges::find(counts, std::int64_t{0});
        done += static_cast<int>(rest - counts.begin());
        if (rest != counts.end()) {
            slides_left_ = places_.are_few();
            return {done, true};
        }
        if (counts.back() < least_shared_cells) plan.strips = 1;
    }
    // What would slide next has to be found where it is remembered as sliding.
    if (rest_check == RestCheck::skipped && most_passes > 0 && slid_.words() == 0)
        return {most_passes, false};
    places_.take_all();
    std::atomic<bool> at_rest = true;
    pool_.for_ranges(ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            throw_if_cancelled();
            if (slide_row_in_pass(surface, floor, y, most_passes) > 0) at_rest = false;
        }
    });
    return {most_passes, at_rest};
}

bool SlopeRelaxation::relax_near(FixedPointGrid& surface, const FixedPointGrid& floor,
                                 std::span<const std::size_t> cells, std::int64_t most_moves) {
    if (queued_.empty()) queued_.resize(surface.size());
    queue_.clear();
    const auto add = [&](int x, int y) {
        const std::size_t cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(nx()) +
                                 static_cast<std::size_t>(x);
        if (queued_[cell] != 0) return;
        queued_[cell] = 1;
        queue_.push_back(cell);
    };
    const auto add_around = [&](int x, int y) {
        add(x, y);
        add(west(x), y);
        add(east(x), y);
        add(x, south(y));
        add(x, north(y));
    };
    const auto x_of = [&](std::size_t cell) {
        return static_cast<int>(cell % static_cast<std::size_t>(nx()));
    };
    const auto y_of = [&](std::size_t cell) {
        return static_cast<int>(cell / static_cast<std::size_t>(nx()));
    };
    for (const std::size_t cell : cells) add_around(x_of(cell), y_of(cell));
    const std::size_t at_start = queue_.size();
    std::int64_t moves = 0;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
        const std::size_t cell = queue_[next];
        queued_[cell] = 0;
        const int x = x_of(cell);
        const int y = y_of(cell);
        const Slide slide =
            slide_at(surface, floor, x, y, next < at_start ? start_ratio_ : sliding_ratio_);
        if (!slide.any()) continue;
        if (++moves > most_moves) {
            for (; next < queue_.size(); ++next) queued_[queue_[next]] = 0;
            return false;
        }
        surface(x, y) -= std::abs(slide.x) + std::abs(slide.y);
        if (slid_.words() > 0) {
            slid_.row(y)[x / CellBitset::word_bits] |=
                CellBitset::Word{1} << static_cast<unsigned>(x % CellBitset::word_bits);
        }
        if (slide.x != 0) surface(slide.x > 0 ? east(x) : west(x), y) += std::abs(slide.x);
        if (slide.y != 0) surface(x, slide.y > 0 ? north(y) : south(y)) += std::abs(slide.y);
        add_around(x, y);
        if (slide.x != 0) add_around(slide.x > 0 ? east(x) : west(x), y);
        if (slide.y != 0) add_around(x, slide.y > 0 ? north(y) : south(y));
    }
    return true;
}

double SlopeRelaxation::steepest(const FixedPointGrid& surface, const FixedPointGrid& floor) const {
    double steepest = 0.0;
    for (int y = 0; y < ny(); ++y) {
        for (int x = 0; x < nx(); ++x) {
            if (surface(x, y) <= floor(x, y)) continue;
            const Falls falls = falls_at(surface, x, y);
            const double a = falls.x * slope_of_unit_x_;
            const double b = falls.y * slope_of_unit_y_;
            steepest = std::max(steepest, std::sqrt(a * a + b * b));
        }
    }
    return elementary::atan(steepest) * degrees_per_radian;
}

}  // namespace fumon
