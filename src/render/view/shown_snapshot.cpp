#include "render/view/shown_snapshot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/snapshots/ground_range.h"
#include "render/land/sea_water.h"
#include "render/view/ground_choice.h"
#include "render/view/surrounding_plain.h"

namespace fumon {

namespace {

constexpr int longest_drawn = 8192;     // cells on a side
constexpr int longest_in_plain = 1024;  // of a bed in a plain, whose maps are eight times its size
constexpr int least_drawn = 1024;       // that small pictures keep
constexpr std::int64_t usual_strip = 900;  // sites: a dozen wavelengths of the published profiles
constexpr int strip_proportion = 4;        // length to depth
constexpr int strip_proportion_under_air = 3;

bool shows_air(const Snapshot& snapshot, const LookSettings& look) {
    return snapshot.section && look.air && look.mode == ViewMode::scenic &&
           snapshot.bed.nx() <= longest_drawn;
}

Grid strip_of(const Grid& row, int start, int sites, int proportion) {
    const int depth = std::max(1, sites / proportion);
    Grid strip(sites, depth);
    for (int y = 0; y < depth; ++y) {
        for (int x = 0; x < sites; ++x) strip(x, y) = row((start + x) % row.nx(), 0);
    }
    return strip;
}

Snapshot as_strip(const Snapshot& snapshot, const LookSettings& look) {
    const std::int64_t nx = snapshot.bed.nx();
    const std::int64_t wanted = look.profile_sites > 0 ? look.profile_sites : usual_strip;
    const bool air = shows_air(snapshot, look);
    const int sites =
        static_cast<int>(air ? nx : std::min({wanted, nx, std::int64_t{longest_drawn}}));
    const int start = air ? 0 : static_cast<int>(look.profile_start % nx);
    const int proportion = air ? strip_proportion_under_air : strip_proportion;
    Snapshot shown = snapshot;
    if (!air) shown.section.reset();
    shown.bed = strip_of(snapshot.bed, start, sites, proportion);
    for (SnapshotField& field : shown.fields)
        field.values = strip_of(field.values, start, sites, proportion);
    if (!snapshot.nodata.empty()) {
        shown.nodata = Mask(sites, shown.bed.ny());
        for (int y = 0; y < shown.nodata.ny(); ++y) {
            for (int x = 0; x < sites; ++x)
                shown.nodata(x, y) = snapshot.nodata((start + x) % snapshot.bed.nx(), 0);
        }
    }
    if (snapshot.rain) {
        shown.rain = [rain = snapshot.rain, start, sites, proportion](double from, double until) {
            const Grid fallen = rain(from, until);
            return fallen.size() == 1 ? fallen : strip_of(fallen, start, sites, proportion);
        };
    }
    return shown;
}

/// The means of every k × k cells, those without data or value (NaN) left out; at the east and
/// north edge they are fewer. 0 where there is none, NaN where all with data have no value.
Grid averaged(const Grid& fine, const Mask& nodata, int k) {
    const auto groups = [k](int cells) { return (cells + k - 1) / k; };
    Grid coarse(groups(fine.nx()), groups(fine.ny()));
    std::vector<int> counts;
    std::vector<int> without_value;
    for (int y = 0; y < coarse.ny(); ++y) {
        const auto sums = coarse.row(y);
        counts.assign(sums.size(), 0);
        without_value.assign(sums.size(), 0);
        for (int v = y * k; v < std::min((y + 1) * k, fine.ny()); ++v) {
            const auto heights = fine.row(v);
            std::size_t u = 0;
            for (std::size_t x = 0; x < sums.size(); ++x) {
                for (const std::size_t end =
                         std::min(u + static_cast<std::size_t>(k), heights.size());
                     u < end; ++u) {
                    if (!nodata.empty() && nodata.row(v)[u] != 0) continue;
                    if (std::isnan(heights[u])) {
                        ++without_value[x];
                        continue;
                    }
                    sums[x] += heights[u];
                    ++counts[x];
                }
            }
        }
        for (std::size_t x = 0; x < sums.size(); ++x) {
            if (counts[x] > 0) {
                sums[x] /= counts[x];
            } else if (without_value[x] > 0) {
                sums[x] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
    return coarse;
}

/// 1 where k × k cells are all without data.
Mask all_missing(const Mask& nodata, int nx, int ny, int k) {
    Mask missing(nx, ny, 1);
    for (int v = 0; v < nodata.ny(); ++v) {
        for (int u = 0; u < nodata.nx(); ++u)
            if (nodata(u, v) == 0) missing(u / k, v / k) = 0;
    }
    return missing;
}

Snapshot coarser(const Snapshot& snapshot, int k) {
    Snapshot shown;
    shown.step = snapshot.step;
    shown.time = snapshot.time;
    shown.time_unit = snapshot.time_unit;
    shown.bed = averaged(snapshot.bed, snapshot.nodata, k);
    if (!snapshot.nodata.empty())
        shown.nodata = all_missing(snapshot.nodata, shown.bed.nx(), shown.bed.ny(), k);
    shown.scale = snapshot.scale;
    shown.scale.dx *= k;
    shown.scale.dy *= k;
    shown.highest_expected = snapshot.highest_expected;
    shown.periodic = snapshot.periodic;
    for (const SnapshotField& field : snapshot.fields) {
        shown.fields.push_back(
            {field.name, field.long_name, field.unit, averaged(field.values, snapshot.nodata, k)});
    }
    shown.numbers = snapshot.numbers;
    shown.section = snapshot.section;
    shown.landform = snapshot.landform;
    shown.winds = snapshot.winds;
    shown.grass_height = snapshot.grass_height;
    shown.shrub_height = snapshot.shrub_height;
    if (snapshot.rain) {
        shown.rain = [rain = snapshot.rain, nodata = snapshot.nodata, k](double from,
                                                                         double until) {
            Grid fallen = rain(from, until);
            return fallen.size() == 1 ? fallen : averaged(fallen, nodata, k);
        };
    }
    return shown;
}

/// (1 4 6 4 1)/16 of a line's numbers, those at its ends repeated.
void smooth_line(const std::vector<double>& line, std::vector<double>& smoothed) {
    const auto last = static_cast<std::ptrdiff_t>(line.size()) - 1;
    const auto at = [&](std::ptrdiff_t i) {
        return line[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
    };
    for (std::ptrdiff_t i = 0; i <= last; ++i)
        smoothed[static_cast<std::size_t>(i)] =
            (at(i - 2) + at(i + 2) + 4.0 * (at(i - 1) + at(i + 1)) + 6.0 * at(i)) / 16.0;
}

/// Twice over rows and columns, as a Gaussian of √2 cells.
Grid smoothed_heights(Grid heights) {
    constexpr int passes = 2;
    const auto nx = static_cast<std::size_t>(heights.nx());
    const auto ny = static_cast<std::size_t>(heights.ny());
    std::vector<double> line;
    std::vector<double> result;
    for (int pass = 0; pass < passes; ++pass) {
        result.resize(nx);
        for (int y = 0; y < heights.ny(); ++y) {
            const auto row = heights.row(y);
            line.assign(row.begin(), row.end());
            smooth_line(line, result);
            std::ranges::copy(result, row.begin());
        }
        line.resize(ny);
        result.resize(ny);
        for (int x = 0; x < heights.nx(); ++x) {
            for (int y = 0; y < heights.ny(); ++y)
                line[static_cast<std::size_t>(y)] = heights(x, y);
            smooth_line(line, result);
            for (int y = 0; y < heights.ny(); ++y)
                heights(x, y) = result[static_cast<std::size_t>(y)];
        }
    }
    return heights;
}

/// How many cells along each side become one.
int cells_averaged(const Snapshot& snapshot, const View& view) {
    const int longer = std::max(snapshot.bed.nx(), snapshot.bed.ny());
    const bool endless = is_endless(view, snapshot);
    const int longest = endless && is_bounded(snapshot) ? longest_in_plain : longest_drawn;
    const int needed = (longer + longest - 1) / longest;
    const CameraSettings& camera = view.camera;
    const bool whole_block_seen = !endless && camera.framing == Framing::block &&
                                  camera.distance.is_word() && camera.at.empty() &&
                                  camera.look_at.empty();
    if (!whole_block_seen) return needed;
    const auto pixels = static_cast<int>(std::max(view.image.width, view.image.height));
    return std::max(needed, longer / std::max(pixels, least_drawn));
}

std::optional<Snapshot> reshaped(const Snapshot& snapshot, const View& view) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    if (ny == 1 && nx > 1) return as_strip(snapshot, view.look);
    const int k = cells_averaged(snapshot, view);
    if (k > 1) return coarser(snapshot, k);
    if (!draws_poured_sand(snapshot, view.look)) return std::nullopt;
    Snapshot shown = snapshot;
    shown.bed = smoothed_heights(std::move(shown.bed));
    return shown;
}

}  // namespace

bool draws_poured_sand(const Snapshot& snapshot, const LookSettings& look) {
    return snapshot.landform == Landform::pile && look.pile == PileSurface::smooth &&
           look.mode == ViewMode::scenic && look.colour_by == Colouring::natural;
}

const Snapshot& drawable(const Snapshot& snapshot) {
    if (const std::string fault = beyond_ground(snapshot); !fault.empty())
        throw Error("no picture can be made: " + fault);
    return snapshot;
}

std::optional<Snapshot> shown_snapshot(const Snapshot& snapshot, const View& view) {
    std::optional<Snapshot> shown = reshaped(snapshot, view);
    if (view.look.sea_level.is_word() || snapshot.periodic) return shown;
    if (!shown) shown = snapshot;
    add_sea(*shown, view.look.sea_level.value);
    return shown;
}

}  // namespace fumon
