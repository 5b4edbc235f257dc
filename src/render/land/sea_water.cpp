#include "render/land/sea_water.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/grid.h"

namespace fumon {

namespace {

constexpr std::array<std::pair<int, int>, 4> beside{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// The field of a name, which is made if there is none.
Grid& field_to_fill(Snapshot& snapshot, std::string_view name, std::string_view unit) {
    for (SnapshotField& field : snapshot.fields)
        if (field.name == name) return field.values;
    snapshot.fields.push_back(
        {std::string(name), "", std::string(unit), Grid(snapshot.bed.nx(), snapshot.bed.ny())});
    return snapshot.fields.back().values;
}

/// 1 where ground below a height hangs together with the edge.
Mask flooded(const Snapshot& snapshot, double height) {
    const int nx = snapshot.bed.nx();
    const int ny = snapshot.bed.ny();
    const auto is_within = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < nx && y < ny &&
               (snapshot.nodata.empty() || snapshot.nodata(x, y) == 0);
    };
    Mask reached(nx, ny);
    std::vector<std::pair<int, int>> open;
    const auto reach = [&](int x, int y) {
        if (reached(x, y) != 0 || !(snapshot.bed(x, y) < height)) return;
        reached(x, y) = 1;
        open.emplace_back(x, y);
    };
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            if (!is_within(x, y)) continue;
            const bool at_edge = std::ranges::any_of(
                beside, [&](const auto& way) { return !is_within(x + way.first, y + way.second); });
            if (at_edge) reach(x, y);
        }
    }
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        for (const auto& [east, north] : beside)
            if (is_within(x + east, y + north)) reach(x + east, y + north);
    }
    return reached;
}

}  // namespace

bool add_sea(Snapshot& snapshot, double level) {
    if (snapshot.periodic) return false;
    const double unit = snapshot.scale.height_unit;
    const Mask sea = flooded(snapshot, level / unit);
    Grid& depth = field_to_fill(snapshot, "water_depth", "m");
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (sea.values()[i] == 0) continue;
        const double still = level - snapshot.bed.values()[i] * unit;
        depth.values()[i] = std::max(depth.values()[i], still);
    }
    field_to_fill(snapshot, "velocity_x", "m/s");
    field_to_fill(snapshot, "velocity_y", "m/s");
    return true;
}

}  // namespace fumon
