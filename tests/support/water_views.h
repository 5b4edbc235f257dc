#pragma once

#include "render/view/block.h"
#include "support/water_beds.h"

namespace fumon {

/// From above, of a square bed, without margins: picture places are places on the bed.
inline View map_view(int side = 200) {
    View view;
    view.image.width = side;
    view.image.height = side;
    view.camera.projection = Projection::map;
    view.camera.margin = 0.0;
    view.look.grain = 0.0;
    view.look.sky = SkyModel::two_colours;  // in whose light brightnesses are told apart
    view.look.tone = Tone::filmic;
    view.look.exaggeration = {"", 1.0};
    return view;
}

/// The west half of a flat bed wet, to one depth and speed.
inline Snapshot half_wet(double depth, double speed = 0.0) {
    Snapshot snapshot = under_water(flat_bed(100, 100), 0.0, 0.0);
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 50; ++x) {
            snapshot.fields[0].values(x, y) = depth;
            snapshot.fields[2].values(x, y) = speed;
        }
    }
    return snapshot;
}

}  // namespace fumon
