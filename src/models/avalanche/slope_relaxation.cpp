#include "models/avalanche/slope_relaxation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/give_up.h"
#include "base/units.h"
#include "base/worker_pool.h"
#include "models/avalanche/slope_vectors.h"

namespace fumon {

namespace {

/// Of the excess fall to the lower neighbour, what a pass moves: the diffusion number along each
/// axis. Above ¼ the shortest diagonal waves grow.
constexpr double share_of_fall = 0.25;

double tangent(double degrees) {
    return elementary::sin(degrees * degree) / elementary::cos(degrees * degree);
}

template <class Body>
void for_each_bit(const CellRows& cells, int y, const Body& body) {
    const CellRows::Word* words = cells.row(y);
    for (int w = 0; w < cells.words(); ++w) {
        for (CellRows::Word left = words[w]; left != 0; left &= left - 1)
            body(w * CellRows::word_bits + std::countr_zero(left));
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
      from_west_(ground.nx, ground.ny),
      from_east_(ground.nx, ground.ny),
      slides_x_(ground.nx, ground.ny),
      slides_y_(ground.nx, ground.ny),
      row_counts_(static_cast<std::size_t>(ground.ny)) {}

void SlopeRelaxation::set_moving_angles(const Grid& degrees) {
    moving_tangents_ = Grid(nx(), ny());
    std::ranges::transform(degrees.values(), moving_tangents_.values().begin(), tangent);
    least_tangent_ = *std::ranges::min_element(moving_tangents_.values());
}

SlopeRelaxation::Falls SlopeRelaxation::falls_at(const WholeGrid& surface, int x, int y) const {
    const std::int64_t here = surface(x, y);
    return {here - surface(west(x), y), here - surface(east(x), y), here - surface(x, south(y)),
            here - surface(x, north(y))};
}

SlopeRelaxation::Slide SlopeRelaxation::slide_at(const WholeGrid& surface, const WholeGrid& floor,
                                                 int x, int y, double start_ratio) const {
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
        across = falls.way_y != 0 ? loose - along : 0;
        if (falls.way_y == 0) along = loose;
    }
    return {along * falls.way_x, across * falls.way_y};
}

/// Candidates of the first pass: all cells of a row that are steep enough to start.
void SlopeRelaxation::mark_row(const WholeGrid& surface, int y) {
    const double start = least_tangent_ * start_ratio_;
    CellRows::Word* words = candidates_.row(y);
    slope_vectors::mark_steep(surface.row(south(y)).data(), surface.row(y).data(),
                              surface.row(north(y)).data(), slope_of_unit_x_ * slope_of_unit_x_,
                              slope_of_unit_y_ * slope_of_unit_y_, start * start, nx(), words);
    words[0] |= 1U;
    words[(nx() - 1) / CellRows::word_bits] |=
        CellRows::Word{1} << static_cast<unsigned>((nx() - 1) % CellRows::word_bits);
    candidates_.set_any(y, true);
}

std::int64_t SlopeRelaxation::slide_row(const WholeGrid& surface, const WholeGrid& floor, int y,
                                        double start_ratio) {
    std::int64_t count = 0;
    CellRows::Word* words = sliding_.row(y);
    if (sliding_.any(y)) std::fill_n(words, sliding_.words(), CellRows::Word{0});
    if (candidates_.any(y)) {
        const std::int64_t* here = surface.row(y).data();
        const std::int64_t* below = surface.row(south(y)).data();
        const std::int64_t* above = surface.row(north(y)).data();
        const std::int64_t* rock = floor.row(y).data();
        const double least_start = least_tangent_ * start_ratio * least_tangent_ * start_ratio;
        slope_vectors::slide({below, here, above, rock,
                              moving_tangents_.empty() ? nullptr : moving_tangents_.row(y).data()},
                             {slope_of_unit_x_, slope_of_unit_y_, moving_tangent_, start_ratio,
                              least_start, share_of_fall},
                             nx(), candidates_.row(y),
                             {slides_x_.row(y).data(), slides_y_.row(y).data(), words},
                             left_.row(y));
        for_each_bit(left_, y, [&](int x) {
            const Falls falls(here[x] - here[west(x)], here[x] - here[east(x)], here[x] - below[x],
                              here[x] - above[x]);
            const double a = falls.x * slope_of_unit_x_;
            const double b = falls.y * slope_of_unit_y_;
            if (!(a * a + b * b > least_start)) return;
            const Slide slide = slide_of(falls, here[x] - rock[x], tangent_at(x, y), start_ratio);
            if (!slide.any()) return;
            slides_x_(x, y) = slide.x;
            slides_y_(x, y) = slide.y;
            words[x / CellRows::word_bits] |= CellRows::Word{1}
                                              << static_cast<unsigned>(x % CellRows::word_bits);
        });
        for (int w = 0; w < sliding_.words(); ++w) count += std::popcount(words[w]);
        for (int w = 0; w < slid_.words(); ++w) slid_.row(y)[w] |= words[w];
    }
    sliding_.set_any(y, count > 0);
    return count;
}

/// Moves what slides to, within and from a row. Where something slid, and beside it, the next pass
/// looks.
void SlopeRelaxation::settle_row(WholeGrid& surface, int y) {
    const int below = south(y);
    const int above = north(y);
    CellRows::Word all = 0;
    if (sliding_.any(y) || sliding_.any(below) || sliding_.any(above)) {
        CellRows::Word* words = candidates_.row(y);
        for (int w = 0; w < candidates_.words(); ++w) {
            from_west_.row(y)[w] = sliding_.from_west(y, w, periodic_x());
            from_east_.row(y)[w] = sliding_.from_east(y, w, periodic_x());
            words[w] = sliding_.row(y)[w] | from_west_.row(y)[w] | from_east_.row(y)[w] |
                       sliding_.row(below)[w] | sliding_.row(above)[w];
            all |= words[w];
        }
    }
    candidates_.set_any(y, all != 0);
    if (all == 0) return;
    if (below == y || above == y) {  // nothing slides over an edge, nor round a single row
        std::copy_n(candidates_.row(y), candidates_.words(), left_.row(y));
    } else {
        slope_vectors::settle(
            {slides_x_.row(y).data(), slides_y_.row(y).data(), slides_y_.row(below).data(),
             slides_y_.row(above).data(), sliding_.row(y), from_west_.row(y), from_east_.row(y),
             sliding_.row(below), sliding_.row(above)},
            nx(), candidates_.row(y), surface.row(y).data(), left_.row(y));
    }
    for_each_bit(left_, y, [&](int x) {
        std::int64_t change = 0;
        if (sliding_.contains(x, y))
            change -= std::abs(slides_x_(x, y)) + std::abs(slides_y_(x, y));
        const int w = west(x);
        const int e = east(x);
        if (w != x && sliding_.contains(w, y)) change += std::max<std::int64_t>(slides_x_(w, y), 0);
        if (e != x && sliding_.contains(e, y))
            change += std::max<std::int64_t>(-slides_x_(e, y), 0);
        if (below != y && sliding_.contains(x, below))
            change += std::max<std::int64_t>(slides_y_(x, below), 0);
        if (above != y && sliding_.contains(x, above))
            change += std::max<std::int64_t>(-slides_y_(x, above), 0);
        surface(x, y) += change;
    });
}

SlopeRelaxation::Outcome SlopeRelaxation::relax(WholeGrid& surface, const WholeGrid& floor,
                                                int most_passes, Ending ending) {
    constexpr std::int64_t worth_sharing = 2000;  // cells
    std::int64_t count = worth_sharing;
    const auto over_rows = [&](const auto& body) {
        if (count < worth_sharing) {
            body(0, ny());
        } else {
            pool_.for_ranges(ny(), body);
        }
    };
    for (int pass = 0;; ++pass) {
        const bool first = pass == 0;
        over_rows([&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                give_up_if_asked();
                if (first) mark_row(surface, y);
                row_counts_[static_cast<std::size_t>(y)] =
                    slide_row(surface, floor, y, first ? start_ratio_ : sliding_ratio_);
            }
        });
        count = std::accumulate(row_counts_.begin(), row_counts_.end(), std::int64_t{0});
        if (count == 0) return {pass, true};
        if (pass == most_passes) return {pass, false};
        over_rows([&](int begin, int end) {
            for (int y = begin; y < end; ++y) settle_row(surface, y);
        });
        // What would slide next has to be found where it is remembered as sliding.
        if (ending == Ending::unseen && pass + 1 == most_passes && slid_.words() == 0)
            return {most_passes, false};
    }
}

bool SlopeRelaxation::relax_near(WholeGrid& surface, const WholeGrid& floor,
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
            slid_.row(y)[x / CellRows::word_bits] |=
                CellRows::Word{1} << static_cast<unsigned>(x % CellRows::word_bits);
        }
        if (slide.x != 0) surface(slide.x > 0 ? east(x) : west(x), y) += std::abs(slide.x);
        if (slide.y != 0) surface(x, slide.y > 0 ? north(y) : south(y)) += std::abs(slide.y);
        add_around(x, y);
        if (slide.x != 0) add_around(slide.x > 0 ? east(x) : west(x), y);
        if (slide.y != 0) add_around(x, slide.y > 0 ? north(y) : south(y));
    }
    return true;
}

double SlopeRelaxation::steepest(const WholeGrid& surface, const WholeGrid& floor) const {
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
