#include "render/view/shown_snapshot.h"

#include <algorithm>
#include <cstddef>

namespace fumon {

namespace {

constexpr int longest_drawn = 8192;        // cells on a side
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
    return shown;
}

/// Calls body(sum over the cells inside, their count, place) for every k × k cells; those over the
/// east and north edge are fewer.
template <class Body>
void for_each_group(const Grid& fine, const Mask& nodata, int k, const Grid& coarse, Body body) {
    for (int y = 0; y < coarse.ny(); ++y) {
        for (int x = 0; x < coarse.nx(); ++x) {
            double sum = 0.0;
            int count = 0;
            for (int v = y * k; v < std::min((y + 1) * k, fine.ny()); ++v) {
                for (int u = x * k; u < std::min((x + 1) * k, fine.nx()); ++u) {
                    if (!nodata.empty() && nodata(u, v) != 0) continue;
                    sum += fine(u, v);
                    ++count;
                }
            }
            body(x, y, sum, count);
        }
    }
}

Snapshot coarser(const Snapshot& snapshot, int k) {
    Snapshot shown = snapshot;
    const auto groups = [k](int cells) { return (cells + k - 1) / k; };
    const auto averaged = [&](const Grid& fine) {
        Grid coarse(groups(fine.nx()), groups(fine.ny()));
        for_each_group(fine, snapshot.nodata, k, coarse, [&](int x, int y, double sum, int count) {
            coarse(x, y) = count > 0 ? sum / count : 0.0;
        });
        return coarse;
    };
    shown.bed = averaged(snapshot.bed);
    for (SnapshotField& field : shown.fields) field.values = averaged(field.values);
    if (!snapshot.nodata.empty()) {
        shown.nodata = Mask(shown.bed.nx(), shown.bed.ny());
        for_each_group(
            snapshot.bed, snapshot.nodata, k, shown.bed,
            [&](int x, int y, double, int count) { shown.nodata(x, y) = count == 0 ? 1 : 0; });
    }
    shown.scale.dx *= k;
    shown.scale.dy *= k;
    return shown;
}

}  // namespace

std::optional<Snapshot> shown_snapshot(const Snapshot& snapshot, const LookSettings& look) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    if (ny == 1 && nx > 1) return as_strip(snapshot, look);
    const int k = (std::max(nx, ny) + longest_drawn - 1) / longest_drawn;
    if (k > 1) return coarser(snapshot, k);
    return std::nullopt;
}

}  // namespace fumon
