#include "measure/water/thalweg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/elementary_angle.h"
#include "numerics/gaussian_line.h"
#include "numerics/peak_offset.h"

namespace fumon {

namespace {

constexpr double smoothing_along = 2.0;  // cells

/// The depth in a window's columns, row by row.
class WindowedDepth {
  public:
    WindowedDepth(const Grid& depth, ChannelWindow window)
        : depth_(depth), first_(window.first), width_(window.last - window.first + 1) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] double at(int column, int y) const {
        const int nx = depth_.nx();
        return depth_((((first_ + column) % nx) + nx) % nx, y);
    }

  private:
    const Grid& depth_;
    int first_;
    int width_;
};

/// From each column of a row, which step (−1, 0, 1) leads to the best way through the rows before.
struct BestPaths {
    std::vector<double> sums;             ///< of the depth, of the ways that end in the last row
    std::vector<std::vector<int>> steps;  ///< row by row
};

BestPaths best_paths(const WindowedDepth& depth, int ny) {
    const int width = depth.width();
    const auto columns = static_cast<std::size_t>(width);
    BestPaths paths{std::vector<double>(columns, 0.0), {}};
    std::vector<double> before(columns);
    for (int y = 0; y < ny; ++y) {
        std::swap(before, paths.sums);
        std::vector<int> steps(columns, 0);
        for (int column = 0; column < width; ++column) {
            const auto here = static_cast<std::size_t>(column);
            double best = y == 0 ? 0.0 : before[here];
            for (const int step : {-1, 1}) {
                const int from = column + step;
                if (y == 0 || from < 0 || from >= width) continue;
                if (before[static_cast<std::size_t>(from)] > best) {
                    best = before[static_cast<std::size_t>(from)];
                    steps[here] = step;
                }
            }
            paths.sums[here] = best + depth.at(column, y);
        }
        paths.steps.push_back(std::move(steps));
    }
    return paths;
}

std::vector<int> best_path(const WindowedDepth& depth, int ny) {
    const BestPaths paths = best_paths(depth, ny);
    std::vector<int> columns(static_cast<std::size_t>(ny));
    auto column = static_cast<int>(std::ranges::max_element(paths.sums) - paths.sums.begin());
    for (std::size_t y = columns.size(); y-- > 0;) {
        columns[y] = column;
        column += paths.steps[y][static_cast<std::size_t>(column)];
    }
    return columns;
}

/// Smoothed by a Gaussian; past its ends the way goes on as it came, turned by half a turn.
void smooth_path(std::vector<double>& path) {
    constexpr std::size_t reach = 8;  // sites, of the Gaussian
    const std::size_t beyond = std::min(reach, path.size() - 1);
    std::vector<double> longer;
    for (std::size_t i = beyond; i > 0; --i) longer.push_back(2.0 * path.front() - path[i]);
    longer.insert(longer.end(), path.begin(), path.end());
    for (std::size_t i = 1; i <= beyond; ++i)
        longer.push_back(2.0 * path.back() - path[path.size() - 1 - i]);
    longer = gaussian_smoothed(longer, smoothing_along, false);
    std::copy_n(longer.begin() + static_cast<std::ptrdiff_t>(beyond), path.size(), path.begin());
}

/// Where a parabola through a site and its neighbours is highest, from −1/2 to 1/2.
double top_offset(double before, double here, double after) {
    return std::clamp(peak_offset(before, here, after), -0.5, 0.5);
}

}  // namespace

std::vector<ChannelWindow> channel_windows(std::span<const int> sites, int nx, bool periodic) {
    std::vector<ChannelWindow> windows;
    const std::size_t count = sites.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool first = i == 0;
        const bool last = i + 1 == count;
        const int before = first ? sites[count - 1] - nx : sites[i - 1];
        const int after = last ? sites[0] + nx : sites[i + 1];
        ChannelWindow window{sites[i] - (sites[i] - before - 1) / 2,
                             sites[i] + (after - sites[i] - 1) / 2};
        if (!periodic && first) window.first = 0;
        if (!periodic && last) window.last = nx - 1;
        windows.push_back(window);
    }
    return windows;
}

Grid smoothed_depth(const Grid& depth, bool periodic) {
    Grid smooth(depth.nx(), depth.ny());
    for (int y = 0; y < depth.ny(); ++y)
        std::ranges::copy(gaussian_smoothed(depth.row(y), smoothing_along, periodic),
                          smooth.row(y).begin());
    std::vector<double> column(static_cast<std::size_t>(depth.ny()));
    for (int x = 0; x < depth.nx(); ++x) {
        for (int y = 0; y < depth.ny(); ++y) column[static_cast<std::size_t>(y)] = smooth(x, y);
        column = gaussian_smoothed(column, smoothing_along, periodic);
        for (int y = 0; y < depth.ny(); ++y) smooth(x, y) = column[static_cast<std::size_t>(y)];
    }
    return smooth;
}

std::vector<double> thalweg(const Grid& smooth_depth, ChannelWindow window, bool periodic) {
    const WindowedDepth depth(smooth_depth, window);
    std::vector<double> path;
    int y = 0;
    for (const int column : best_path(depth, smooth_depth.ny())) {
        const int x = window.first + column;
        const bool has_sides = periodic || (x > 0 && x < smooth_depth.nx() - 1);
        path.push_back(has_sides ? x + top_offset(depth.at(column - 1, y), depth.at(column, y),
                                                  depth.at(column + 1, y))
                                 : x);
        ++y;
    }
    smooth_path(path);
    return path;
}

double mean_sinuosity(const Grid& depth, std::span<const int> sites, double dx, double dy,
                      bool periodic) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (sites.empty() || depth.ny() < 3) return none;
    const Grid smooth = smoothed_depth(depth, periodic);
    double sum = 0.0;
    for (const ChannelWindow& window : channel_windows(sites, depth.nx(), periodic)) {
        const std::vector<double> path = thalweg(smooth, window, periodic);
        double length = 0.0;
        for (std::size_t y = 1; y < path.size(); ++y)
            length += elementary::hypot((path[y] - path[y - 1]) * dx, dy);
        sum += length / elementary::hypot((path.back() - path.front()) * dx,
                                          dy * static_cast<double>(path.size() - 1));
    }
    return sum / static_cast<double>(sites.size());
}

}  // namespace fumon
