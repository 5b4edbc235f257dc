#include "measure/bed/isolated_dunes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
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
    double volume = 0.0;
    double moment = 0.0;  ///< of the volume along the wind
    double width = 0.0;   ///< columns' breadths
    double length = 0.0;
    int tops = 0;
    int outlines = 0;
    double horn_lag = std::numeric_limits<double>::quiet_NaN();
};

/// Columns' breadths between the outermost cells along a direction, these included.
double extent_along(std::span<const RowRun> runs, const HorizontalDirection& direction,
                    double cell_aspect) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const RowRun& run : runs) {
        for (const int x : {run.first, run.last}) {
            const double place = x * direction.x + run.y * cell_aspect * direction.y;
            least = std::min(least, place);
            most = std::max(most, place);
        }
    }
    return most - least + 1.0;
}

/// The cells of a run, which lies within a row of the bed but for whole periods.
std::span<const double> cells_of(const Grid& bed, const RowRun& run) {
    const auto first = static_cast<std::size_t>(wrap_periodic(run.first, bed.nx()));
    return bed.row(wrap_periodic(run.y, bed.ny()))
        .subspan(first, static_cast<std::size_t>(run.last - run.first) + 1);
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
    std::vector<std::size_t> candidate_of(feet.pieces.size());
    std::vector<double> heights(feet.pieces.size());
    for (std::size_t k = 0; k < feet.pieces.size(); ++k) {
        const DuneComponent& piece = feet.pieces[k];
        if (piece.wraps || piece.cells < least_cells) continue;
        const auto runs = feet.runs_of(piece);
        Candidate candidate;
        for (const RowRun& run : runs) {
            const auto cells = cells_of(sand, run);
            candidate.height =
                std::max(candidate.height, *std::max_element(cells.begin(), cells.end()));
            double x = run.first;
            for (const double height : cells) {
                candidate.volume += height;
                candidate.moment +=
                    height * (x * wind.direction.x + run.y * wind.cell_aspect * wind.direction.y);
                x += 1.0;
            }
        }
        if (candidate.height < least_height_share * thickest) continue;
        const HorizontalDirection& downwind = wind.direction;
        candidate.width = extent_along(runs, {-downwind.y, downwind.x}, wind.cell_aspect);
        candidate.length = extent_along(runs, downwind, wind.cell_aspect);
        heights[k] = candidate.height;
        candidate_of[k] = candidates.size();
        candidates.push_back(candidate);
    }
    const auto tops = components_within(sand, feet, heights, top_share, periodic);
    for (std::size_t k = 0; k < tops.pieces.size(); ++k) {
        if (tops.components.pieces[k].cells >= least_top_cells)
            ++candidates[candidate_of[tops.pieces[k]]].tops;
    }
    const auto within = components_within(sand, feet, heights, outline_share, periodic);
    const DuneComponents& outlines = within.components;
    for (std::size_t k = 0; k < within.pieces.size(); ++k) {
        const DuneComponent& outline = outlines.pieces[k];
        if (outline.cells < least_cells) continue;
        Candidate& candidate = candidates[candidate_of[within.pieces[k]]];
        ++candidate.outlines;
        candidate.horn_lag = horn_lag(outlines.runs_of(outline), wind);
    }
    std::vector<double> proportions;
    std::vector<double> lone_heights;
    std::vector<double> widths;
    std::vector<double> lengths;
    std::vector<double> volumes;
    int with_lag = 0;
    int downwind = 0;
    for (const Candidate& candidate : candidates) {
        if (candidate.tops != 1 || candidate.outlines != 1) continue;
        ++found.count;
        proportions.push_back(candidate.height / candidate.width);
        lone_heights.push_back(candidate.height);
        widths.push_back(candidate.width);
        lengths.push_back(candidate.length);
        volumes.push_back(candidate.volume);
        found.place = candidate.moment / candidate.volume;
        if (std::isnan(candidate.horn_lag)) continue;
        ++with_lag;
        if (candidate.horn_lag > 0.0) ++downwind;
    }
    found.height_to_width = median(proportions);
    if (found.count != 1) found.place = std::numeric_limits<double>::quiet_NaN();
    found.height = median(lone_heights);
    found.width = median(widths);
    found.length = median(lengths);
    if (volumes.size() > 1) {
        std::ranges::partial_sort(volumes, volumes.begin() + 2, std::ranges::greater());
        found.volume_ratio = volumes[1] / volumes[0];
    }
    if (with_lag > 0) found.share_horns_downwind = static_cast<double>(downwind) / with_lag;
    return found;
}

}  // namespace fumon
