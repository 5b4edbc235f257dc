#pragma once

#include "keys/keys.h"
#include "scene/figure/figure_settings.h"

namespace fumon {

/// Lists the keys `figure.*`, those of its panels, curves and boxes.
void list_figure_keys(FigureSettings& figure, KeyTable& table);

/// Lists the keys of the overlays (`overlay.N.*`).
void list_overlay_keys(std::vector<OverlaySettings>& overlays, KeyTable& table);

}  // namespace fumon
