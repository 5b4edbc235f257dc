#include "measure/bed/dune_components.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "measure/bed/periodic_wrap.h"
#include "measure/bed/row_pass_vectors.h"

namespace fumon {

namespace {

/// How many box lengths something is displaced in x and y.
struct Period {
    int x = 0;
    int y = 0;

    friend bool operator==(const Period&, const Period&) = default;
    friend Period operator+(Period a, Period b) { return {a.x + b.x, a.y + b.y}; }
    friend Period operator-(Period a, Period b) { return {a.x - b.x, a.y - b.y}; }
};

/// Disjoint sets of runs that also keep by how many periods each run lies off its set's root, and
/// so notice when a set meets a displaced copy of itself.
class UnwrappedSets {
  public:
    explicit UnwrappedSets(std::size_t count) : nodes_(count) {
        for (std::size_t i = 0; i < count; ++i) nodes_[i].parent = i;
    }

    struct Root {
        std::size_t index = 0;
        Period offset;  ///< of the asked run, against the root
    };

    Root root(std::size_t run) {
        Root found{run, {}};
        while (nodes_[found.index].parent != found.index) {
            found.offset = found.offset + nodes_[found.index].offset;
            found.index = nodes_[found.index].parent;
        }
        Period rest = found.offset;
        while (nodes_[run].parent != found.index && run != found.index) {
            const Node node = nodes_[run];
            nodes_[run] = {found.index, rest, node.wraps};
            rest = rest - node.offset;
            run = node.parent;
        }
        return found;
    }

    /// `b` displaced by `shift` touches `a`. The root is the run that comes first.
    void join(std::size_t a, std::size_t b, Period shift) {
        Root first = root(a);
        Root second = root(b);
        Period between = first.offset + shift - second.offset;  // of second's root against first's
        if (first.index == second.index) {
            if (!(between == Period{})) nodes_[first.index].wraps = true;
            return;
        }
        if (second.index < first.index) {
            std::swap(first, second);
            between = Period{} - between;
        }
        nodes_[second.index].parent = first.index;
        nodes_[second.index].offset = between;
        nodes_[first.index].wraps = nodes_[first.index].wraps || nodes_[second.index].wraps;
    }

    [[nodiscard]] bool wraps(std::size_t root_index) const { return nodes_[root_index].wraps; }

  private:
    struct Node {
        std::size_t parent = 0;
        Period offset;
        bool wraps = false;
    };
    std::vector<Node> nodes_;
};

/// The runs of every row, and where each row's begin (ny + 1 entries).
struct Runs {
    std::vector<RowRun> runs;
    std::vector<std::size_t> row_begin;
};

/// Adds the runs of a row of `count` cells, from `first` on, by the bits of those that are high:
/// noise has no pattern, so runs are found where bits change.
void add_runs(std::span<const std::uint64_t> words, std::size_t count, int y, int first,
              std::vector<RowRun>& runs) {
    constexpr std::size_t word = 64;
    std::uint64_t before = 0;
    bool open = false;
    for (std::size_t begin = 0; begin < count; begin += word) {
        const std::uint64_t high = words[begin / word];
        std::uint64_t changes = high ^ (high << 1U) ^ before;
        before = high >> (word - 1);
        if (count - begin < word) changes &= (std::uint64_t{1} << (count - begin)) - 1;
        for (; changes != 0; changes &= changes - 1) {
            const int x = first + static_cast<int>(begin) + std::countr_zero(changes);
            if (open) {
                runs.back().last = x - 1;
            } else {
                runs.push_back({y, x, 0});
            }
            open = !open;
        }
    }
    if (open) runs.back().last = first + static_cast<int>(count) - 1;
}

std::size_t words_of(std::size_t cells) {
    return (cells + 63) / 64;
}

Runs find_runs(const Grid& bed, double level) {
    Runs found;
    found.row_begin.reserve(static_cast<std::size_t>(bed.ny()) + 1);
    std::vector<std::uint64_t> words(words_of(static_cast<std::size_t>(bed.nx())));
    for (int y = 0; y < bed.ny(); ++y) {
        found.row_begin.push_back(found.runs.size());
        row_passes::mark_above(bed.row(y), level, words.data());
        add_runs(words, bed.row(y).size(), y, 0, found.runs);
    }
    found.row_begin.push_back(found.runs.size());
    return found;
}

/// Joins the runs of one row with those of the row above it (`above_shift` periods further north).
void join_rows(const Runs& found, std::size_t below, std::size_t above, int above_shift, int nx,
               bool periodic, UnwrappedSets& sets) {
    const std::size_t below_end = found.row_begin[below + 1];
    const std::size_t above_begin = found.row_begin[above];
    const std::size_t above_end = found.row_begin[above + 1];
    std::size_t candidate = above_begin;
    for (std::size_t run = found.row_begin[below]; run < below_end; ++run) {
        const RowRun& lower = found.runs[run];
        while (candidate < above_end && found.runs[candidate].last < lower.first - 1) ++candidate;
        for (std::size_t other = candidate;
             other < above_end && found.runs[other].first <= lower.last + 1; ++other) {
            sets.join(run, other, {0, above_shift});
        }
    }
    if (!periodic || found.row_begin[below] == below_end || above_begin == above_end) return;
    // Corners that touch across the edge in x.
    const RowRun& lower_west = found.runs[found.row_begin[below]];
    const RowRun& lower_east = found.runs[below_end - 1];
    const RowRun& upper_west = found.runs[above_begin];
    const RowRun& upper_east = found.runs[above_end - 1];
    if (upper_west.first + nx <= lower_east.last + 1) {
        sets.join(below_end - 1, above_begin, {1, above_shift});
    }
    if (upper_east.last - nx >= lower_west.first - 1) {
        sets.join(found.row_begin[below], above_end - 1, {-1, above_shift});
    }
}

void join_ends_of_row(const Runs& found, std::size_t y, int nx, UnwrappedSets& sets) {
    const std::size_t west = found.row_begin[y];
    const std::size_t end = found.row_begin[y + 1];
    if (west == end) return;
    if (found.runs[west].first == 0 && found.runs[end - 1].last == nx - 1) {
        sets.join(end - 1, west, {1, 0});
    }
}

/// The pieces of runs on a bed of nx × ny cells.
DuneComponents pieces_of(const Runs& found, int nx, int ny, bool periodic) {
    UnwrappedSets sets(found.runs.size());
    const auto rows = static_cast<std::size_t>(ny);
    for (std::size_t y = 0; y < rows; ++y) {
        if (periodic) join_ends_of_row(found, y, nx, sets);
        if (y + 1 < rows) {
            join_rows(found, y, y + 1, 0, nx, periodic, sets);
        } else if (periodic) {
            join_rows(found, y, 0, 1, nx, periodic, sets);
        }
    }
    DuneComponents result;
    result.runs.resize(found.runs.size());
    std::vector<std::size_t> piece_of(found.runs.size());
    for (std::size_t run = 0; run < found.runs.size(); ++run) {
        const std::size_t root = sets.root(run).index;
        if (root == run) {
            piece_of[run] = result.pieces.size();
            result.pieces.push_back({0, 0, 0, sets.wraps(root), root});
        }
        piece_of[run] = piece_of[root];
        ++result.pieces[piece_of[run]].runs;
    }
    std::size_t begin = 0;
    for (DuneComponent& piece : result.pieces) {
        piece.first_run = begin;
        begin += piece.runs;
        piece.runs = 0;
    }
    for (std::size_t run = 0; run < found.runs.size(); ++run) {
        DuneComponent& piece = result.pieces[piece_of[run]];
        const Period offset = sets.root(run).offset;
        const RowRun& cells = found.runs[run];
        const int x_shift = offset.x * nx;
        result.runs[piece.first_run + piece.runs++] = {cells.y + offset.y * ny,
                                                       cells.first + x_shift, cells.last + x_shift};
        piece.cells += cells.last - cells.first + 1;
    }
    return result;
}

}  // namespace

DuneComponents dune_components(const Grid& bed, double level, bool periodic) {
    return pieces_of(find_runs(bed, level), bed.nx(), bed.ny(), periodic);
}

ComponentsWithin components_within(const Grid& bed, const DuneComponents& pieces,
                                   std::span<const double> heights, double share, bool periodic) {
    struct OwnedRun {
        int first;
        int last;
        std::size_t piece;
    };
    std::vector<std::vector<OwnedRun>> rows(static_cast<std::size_t>(bed.ny()));
    for (std::size_t piece = 0; piece < pieces.pieces.size(); ++piece) {
        if (!(heights[piece] > 0.0)) continue;
        for (const RowRun& run : pieces.runs_of(pieces.pieces[piece])) {
            const int first = wrap_periodic(run.first, bed.nx());
            rows[static_cast<std::size_t>(wrap_periodic(run.y, bed.ny()))].push_back(
                {first, first + run.last - run.first, piece});
        }
    }
    Runs found;
    std::vector<std::size_t> piece_of_run;
    std::vector<std::uint64_t> words;
    for (int y = 0; y < bed.ny(); ++y) {
        std::vector<OwnedRun>& row = rows[static_cast<std::size_t>(y)];
        found.row_begin.push_back(found.runs.size());
        std::ranges::sort(row, {}, &OwnedRun::first);
        for (const OwnedRun& run : row) {
            const auto cells =
                bed.row(y).subspan(static_cast<std::size_t>(run.first),
                                   static_cast<std::size_t>(run.last - run.first) + 1);
            const double height = heights[run.piece];
            words.assign(words_of(cells.size()), 0);
            for (std::size_t x = 0; x < cells.size(); ++x)
                words[x / 64] |= static_cast<std::uint64_t>(cells[x] / height > share) << (x % 64);
            add_runs(words, cells.size(), y, run.first, found.runs);
            piece_of_run.resize(found.runs.size(), run.piece);
        }
    }
    found.row_begin.push_back(found.runs.size());
    ComponentsWithin result{pieces_of(found, bed.nx(), bed.ny(), periodic), {}};
    for (const DuneComponent& component : result.components.pieces)
        result.pieces.push_back(piece_of_run[component.root]);
    return result;
}

}  // namespace fumon
