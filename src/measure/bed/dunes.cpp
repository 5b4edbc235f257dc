#include "measure/bed/dunes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "measure/bed/periodic_wrap.h"
#include "measure/bed/row_pass_vectors.h"

namespace fumon {

namespace {

/// A strip of a dune along the wind, a site wide: how many cells, the sum of their places along the
/// wind, and the last of them.
struct DuneRow {
    double cells = 0.0;
    double along_sum = 0.0;
    double last = 0.0;

    void add(double share, double along) {
        last = cells == 0.0 ? along : std::max(last, along);
        cells += share;
        along_sum += share * along;
    }
};

/// From right to left, looking downwind. A cell between two strips is shared by them.
std::vector<DuneRow> rows_of(std::span<const RowRun> runs, const WindOnGrid& wind) {
    struct WindCoordinates {
        double along;
        double across;
    };
    const auto place_of = [&](int x, int y) {
        const double north = y * wind.cell_aspect;
        return WindCoordinates{x * wind.direction.x + north * wind.direction.y,
                               north * wind.direction.x - x * wind.direction.y};
    };
    double rightmost = std::numeric_limits<double>::infinity();
    for (const RowRun& run : runs) {
        for (const int x : {run.first, run.last})
            rightmost = std::min(rightmost, place_of(x, run.y).across);
    }
    std::vector<DuneRow> rows;
    const auto row = [&](std::size_t index) -> DuneRow& {
        if (index >= rows.size()) rows.resize(index + 1);
        return rows[index];
    };
    const bool in_rows = wind.direction.is_east() && wind.cell_aspect == 1.0;
    for (const RowRun& run : runs) {
        if (in_rows) {  // sums of whole numbers, which are exact in any order
            const double cells = run.last - run.first + 1;
            DuneRow& strip = row(static_cast<std::size_t>(run.y - rightmost));
            strip.last = strip.cells == 0.0 ? run.last : std::max<double>(strip.last, run.last);
            strip.cells += cells;
            strip.along_sum += 0.5 * cells * (static_cast<double>(run.first) + run.last);
            continue;
        }
        for (int x = run.first; x <= run.last; ++x) {
            const WindCoordinates place = place_of(x, run.y);
            const double strip = std::floor(place.across - rightmost);
            const double beyond = place.across - rightmost - strip;
            const auto index = static_cast<std::size_t>(strip);
            row(index).add(1.0 - beyond, place.along);
            if (beyond > 0.0) row(index + 1).add(beyond, place.along);
        }
    }
    return rows;
}

/// With rows symmetric about the middle, b drops out of the normal equations of a and c.
double lag_of_ends(std::span<const DuneRow> rows) {
    if (rows.size() < 3) return std::numeric_limits<double>::quiet_NaN();
    const auto count = static_cast<double>(rows.size());
    const double half_width = 0.5 * (count - 1.0);
    const double mean_square = (count * count - 1.0) / 12.0;
    double moment = 0.0;
    double norm = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = static_cast<double>(i) - half_width;
        const double weight = y * y - mean_square;
        moment += weight * rows[i].along_sum / rows[i].cells;
        norm += weight * weight;
    }
    return moment / norm * half_width * half_width;
}

/// How far the rows of one side reach beyond the middle one.
double horn(std::span<const DuneRow> side, double middle_last) {
    double reach = middle_last;
    for (const DuneRow& row : side) reach = std::max(reach, row.last);
    return reach - middle_last;
}

Dune measured(const Grid& bed, const DuneComponent& piece, std::span<const RowRun> runs,
              const WindOnGrid& wind) {
    Dune dune;
    dune.area = piece.cells;
    double x_sum = 0.0;
    double y_sum = 0.0;
    for (const RowRun& run : runs) {
        const int cells = run.last - run.first + 1;
        const double* row =
            bed.row(wrap_periodic(run.y, bed.ny())).data() + wrap_periodic(run.first, bed.nx());
        for (int x = 0; x < cells; ++x) {
            dune.height = std::max(dune.height, row[x]);
            dune.volume += row[x];
        }
        x_sum += 0.5 * cells * (static_cast<double>(run.first) + run.last);
        y_sum += static_cast<double>(cells) * run.y;
    }
    dune.centre_x = wrap_periodic(x_sum / static_cast<double>(dune.area), bed.nx());
    dune.centre_y = wrap_periodic(y_sum / static_cast<double>(dune.area), bed.ny());
    if (!wind.known) return dune;
    const std::vector<DuneRow> rows = rows_of(runs, wind);
    dune.horn_lag = lag_of_ends(rows);
    const std::size_t middle = rows.size() / 2;
    dune.right_horn = horn(std::span(rows).first(middle), rows[middle].last);
    dune.left_horn = horn(std::span(rows).subspan(middle), rows[middle].last);
    return dune;
}

void set_means(DuneField& field) {
    if (field.dunes.empty()) return;
    double area = 0.0;
    double height = 0.0;
    double volume = 0.0;
    double lag = 0.0;
    int with_lag = 0;
    int downwind = 0;
    for (const Dune& dune : field.dunes) {
        area += static_cast<double>(dune.area);
        height += dune.height;
        volume += dune.volume;
        if (std::isnan(dune.horn_lag)) continue;
        ++with_lag;
        lag += dune.horn_lag;
        if (dune.horn_lag > 0.0) ++downwind;
    }
    const auto count = static_cast<double>(field.dunes.size());
    field.mean_area = area / count;
    field.mean_height = height / count;
    field.mean_volume = volume / count;
    if (with_lag == 0) return;
    field.mean_horn_lag = lag / with_lag;
    field.share_horns_downwind = static_cast<double>(downwind) / with_lag;
}

}  // namespace

double horn_lag(std::span<const RowRun> runs, const WindOnGrid& wind) {
    return wind.known ? lag_of_ends(rows_of(runs, wind)) : std::numeric_limits<double>::quiet_NaN();
}

DuneField separate_dunes(const Grid& bed, bool periodic, const DuneCriteria& criteria,
                         const WindOnGrid& wind) {
    DuneField field;
    if (bed.empty()) return field;
    const double highest = row_passes::highest(bed.values(), 0.0);
    if (!(highest > 0.0)) return field;
    const DuneComponents found = dune_components(bed, criteria.level_share * highest, periodic);
    std::int64_t covered = 0;
    for (const DuneComponent& piece : found.pieces) {
        covered += piece.cells;
        if (piece.wraps || piece.cells < criteria.least_cells) continue;
        field.dunes.push_back(measured(bed, piece, found.runs_of(piece), wind));
    }
    field.covered_share = static_cast<double>(covered) / static_cast<double>(bed.size());
    set_means(field);
    return field;
}

}  // namespace fumon
