#include "figure/ground/ground_contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

constexpr double most_level_count = 1000.0;

}  // namespace

std::optional<GroundContours> ground_contours(const WordOrReal& asked, const Snapshot& snapshot) {
    if (asked.word == "none") return std::nullopt;
    // A ring of cells more, so that lines reach the edges.
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    Grid heights(nx + 2, ny + 2);
    Mask nodata;
    if (!snapshot.nodata.empty()) nodata = Mask(nx + 2, ny + 2, 0);
    const double unit = snapshot.scale.in_metres ? snapshot.scale.height_unit : 1.0;
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (int y = 0; y < ny + 2; ++y) {
        for (int x = 0; x < nx + 2; ++x) {
            const int from_x = std::clamp(x - 1, 0, nx - 1);
            const int from_y = std::clamp(y - 1, 0, ny - 1);
            heights(x, y) = unit * snapshot.bed(from_x, from_y);
            if (!nodata.empty()) {
                nodata(x, y) = snapshot.nodata(from_x, from_y);
                if (nodata(x, y) != 0) continue;
            }
            low = std::min(low, heights(x, y));
            high = std::max(high, heights(x, y));
        }
    }
    GroundContours contours;
    contours.nx = nx;
    contours.ny = ny;
    contours.interval = asked.is_word() ? contour_interval(low, high) : asked.value;
    if (!(high > low)) return std::nullopt;
    const double first = std::ceil(low / contours.interval);
    const double last = std::floor(high / contours.interval);
    if (last - first >= most_level_count) {
        throw InputError(
            fmt::format("contours every {:g} would make {:.0f} levels on this bed; an interval of "
                        "{:g} makes {} or fewer",
                        contours.interval, last - first + 1.0, contour_interval(low, high), 16));
    }
    for (double k = first; k <= last; k += 1.0) {
        auto lines = contour_lines(heights, nodata, k * contours.interval);
        for (ContourLine& line : lines) {
            for (glm::dvec2& point : line.points)
                point = glm::clamp(point - 1.0, glm::dvec2(-0.5), glm::dvec2(nx - 0.5, ny - 0.5));
        }
        std::move(lines.begin(), lines.end(), std::back_inserter(contours.lines));
    }
    return contours;
}

bool is_index_contour(double level, double interval) {
    return std::fmod(std::abs(std::round(level / interval)), 5.0) == 0.0;
}

std::string contour_label(double level, double interval) {
    int decimals = 0;
    for (double scaled = interval; decimals < 9 && std::abs(scaled - std::round(scaled)) >
                                                       1e-6 * interval + 1e-9 * std::abs(scaled);
         scaled *= 10.0)
        ++decimals;
    std::string text = fmt::format("{:.{}f}", level, decimals);
    if (text.find_first_not_of("-0.") == std::string::npos) return "0";
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

}  // namespace fumon
