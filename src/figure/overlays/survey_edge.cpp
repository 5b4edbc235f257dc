#include "figure/overlays/survey_edge.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/grid.h"
#include "numerics/contour_lines.h"

namespace fumon {

LayerSettings survey_edge_settings() {
    LayerSettings settings;
    settings.colour = "#fff6e0";
    settings.width = 1.5;
    settings.opacity = 0.85;
    settings.hidden = BehindRidges::hide;
    return settings;
}

PlacedLayer survey_edge(const Snapshot& first) {
    const int nx = first.bed.nx();
    const int ny = first.bed.ny();
    Grid inside(nx + 2, ny + 2);
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            inside(x + 1, y + 1) = first.nodata.empty() || first.nodata(x, y) == 0 ? 1.0 : 0.0;
    constexpr double level = 0.51;  // on the bed's side of the edge: beyond it nothing has a height
    LayerFeature feature;
    for (const ContourLine& line : contour_lines(inside, {}, level)) {
        std::vector<BedPlace> places;
        places.reserve(line.points.size());
        for (const glm::dvec2& at : line.points) {
            places.push_back(
                {std::clamp((at.x - 0.5) / nx, 0.0, 1.0), std::clamp((at.y - 0.5) / ny, 0.0, 1.0)});
        }
        feature.lines.push_back(std::move(places));
    }
    PlacedLayer layer;
    layer.features.push_back(std::move(feature));
    return layer;
}

}  // namespace fumon
