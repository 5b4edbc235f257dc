#include "models/pile/pile.h"

#include <algorithm>
#include <utility>

#include "base/cancellation.h"
#include "base/state_archive.h"
#include "models/pile/toppling.h"
#include "models/shared/cycle_detector.h"

namespace fumon {

namespace {

constexpr std::int32_t height_1 = 16;  // one height in a packed cell
constexpr std::int32_t direction_bits = 15;
constexpr std::int32_t drop_site = 9;  // table 1: the apex
constexpr std::int32_t outside = 10;

std::int32_t direction_of(std::int32_t packed) {
    return packed & direction_bits;
}

std::int32_t height_of(std::int32_t packed) {
    return packed / height_1;
}

}  // namespace

Pile::Pile(const SandpileParameters& parameters, const Grid& bed, std::span<const Site> apexes)
    : nx_(bed.nx()),
      ny_(bed.ny()),
      stride_(bed.nx() + 2),
      toward_direction_(parameters.topple_toward == ToppleToward::toward_direction),
      order_(parameters.order),
      threshold_(height_1 * static_cast<std::int32_t>(parameters.threshold)),
      moved_(height_1 * static_cast<std::int32_t>(parameters.grains_per_topple)) {
    const auto size = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(ny_ + 2);
    cells_.assign(size, outside);
    changes_.assign(size, 0);
    waiting_ = CellSet(size);
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x)
            cells_[cell_of({x, y})] = height_1 * static_cast<std::int32_t>(bed(x, y));
    }
    for (const Site& apex : apexes) cells_[cell_of(apex)] |= drop_site;

    for (int direction = 1; direction <= direction_count; ++direction) {
        const RingStep step = ring_step(direction);
        around_[static_cast<std::size_t>(direction - 1)] = step.dy * stride_ + step.dx;
    }
    for (std::ptrdiff_t place = 0; place < 9; ++place) {
        block_[static_cast<std::size_t>(place)] = (place / 3 - 1) * stride_ + place % 3 - 1;
    }
    const auto shares = shares_of(static_cast<int>(parameters.grains_per_topple));
    for (int direction = 1; direction <= direction_count; ++direction) {
        for (int side = 0; side < 3; ++side) {
            const int to = turned(direction, side - 1);
            receivers_[static_cast<std::size_t>(direction)][static_cast<std::size_t>(side)] = {
                around_[static_cast<std::size_t>(to - 1)], to,
                height_1 * shares[static_cast<std::size_t>(side)]};
        }
        for (int before = 0; before <= direction_count; ++before) {
            const auto b = static_cast<std::size_t>(before);
            const auto r = static_cast<std::size_t>(direction);
            after_[b][r] = direction_after(parameters.direction, before, direction);
            after_previous_[b][r] =
                direction_after(parameters.direction, before, direction, HalfStep::toward_previous);
            has_half_steps_ |= after_[b][r] != after_previous_[b][r];
        }
        after_[drop_site][static_cast<std::size_t>(direction)] = drop_site;
        after_previous_[drop_site][static_cast<std::size_t>(direction)] = drop_site;
    }
}

std::size_t Pile::cell_of(Site site) const {
    return static_cast<std::size_t>((ny_ - site.y) * stride_ + site.x + 1);
}

template <class Value>
Grid Pile::grid_of(Value value) const {
    Grid grid(nx_, ny_);
    for (int y = 0; y < ny_; ++y) {
        for (int x = 0; x < nx_; ++x) grid(x, y) = value(cell_of({x, y}));
    }
    return grid;
}

Grid Pile::heights() const {
    return grid_of([this](std::size_t cell) { return height_of(cells_[cell]); });
}

Grid Pile::directions() const {
    return grid_of([this](std::size_t cell) { return direction_of(cells_[cell]); });
}

Grid Pile::changes() const {
    return grid_of([this](std::size_t cell) { return changes_[cell]; });
}

void Pile::serialise(StateArchive& archive) {
    std::vector<std::int64_t> cells(cells_.begin(), cells_.end());
    std::vector<std::int64_t> changes(changes_.begin(), changes_.end());
    archive.values("pile_cells", cells);
    archive.values("pile_changes", changes);
    archive.count("lost_grains", lost_);
    reset_changes();
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        constexpr std::int64_t highest = std::int64_t{height_1} << 26;
        const bool edge = cells_[cell] == outside;
        const std::int64_t direction = cells[cell] & direction_bits;
        if (cells[cell] < 0 || cells[cell] > highest || edge != (cells[cell] == outside) ||
            (!edge && direction >= outside) || changes[cell] < 0 || changes[cell] > UINT32_MAX)
            archive.refuse("a cell of the pile has an invalid height or direction");
        cells_[cell] = static_cast<std::int32_t>(cells[cell]);
        changes_[cell] = static_cast<std::uint32_t>(changes[cell]);
        if (changes_[cell] != 0) changed_.push_back(cell);
    }
}

bool Pile::any_neighbour_at_most(std::size_t cell, std::int32_t limit) const {
    const std::int32_t* here = cells_.data() + cell;
    bool any = false;
    for (const std::ptrdiff_t offset : around_) any |= here[offset] <= limit;
    return any;
}

/// Whether some neighbour (of those that count) is lower by the threshold or more.
template <bool toward_direction>
bool Pile::unstable_by(std::size_t cell) const {
    const std::int32_t packed = cells_[cell];
    const std::int32_t limit = (packed | direction_bits) - threshold_;
    if constexpr (toward_direction) {
        const auto direction = static_cast<std::size_t>(direction_of(packed));
        if (direction != no_direction && direction != drop_site) {
            const auto& three = receivers_[direction];
            return std::any_of(three.begin(), three.end(), [&](const Receiver& receiver) {
                return receiver.given > 0 && (cells_.data() + cell)[receiver.offset] <= limit;
            });
        }
    }
    return any_neighbour_at_most(cell, limit);
}

bool Pile::unstable(std::size_t cell) const {
    return toward_direction_ ? unstable_by<true>(cell) : unstable_by<false>(cell);
}

void Pile::note_change(std::size_t cell, std::uint32_t change) {
    if (changes_[cell] == 0) {
        changed_.push_back(cell);
        changes_[cell] = 1;
    }
    changes_[cell] += change;
}

void Pile::reset_changes() {
    for (const std::size_t cell : changed_) changes_[cell] = 0;
    changed_.clear();
}

/// Moves grains from this cell along its direction; `received` is told of each cell that gets some.
template <class Received>
void Pile::topple(std::size_t cell, TopplingDraws& draws, Received received) {
    std::int32_t direction = direction_of(cells_[cell]);
    if (direction == drop_site) {
        direction = draws.draw();
    } else if (direction == no_direction) {
        direction = draws.draw();
        cells_[cell] |= direction;
    }
    cells_[cell] -= moved_;
    note_change(cell, 1);
    for (const Receiver& receiver : receivers_[static_cast<std::size_t>(direction)]) {
        if (receiver.given == 0) continue;
        const std::size_t to = cell + static_cast<std::size_t>(receiver.offset);
        const auto before = static_cast<std::size_t>(direction_of(cells_[to]));
        if (before == outside) {
            lost_ += receiver.given / height_1;
            continue;
        }
        const auto came = static_cast<std::size_t>(receiver.direction);
        std::int32_t after = after_[before][came];
        if (has_half_steps_ && after != after_previous_[before][came] &&
            draws.toss() == HalfStep::toward_previous) {
            after = after_previous_[before][came];
        }
        cells_[to] += receiver.given - static_cast<std::int32_t>(before) + after;
        note_change(to, 0);
        received(to);
    }
}

/// Which cells may have become unstable by a topple: the receivers, the neighbours that the toppled
/// cell now lies far below, and the cell itself.
template <bool toward_direction>
void Pile::sweep_until_rest(TopplingDraws& draws, Avalanche& avalanche) {
    CycleDetector watch;
    bool toppled = true;
    while (toppled) {
        toppled = false;
        for (std::size_t cell = waiting_.next(0); cell != CellSet::none;
             cell = waiting_.next(cell + 1)) {
            throw_if_cancelled();
            waiting_.remove(cell);
            if (!unstable_by<toward_direction>(cell)) continue;
            topple(cell, draws, [this](std::size_t to) { waiting_.insert(to); });
            const std::int32_t far_above = (cells_[cell] & ~direction_bits) + threshold_;
            for (const std::ptrdiff_t offset : around_) {
                const std::size_t neighbour = cell + static_cast<std::size_t>(offset);
                if (cells_[neighbour] >= far_above) waiting_.insert(neighbour);
            }
            if (unstable_by<toward_direction>(cell)) waiting_.insert(cell);
            ++avalanche.topplings;
            toppled = true;
        }
        if (toppled) ++avalanche.duration;
        watch.observe(avalanche.topplings, draws.drawn(), changed_, cells_, {});
    }
}

void Pile::drain_queue(TopplingDraws& draws, Avalanche& avalanche) {
    const auto join = [this](std::size_t cell) {
        if (direction_of(cells_[cell]) == outside || waiting_.contains(cell) || !unstable(cell))
            return;
        waiting_.insert(cell);
        next_queue_.push_back(cell);
    };
    CycleDetector watch;
    for (std::size_t cell = waiting_.next(0); cell != CellSet::none; cell = waiting_.next(cell + 1))
        queue_.push_back(cell);
    while (!queue_.empty()) {
        bool toppled = false;
        for (const std::size_t cell : queue_) {
            throw_if_cancelled();
            waiting_.remove(cell);
            if (!unstable(cell)) continue;
            topple(cell, draws, [](std::size_t) {});
            for (const std::ptrdiff_t offset : block_)
                join(cell + static_cast<std::size_t>(offset));
            ++avalanche.topplings;
            toppled = true;
        }
        if (toppled) ++avalanche.duration;
        queue_.clear();
        std::swap(queue_, next_queue_);
        watch.observe(avalanche.topplings, draws.drawn(), changed_, cells_, queue_);
    }
}

/// From the cells in `waiting_`.
Avalanche Pile::topple_until_rest(TopplingDraws& draws) {
    reset_changes();
    Avalanche avalanche;
    const std::int64_t lost_before = lost_;
    if (order_ == ToppleOrder::first_in_first_out) {
        drain_queue(draws, avalanche);
    } else if (toward_direction_) {
        sweep_until_rest<true>(draws, avalanche);
    } else {
        sweep_until_rest<false>(draws, avalanche);
    }
    avalanche.size = static_cast<std::int64_t>(changed_.size());
    avalanche.lost = lost_ - lost_before;
    return avalanche;
}

std::int64_t Pile::settle(TopplingDraws& draws) {
    for (int y = ny_ - 1; y >= 0; --y) {
        throw_if_cancelled();
        for (int x = 0; x < nx_; ++x) {
            if (unstable(cell_of({x, y}))) waiting_.insert(cell_of({x, y}));
        }
    }
    const Avalanche settling = topple_until_rest(draws);
    reset_changes();
    return settling.topplings;
}

Avalanche Pile::drop(Site site, TopplingDraws& draws) {
    const std::size_t cell = cell_of(site);
    cells_[cell] += height_1;
    if (!unstable(cell)) return {};
    waiting_.insert(cell);
    return topple_until_rest(draws);
}

}  // namespace fumon
