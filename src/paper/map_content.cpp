#include "paper/map_content.h"

#include <memory>
#include <utility>

#include "files/terrain/terrain_format.h"

namespace fumon {

void put_map(MapPicture picture, MapPanelSettings shown, const WorldScale& scale,
             const PanelColours::Values& values, const std::string& range,
             const PanelSettings& settings, MadePanel& panel) {
    for (TerrainBytes& file :
         find_written_format("esri-ascii")->write({picture.values, picture.blank, scale}))
        panel.data.push_back({std::move(file.ending), std::move(file.bytes)});
    auto content = std::make_unique<MapPanel>(std::move(picture), std::move(shown));
    if (settings.chart.share_colours)
        panel.shared = {&content->colours(), &content->colour_bar(), values};
    if (settings.chart.share_axes && settings.axes)
        panel.axes = {&content->x_axis(), &content->y_axis(), range, range};
    panel.content = std::move(content);
}

}  // namespace fumon
