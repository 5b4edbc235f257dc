#include "measure/bed/crest_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/elementary_angle.h"
#include "base/grid.h"
#include "measure/bed/row_batch.h"
#include "measure/bed/row_crests.h"

namespace fumon {

namespace {

std::size_t site_or_end(int x, int count, bool periodic) {
    if (periodic) return static_cast<std::size_t>((x + count) % count);
    return static_cast<std::size_t>(std::clamp(x, 0, count - 1));
}

/// The means of 2·radius + 1 sites along rows, twice.
void means_along_x(const Grid& from, Grid& to, bool periodic, int radius) {
    constexpr int rows = RowBatch::rows;
    RowBatch batch(static_cast<std::size_t>(from.nx()));
    for (int first = 0; first < from.ny(); first += rows) {
        const int count = std::min(rows, from.ny() - first);
        batch.take(from, first, count);
        for (int pass = 0; pass < 2; ++pass) batch.smooth(periodic, radius);
        batch.put(to, first, count);
    }
}

void mean_along_y(const Grid& from, Grid& to, bool periodic, int radius) {
    const auto nx = static_cast<std::size_t>(from.nx());
    const int ny = from.ny();
    const double scale = 1.0 / (2 * radius + 1);
    std::vector<double> sum(nx);
    const auto row = [&](int y) {
        return from.row(static_cast<int>(site_or_end(y, ny, periodic)));
    };
    for (int y = -radius; y <= radius; ++y) {
        const auto added = row(y);
        for (std::size_t x = 0; x < nx; ++x) sum[x] += added[x];
    }
    for (int y = 0; y < ny; ++y) {
        const auto mean = to.row(y);
        const auto in = row(y + radius + 1);
        const auto out = row(y - radius);
        for (std::size_t x = 0; x < nx; ++x) {
            mean[x] = sum[x] * scale;
            sum[x] += in[x] - out[x];
        }
    }
}

/// A bed smoothed by a triangular kernel in x and y: twice the mean of 2·radius + 1 sites each way.
/// Past the edges of a bed that is not periodic its outermost cells go on. The radius is cut to
/// what fits into the bed; 0 leaves it as it is.
Grid smoothed_bed(const Grid& bed, bool periodic, int radius) {
    const int along_x = std::clamp(radius, 0, (bed.nx() - 1) / 2);
    const int along_y = std::clamp(radius, 0, (bed.ny() - 1) / 2);
    Grid result(bed.nx(), bed.ny());
    if (along_x > 0) {
        means_along_x(bed, result, periodic, along_x);
    } else {
        result = bed;
    }
    if (along_y == 0) return result;
    Grid work(bed.nx(), bed.ny());
    mean_along_y(result, work, periodic, along_y);
    mean_along_y(work, result, periodic, along_y);
    return result;
}

constexpr double smoothing_share = 1.0 / 12.0;  // all of these are shares of a wavelength
constexpr double reach_share = 1.0 / 2.0;
constexpr double least_length_share = 1.0 / 4.0;
constexpr double edge_share = 1.0 / 2.0;
constexpr double prominence = 0.5;  // of a standard deviation
constexpr double shortest_wavelength = 3.0;
constexpr int least_rows = 4;
constexpr int none = -1;

bool is_measurable(const Grid& bed, double wavelength) {
    return wavelength >= shortest_wavelength && wavelength <= bed.nx() && bed.ny() >= least_rows;
}

/// The crests of all rows, row after row, and the links between them.
struct CrestGraph {
    std::vector<double> x;
    std::vector<int> y;
    std::vector<int> north;  ///< the crest it is linked with in the next row, or none
    std::vector<int> south;
    std::vector<int> row_begin;  ///< ny + 1 entries
};

double deviation_of_rows(const Grid& bed, bool periodic) {
    constexpr int rows = RowBatch::rows;
    RowBatch batch(static_cast<std::size_t>(bed.nx()));
    double squares = 0.0;
    for (int first = 0; first < bed.ny(); first += rows) {
        const int count = std::min(rows, bed.ny() - first);
        batch.take(bed, first, count);
        batch.detrend(periodic);
        for (int row = 0; row < count; ++row)
            squares += batch.squares()[static_cast<std::size_t>(row)];
    }
    return std::sqrt(squares / static_cast<double>(bed.size()));
}

/// From `a` to `b` along x, the short way round a periodic bed.
double step_along_x(double a, double b, double period) {
    const double step = b - a;
    if (!(period > 0.0)) return step;
    const double periods = step / period;
    if (std::abs(periods) < 0.5) return step;  // mostly: without a call
    return step - period * std::round(periods);
}

/// A row of crests, and the first of them that is not left of the place last asked for: the next
/// place is near it.
class CrestRow {
  public:
    CrestRow(const CrestGraph& graph, std::size_t row)
        : x_(graph.x.data()), begin_(graph.row_begin[row]), end_(graph.row_begin[row + 1]) {
        after_ = begin_;
    }
    [[nodiscard]] int begin() const { return begin_; }
    [[nodiscard]] int end() const { return end_; }

    /// The crest nearest to x; of two as near, the first in the row.
    int nearest(double x, double period) {
        if (begin_ == end_) return none;
        while (after_ > begin_ && x_[after_ - 1] >= x) --after_;
        while (after_ < end_ && x_[after_] < x) ++after_;
        int found = none;
        double distance = 0.0;
        const auto ask = [&](int candidate) {
            const double here = std::abs(step_along_x(x, x_[candidate], period));
            if (found != none && here >= distance) return;
            found = candidate;
            distance = here;
        };
        const bool at_end = after_ - 1 <= begin_ || after_ + 1 >= end_;
        if (at_end) ask(begin_);
        ask(std::max(begin_, after_ - 1));
        ask(std::min(after_, end_ - 1));
        if (at_end) ask(end_ - 1);
        return found;
    }

  private:
    const double* x_;
    int begin_;
    int end_;
    int after_;
};

void link_rows(CrestGraph& graph, std::size_t row, std::size_t next, double reach, double period) {
    CrestRow here(graph, row);
    CrestRow there(graph, next);
    for (int crest = here.begin(); crest < here.end(); ++crest) {
        const double x = graph.x[static_cast<std::size_t>(crest)];
        const int other = there.nearest(x, period);
        if (other == none) return;
        const double other_x = graph.x[static_cast<std::size_t>(other)];
        if (std::abs(step_along_x(x, other_x, period)) > reach) continue;
        if (here.nearest(other_x, period) != crest) continue;
        graph.north[static_cast<std::size_t>(crest)] = other;
        graph.south[static_cast<std::size_t>(other)] = crest;
    }
}

CrestGraph linked_crests(const Grid& smoothed, bool periodic, double wavelength) {
    const double fall = prominence * deviation_of_rows(smoothed, periodic);
    CrestGraph graph;
    std::vector<double> crests;
    graph.row_begin.push_back(0);
    for (int y = 0; y < smoothed.ny(); ++y) {
        find_row_crests(smoothed.row(y), periodic, fall, crests);
        graph.x.insert(graph.x.end(), crests.begin(), crests.end());
        graph.y.insert(graph.y.end(), crests.size(), y);
        graph.row_begin.push_back(static_cast<int>(graph.x.size()));
    }
    graph.north.assign(graph.x.size(), none);
    graph.south.assign(graph.x.size(), none);
    const auto rows = static_cast<std::size_t>(smoothed.ny());
    const double reach = std::max(1.5, reach_share * wavelength);
    const double period = periodic ? smoothed.nx() : 0.0;
    for (std::size_t y = 0; y + 1 < rows; ++y) link_rows(graph, y, y + 1, reach, period);
    if (periodic) link_rows(graph, rows - 1, 0, reach, period);
    return graph;
}

CrestLine line_from(const CrestGraph& graph, int start, double period, std::vector<bool>& taken) {
    CrestLine line;
    line.first_y = graph.y[static_cast<std::size_t>(start)];
    int crest = start;
    while (crest != none && !taken[static_cast<std::size_t>(crest)]) {
        const auto at = static_cast<std::size_t>(crest);
        taken[at] = true;
        const double x = graph.x[at];
        line.x.push_back(line.x.empty() ? x
                                        : line.x.back() + step_along_x(line.x.back(), x, period));
        crest = graph.north[at];
    }
    line.closed = crest != none;
    return line;
}

double length_of(const CrestLine& line, double period) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.x.size(); ++i) {
        length += elementary::hypot(1.0, line.x[i] - line.x[i - 1]);
    }
    if (line.closed) {
        length += elementary::hypot(1.0, step_along_x(line.x.back(), line.x.front(), period));
    }
    return length;
}

bool lies_inside(const Grid& bed, double x, int y, double margin) {
    return x >= margin && x <= bed.nx() - 1 - margin && y >= margin && y <= bed.ny() - 1 - margin;
}

}  // namespace

std::vector<CrestLine> crest_lines(const Grid& bed, bool periodic, double wavelength) {
    std::vector<CrestLine> lines;
    if (!is_measurable(bed, wavelength)) return lines;
    const auto radius = static_cast<int>(std::lround(smoothing_share * wavelength));
    const CrestGraph graph =
        linked_crests(smoothed_bed(bed, periodic, radius), periodic, wavelength);
    const double period = periodic ? bed.nx() : 0.0;
    std::vector<bool> taken(graph.x.size());
    const auto take = [&](int start) {
        CrestLine line = line_from(graph, start, period, taken);
        if (static_cast<double>(line.x.size()) >= least_length_share * wavelength) {
            lines.push_back(std::move(line));
        }
    };
    const auto count = static_cast<int>(graph.x.size());
    for (int crest = 0; crest < count; ++crest) {
        if (graph.south[static_cast<std::size_t>(crest)] == none) take(crest);
    }
    for (int crest = 0; crest < count; ++crest) {
        if (!taken[static_cast<std::size_t>(crest)]) take(crest);
    }
    return lines;
}

CrestDefects crest_defects(const Grid& bed, bool periodic, double wavelength) {
    CrestDefects result;
    if (!is_measurable(bed, wavelength)) return result;
    const double margin = edge_share * wavelength;
    for (const CrestLine& line : crest_lines(bed, periodic, wavelength)) {
        ++result.lines;
        result.crest_length += length_of(line, periodic ? bed.nx() : 0.0);
        if (line.closed) continue;
        const int last_y = line.first_y + static_cast<int>(line.x.size()) - 1;
        if (periodic || lies_inside(bed, line.x.front(), line.first_y, margin)) ++result.ends;
        if (periodic || lies_inside(bed, line.x.back(), last_y, margin)) ++result.ends;
    }
    const auto ends = static_cast<double>(result.ends);
    if (result.crest_length > 0.0) result.defect_density = 0.5 * ends / result.crest_length;
    if (result.lines > 0) {
        result.ends_per_square_wavelength =
            ends * wavelength * wavelength / static_cast<double>(bed.size());
    }
    return result;
}

}  // namespace fumon
