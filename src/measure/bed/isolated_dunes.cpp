#include "measure/bed/isolated_dunes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "measure/bed/dune_components.h"
#include "measure/bed/periodic_wrap.h"

namespace fumon {

namespace {

constexpr double foot_share = 0.05;
constexpr double least_height_share = 0.2;
constexpr double top_share = 0.6;
constexpr double outline_share = 0.3;
constexpr std::int64_t least_cells = 20;
constexpr std::int64_t least_top_cells = 5;

/// A piece that may stand alone.
struct Candidate {
    double height = 0.0;
    double width = 0.0;  ///< columns' breadths
    int tops = 0;
    int outlines = 0;
    double horn_lag = std::numeric_limits<double>::quiet_NaN();
};

double width_of(std::span<const RowRun> runs, const WindOnGrid& wind) {
    double right = std::numeric_limits<double>::infinity();
    double left = -right;
    for (const RowRun& run : runs) {
        for (const int x : {run.first, run.last}) {
            const double across =
                run.y * wind.cell_aspect * wind.direction.x - x * wind.direction.y;
            right = std::min(right, across);
            left = std::max(left, across);
        }
    }
    return left - right + 1.0;
}

double median(std::vector<double>& values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

IsolatedDunes isolated_dunes(const Grid& sand, bool periodic, const WindOnGrid& wind) {
    IsolatedDunes found;
    if (sand.empty()) return found;
    const double thickest = *std::max_element(sand.values().begin(), sand.values().end());
    if (!(thickest > 0.0)) return found;
    const DuneComponents feet = dune_components(sand, foot_share * thickest, periodic);
    std::vector<Candidate> candidates;
    Grid share(sand.nx(), sand.ny());  // of the piece's own height
    Grid owner(sand.nx(), sand.ny(), -1.0);
    for (const DuneComponent& piece : feet.pieces) {
        if (piece.wraps || piece.cells < least_cells) continue;
        const auto runs = feet.runs_of(piece);
        Candidate candidate;
        const auto each_cell = [&](const auto& visit) {
            for (const RowRun& run : runs) {
                for (int x = run.first; x <= run.last; ++x)
                    visit(wrap_periodic(x, sand.nx()), wrap_periodic(run.y, sand.ny()));
            }
        };
        each_cell([&](int x, int y) { candidate.height = std::max(candidate.height, sand(x, y)); });
        if (candidate.height < least_height_share * thickest) continue;
        candidate.width = width_of(runs, wind);
        each_cell([&](int x, int y) {
            share(x, y) = sand(x, y) / candidate.height;
            owner(x, y) = static_cast<double>(candidates.size());
        });
        candidates.push_back(candidate);
    }
    const auto candidate_of = [&](const RowRun& run) -> Candidate& {
        const double number =
            owner(wrap_periodic(run.first, sand.nx()), wrap_periodic(run.y, sand.ny()));
        return candidates[static_cast<std::size_t>(number)];
    };
    const DuneComponents tops = dune_components(share, top_share, periodic);
    for (const DuneComponent& top : tops.pieces) {
        if (top.cells >= least_top_cells) ++candidate_of(tops.runs_of(top).front()).tops;
    }
    const DuneComponents outlines = dune_components(share, outline_share, periodic);
    for (const DuneComponent& outline : outlines.pieces) {
        if (outline.cells < least_cells) continue;
        Candidate& candidate = candidate_of(outlines.runs_of(outline).front());
        ++candidate.outlines;
        candidate.horn_lag = horn_lag(outlines.runs_of(outline), wind);
    }
    std::vector<double> proportions;
    int with_lag = 0;
    int downwind = 0;
    for (const Candidate& candidate : candidates) {
        if (candidate.tops != 1 || candidate.outlines != 1) continue;
        ++found.count;
        proportions.push_back(candidate.height / candidate.width);
        if (std::isnan(candidate.horn_lag)) continue;
        ++with_lag;
        if (candidate.horn_lag > 0.0) ++downwind;
    }
    found.height_to_width = median(proportions);
    if (with_lag > 0) found.share_horns_downwind = static_cast<double>(downwind) / with_lag;
    return found;
}

}  // namespace fumon
