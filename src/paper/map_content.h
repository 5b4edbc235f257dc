#pragma once

#include <string>

#include "base/snapshot.h"
#include "figure/panels/map_panel.h"
#include "paper/panel_makers.h"

namespace fumon {

/// Puts a map into a panel: its picture, its values as an ESRI ASCII grid at `scale` among the
/// data, and where the panel asks for it the colours and axes that it shares. `values` are the
/// least and the largest, `range` what tells that two maps have the same axes.
void put_map(MapPicture picture, MapPanelSettings shown, const WorldScale& scale,
             const PanelColours::Values& values, const std::string& range,
             const PanelSettings& settings, MadePanel& panel);

}  // namespace fumon
