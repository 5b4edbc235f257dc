#include "foreign/mesh_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fumon {

std::string volume_note(const LaidMesh& mesh, const std::vector<ChosenMap>& chosen,
                        std::size_t record,
                        const std::function<std::vector<double>(const ChosenMap&)>& values_of) {
    const auto find = [&](Quantity quantity) {
        const auto found = std::ranges::find(chosen, quantity, &ChosenMap::quantity);
        return found == chosen.end() ? nullptr : &*found;
    };
    const ChosenMap* bed = find(Quantity::bed);
    const ChosenMap* depth = find(Quantity::depth);
    const ChosenMap* level = find(Quantity::level);
    const ChosenMap* water = depth != nullptr ? depth : level;
    if (water == nullptr ||
        (depth == nullptr && (bed == nullptr || bed->map.place != level->map.place)))
        return {};
    std::vector<double> depths = values_of(*water);
    if (depth == nullptr) {
        const std::vector<double> heights = values_of(*bed);
        for (std::size_t i = 0; i < depths.size(); ++i) depths[i] -= heights[i];
    }
    for (double& value : depths) value = value > 0.0 ? value : 0.0;  // NaN too
    const double exact = water->map.place == MapPlace::faces ? mesh.grid.integral_of_faces(depths)
                                                             : mesh.grid.integral_of_nodes(depths);
    if (!(exact > 0.0)) return {};
    double laid = 0.0;
    const Grid cells = mesh.laid(water->map, depths);
    for (const double value : cells.values())
        if (std::isfinite(value)) laid += value * mesh.grid.cell() * mesh.grid.cell();
    return fmt::format("the cells hold {:.6g} m³ of water in record {}, {:+.2g} % against the mesh",
                       laid, record + 1, 100.0 * (laid / exact - 1.0));
}

}  // namespace fumon
