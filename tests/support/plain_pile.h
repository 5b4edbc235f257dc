#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "base/avalanche.h"
#include "base/random.h"
#include "models/pile/sandpile_parameters.h"
#include "models/pile/toppling.h"

namespace fumon {

/// Whether a cell of direction `own` (9: a drop site) counts the neighbour in this direction when
/// it decides whether to topple.
inline bool looks_at(const SandpileParameters& parameters, int own, int direction) {
    if (parameters.topple_toward == ToppleToward::any_lower || own == 0 || own == 9) return true;
    const std::int64_t left_over = parameters.grains_per_topple % 3;
    const bool few = parameters.grains_per_topple < 3;
    if (direction == own) return !(few && left_over == 2);
    return (direction == turned(own, 1) || direction == turned(own, -1)) &&
           !(few && left_over == 1);
}

/// The rule of Higashi & Takamori (2003) written down as it is read, to compare the fast pile with:
/// the paper's arrays (Y downward), every cell visited in every sweep.
class PlainPile {
  public:
    PlainPile(const SandpileParameters& parameters, const Grid& bed, std::uint64_t seed)
        : parameters_(parameters),
          seed_(seed),
          columns_(bed.nx()),
          rows_(bed.ny()),
          height_(bed.size()),
          direction_(bed.size()),
          changes_(bed.size()) {
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column)
                height_[at(column, row)] = static_cast<int>(bed(column, rows_ - 1 - row));
        }
        if (parameters.drop_x.empty()) {
            sites_.push_back(at(columns_ / 2, rows_ / 2));
        }
        for (std::size_t site = 0; site < parameters.drop_x.size(); ++site) {
            sites_.push_back(at(static_cast<int>(parameters.drop_x[site]),
                                rows_ - 1 - static_cast<int>(parameters.drop_y[site])));
        }
    }

    void settle() {
        std::vector<int> all;
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column) {
                if (unstable(column, row)) all.push_back(static_cast<int>(at(column, row)));
            }
        }
        if (!all.empty()) topple_from(all, 0);
        std::fill(changes_.begin(), changes_.end(), 0);
    }

    Avalanche drop() {
        std::size_t turn = static_cast<std::size_t>(grain_) % sites_.size();
        ++grain_;
        if (parameters_.drop_choice == DropChoice::random) {
            turn = RandomStream(seed_, 0, grain_, Purpose::drop_sites)
                       .below(static_cast<std::uint32_t>(sites_.size()));
        }
        const std::size_t cell = sites_[turn];
        ++height_[cell];
        if (!unstable(column_of(cell), row_of(cell))) return {};
        return topple_from({static_cast<int>(cell)}, grain_);
    }

    [[nodiscard]] Grid heights() const { return grid(height_); }
    [[nodiscard]] Grid changes() const { return grid(changes_); }
    [[nodiscard]] std::int64_t lost() const { return lost_; }

  private:
    [[nodiscard]] std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] int column_of(std::size_t cell) const {
        return static_cast<int>(cell) % columns_;
    }
    [[nodiscard]] int row_of(std::size_t cell) const { return static_cast<int>(cell) / columns_; }
    [[nodiscard]] bool inside(int column, int row) const {
        return column >= 0 && column < columns_ && row >= 0 && row < rows_;
    }
    [[nodiscard]] bool is_site(std::size_t cell) const {
        return std::find(sites_.begin(), sites_.end(), cell) != sites_.end();
    }

    [[nodiscard]] bool unstable(int column, int row) const {
        const std::size_t cell = at(column, row);
        for (int direction = 1; direction <= 8; ++direction) {
            const int own = is_site(cell) ? 9 : direction_[cell];
            const int x = column + ring_step(direction).dx;
            const int y = row + ring_step(direction).dy;
            const int low = inside(x, y) ? height_[at(x, y)] : 0;
            if (looks_at(parameters_, own, direction) &&
                height_[cell] - low >= parameters_.threshold)
                return true;
        }
        return false;
    }

    void topple(int column, int row, RandomStream& stream) {
        const std::size_t cell = at(column, row);
        int direction = direction_[cell];
        if (is_site(cell) || direction == 0) {
            direction = parameters_.drop_direction == DropDirection::cycling
                            ? static_cast<int>(drawn_ % 8) + 1
                            : static_cast<int>(stream.below(8)) + 1;
            ++drawn_;
            direction_[cell] = direction;
        }
        changes_[cell] += changes_[cell] == 0 ? 2 : 1;
        int left = static_cast<int>(parameters_.grains_per_topple);
        height_[cell] -= left;
        std::array<int, 3> share{};
        for (; left >= 3; left -= 3) {
            for (int& one : share) ++one;
        }
        if (left == 1) ++share[1];
        if (left == 2) ++share[0], ++share[2];
        for (int side = 0; side < 3; ++side) {
            const int given = share[static_cast<std::size_t>(side)];
            const int to = turned(direction, side - 1);
            const int x = column + ring_step(to).dx;
            const int y = row + ring_step(to).dy;
            if (given == 0) continue;
            if (!inside(x, y)) {
                lost_ += given;
                continue;
            }
            height_[at(x, y)] += given;
            if (!is_site(at(x, y))) turn(direction_[at(x, y)], to, stream);
            if (changes_[at(x, y)] == 0) changes_[at(x, y)] = 1;
        }
    }

    void turn(int& direction, int to, RandomStream& stream) {
        const DirectionRule rule = parameters_.direction;
        const int toward = direction_after(rule, direction, to, HalfStep::toward_incoming);
        const int previous = direction_after(rule, direction, to, HalfStep::toward_previous);
        bool stay = false;
        if (toward != previous) {
            ++drawn_;
            stay = parameters_.drop_direction == DropDirection::cycling ? drawn_ % 2 != 0
                                                                        : stream.below(2) != 0;
        }
        direction = stay ? previous : toward;
    }

    Avalanche topple_from(const std::vector<int>& cells, std::int64_t grain) {
        std::fill(changes_.begin(), changes_.end(), 0);
        RandomStream stream(seed_, 0, grain, Purpose::toppling_directions);
        Avalanche avalanche;
        const std::int64_t lost_before = lost_;
        if (parameters_.order == ToppleOrder::sweep) {
            sweep(avalanche, stream);
        } else {
            serve({cells.begin(), cells.end()}, avalanche, stream);
        }
        for (const int change : changes_) avalanche.size += change > 0 ? 1 : 0;
        avalanche.lost = lost_ - lost_before;
        return avalanche;
    }

    void sweep(Avalanche& avalanche, RandomStream& stream) {
        for (bool quiet = false; !quiet;) {
            quiet = true;
            for (int row = 0; row < rows_; ++row) {
                for (int column = 0; column < columns_; ++column) {
                    if (!unstable(column, row)) continue;
                    topple(column, row, stream);
                    ++avalanche.topplings;
                    quiet = false;
                }
            }
            if (!quiet) ++avalanche.duration;
        }
    }

    void serve(std::deque<int> queue, Avalanche& avalanche, RandomStream& stream) {
        std::size_t generation = queue.size();
        bool toppled = false;
        while (!queue.empty()) {
            const auto cell = static_cast<std::size_t>(queue.front());
            queue.pop_front();
            if (unstable(column_of(cell), row_of(cell))) {
                topple(column_of(cell), row_of(cell), stream);
                ++avalanche.topplings;
                toppled = true;
                for (int y = row_of(cell) - 1; y <= row_of(cell) + 1; ++y) {
                    for (int x = column_of(cell) - 1; x <= column_of(cell) + 1; ++x) {
                        if (!inside(x, y) || !unstable(x, y)) continue;
                        const int one = static_cast<int>(at(x, y));
                        if (std::find(queue.begin(), queue.end(), one) == queue.end())
                            queue.push_back(one);
                    }
                }
            }
            if (--generation == 0) {
                avalanche.duration += toppled ? 1 : 0;
                toppled = false;
                generation = queue.size();
            }
        }
    }

    [[nodiscard]] Grid grid(const std::vector<int>& values) const {
        Grid field(columns_, rows_);
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column)
                field(column, rows_ - 1 - row) = values[at(column, row)];
        }
        return field;
    }

    SandpileParameters parameters_;
    std::uint64_t seed_;
    int columns_;
    int rows_;
    std::vector<int> height_;
    std::vector<int> direction_;
    std::vector<int> changes_;
    std::vector<std::size_t> sites_;
    std::int64_t grain_ = 0;
    std::int64_t drawn_ = 0;
    std::int64_t lost_ = 0;
};

}  // namespace fumon
