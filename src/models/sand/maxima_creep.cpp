#include "models/sand/maxima_creep.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>

#include "base/cancellation.h"
#include "base/worker_pool.h"
#include "models/sand/creep_vectors.h"

namespace fumon {

namespace {

constexpr int fewest_rows = 16;     // of a part: a few are swept again
constexpr std::size_t stages = 64;  // rows of a part after which a guess may come true

bool same_bits(std::span<const double> a, std::span<const double> b) {
    return std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

void assign(std::span<const double> from, std::vector<double>& to) {
    to.assign(from.begin(), from.end());
}

/// The eight neighbours of a cell of a periodic bed, in the order of Sudo's program.
struct Neighbours {
    double* south;
    double* here;
    double* north;
    int west;
    int x;
    int east;

    [[nodiscard]] bool below_cell() const {
        const double height = here[x];  // no short cuts: their jumps cannot be foreseen
        const auto below = [height](const double* row, int column) {
            return static_cast<unsigned>(height > row[column]);
        };
        return (below(here, west) & below(here, east) & below(south, x) & below(north, x) &
                below(south, west) & below(north, west) & below(south, east) &
                below(north, east)) != 0;
    }

    void topple(double rate) const {
        const double given = rate * here[x] * 0.25;
        const double to_side = given * (2.0 / 3.0);
        const double to_corner = given * (1.0 / 3.0);
        here[west] += to_side;
        here[east] += to_side;
        south[x] += to_side;
        north[x] += to_side;
        south[west] += to_corner;
        north[west] += to_corner;
        south[east] += to_corner;
        north[east] += to_corner;
        here[x] -= rate * here[x];
    }
};

}  // namespace

void MaximaCreep::operator()(Grid& bed, Grid& scratch, double rate, WorkerPool& pool) {
    divide(bed, pool.size());
    const int count = static_cast<int>(parts_.size());
    const auto for_parts = [&](auto work) {
        pool.for_ranges(count, [&](int begin, int end) {
            for (int k = begin; k < end; ++k) work(parts_[static_cast<std::size_t>(k)]);
        });
    };
    for_parts([&](Part& part) { prepare(bed, scratch, part); });
    for_parts([&](Part& part) { sweep(bed, part, rate); });
    for (std::size_t k = 1; k < parts_.size(); ++k)
        sweep_again(bed, scratch, parts_[k - 1], parts_[k], rate);
    const Part& last = parts_.back();
    if (last.end < ny_) {
        add_marks_ahead(last);
        std::ranges::copy(last.ahead, bed.row(last.end).begin());
    }
    for (int y = last.end; y < ny_; ++y) {
        double* south = bed.row((y + ny_ - 1) % ny_).data();
        visit({y, south, bed.row(y).data(), bed.row((y + 1) % ny_).data()}, nullptr, rate);
    }
}

/// The last two rows are in no part: the first row gives to the last one before it is visited.
void MaximaCreep::divide(const Grid& bed, int threads) {
    nx_ = bed.nx();
    ny_ = bed.ny();
    const auto width = static_cast<std::size_t>(nx_);
    words_ = (width + 63) / 64;
    marks_.resize(words_ * static_cast<std::size_t>(std::max(ny_, 2)));
    const int rows = std::max(0, ny_ - 2);
    const int count = std::clamp(rows / fewest_rows, 1, threads);
    parts_.resize(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        Part& part = parts_[static_cast<std::size_t>(k)];
        part.begin = static_cast<int>(std::int64_t{rows} * k / count);
        part.end = static_cast<int>(std::int64_t{rows} * (k + 1) / count);
        part.marks_ahead.assign(2 * words_, 0);
        part.stages.resize(k == 0 ? 0 : 2 * stages);
        part.sides.resize(width + 2);
        part.column.resize(width + 2);
    }
}

/// Marks the strict maxima of the bed as it is, and the first and last cell of every row.
void MaximaCreep::mark(const Grid& bed, int begin, int end, Part& part) {
    for (int y = begin; y < end; ++y) {
        throw_if_cancelled();
        creep_vectors::mark_maxima(bed.row((y + ny_ - 1) % ny_).data(), bed.row(y).data(),
                                   bed.row((y + 1) % ny_).data(), nx_, part.sides.data(),
                                   part.column.data(), marks(y));
    }
}

void MaximaCreep::prepare(const Grid& bed, Grid& originals, Part& part) {
    const bool is_last = &part == &parts_.back();
    mark(bed, part.begin, is_last ? ny_ : part.end, part);
    assign(bed.row(part.end), part.ahead);
    if (part.begin == 0) return;
    assign(bed.row(part.begin - 1), part.behind);
    for (int y = part.begin; y < part.end; ++y)
        std::ranges::copy(bed.row(y), originals.row(y).begin());
}

void MaximaCreep::sweep(Grid& bed, Part& part, double rate) {
    for (int y = part.begin; y < part.end; ++y) {
        double* south = part.behind.data();
        if (y > part.begin || y == 0) south = bed.row(y == 0 ? ny_ - 1 : y - 1).data();
        const std::span<double> here = bed.row(y);
        const std::span<double> north = y + 1 < part.end ? bed.row(y + 1) : part.ahead;
        visit({y, south, here.data(), north.data()}, &part, rate);
        const std::size_t stage = 2 * static_cast<std::size_t>(y - part.begin);
        if (stage >= part.stages.size()) continue;
        assign(here, part.stages[stage]);
        assign(north, part.stages[stage + 1]);
    }
}

/// `before` has come out right.
void MaximaCreep::sweep_again(Grid& bed, Grid& originals, const Part& before, Part& part,
                              double rate) {
    add_marks_ahead(before);
    Row here = before.ahead;
    Row north;
    const bool is_last = &part == &parts_.back();
    for (int y = part.begin; y < part.end; ++y) {
        const bool inside = y + 1 < part.end || !is_last;
        assign(inside ? originals.row(y + 1) : bed.row(y + 1), north);
        visit({y, bed.row(y - 1).data(), here.data(), north.data()}, &part, rate);
        const std::size_t stage = 2 * static_cast<std::size_t>(y - part.begin);
        if (stage < part.stages.size() && same_bits(here, part.stages[stage]) &&
            same_bits(north, part.stages[stage + 1])) {
            return;
        }
        std::ranges::copy(here, bed.row(y).begin());
        std::swap(here, north);
    }
    part.ahead = here;
}

/// Every marked cell of a row gives if it is a maximum now.
void MaximaCreep::visit(const Visited& row, Part* part, double rate) {
    throw_if_cancelled();
    const auto [y, south, here, north] = row;
    const Word* waiting_marks = marks(y);
    Word* next_marks = marks_for_row((y + 1) % ny_, part);
    for (std::size_t word = 0; word < words_; ++word) {
        Word not_passed = ~Word{0};
        while (const Word waiting = waiting_marks[word] & not_passed) {
            const int bit = std::countr_zero(waiting);
            const int x = static_cast<int>(word) * 64 + bit;
            not_passed = ~Word{1} << static_cast<unsigned>(bit);
            const Neighbours around{
                south, here, north, x == 0 ? nx_ - 1 : x - 1, x, x + 1 == nx_ ? 0 : x + 1};
            if (!around.below_cell()) continue;
            const bool takes = here[x] < 0.0;
            around.topple(rate);
            if (takes || y == 0 || bit == 0 || bit == 63 || x + 1 == nx_) {
                mark_around(x, y, takes ? 2 : 1, part);
            } else {
                const Word three = Word{7} << static_cast<unsigned>(bit - 1);
                marks(y)[word] |= three;
                next_marks[word] |= three;
            }
        }
    }
}

/// Marks the cells that a cell may have made maxima by giving: its neighbours, which were raised
/// and stand beside a lower one. A cell below zero takes instead, and lowers its neighbours, so
/// that theirs may have become maxima. Marks behind the sweep do no harm.
void MaximaCreep::mark_around(int x, int y, int reach, Part* part) {
    for (int dy = -reach; dy <= reach; ++dy) {
        Word* row = marks_for_row((y + dy + 2 * ny_) % ny_, part);
        if (row == nullptr) continue;
        for (int dx = -reach; dx <= reach; ++dx) {
            const auto marked = static_cast<unsigned>((x + dx + 2 * nx_) % nx_);
            row[marked / 64] |= Word{1} << (marked % 64);
        }
    }
}

/// Where a part marks a row: none of another part's, which that may be visiting, but its own ones
/// of those to come after it. Part 0 has the two last rows behind it, which nobody visits yet.
MaximaCreep::Word* MaximaCreep::marks_for_row(int row, Part* part) {
    if (part == nullptr || (part->begin <= row && row < part->end)) return marks(row);
    if (row == part->end) return part->marks_ahead.data();
    if (row == part->end + 1) return part->marks_ahead.data() + words_;
    return part->begin == 0 && row >= ny_ - 2 ? marks(row) : nullptr;
}

void MaximaCreep::add_marks_ahead(const Part& part) {
    Word* to = marks(part.end);
    for (std::size_t k = 0; k < part.marks_ahead.size(); ++k) to[k] |= part.marks_ahead[k];
}

}  // namespace fumon
