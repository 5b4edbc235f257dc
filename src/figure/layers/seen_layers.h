#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "figure/canvas/canvas_box.h"
#include "scene/view/layers.h"

namespace fumon {

/// How a picture shows places of a bed.
class GroundSight {
  public:
    GroundSight() = default;
    GroundSight(const GroundSight&) = delete;
    GroundSight& operator=(const GroundSight&) = delete;
    virtual ~GroundSight() = default;

    /// Where a place of the ground is seen; none behind the camera.
    [[nodiscard]] virtual std::optional<CanvasPoint> at(const BedPlace& place) const = 0;
    /// Whether nothing hides it.
    [[nodiscard]] virtual bool visible(const BedPlace& place) const = 0;
};

/// A line, or a part of one, on a canvas.
struct SeenPart {
    std::vector<CanvasPoint> points;
    bool hidden = false;  ///< behind ridges
};

struct SeenFeature {
    LayerShape shape = LayerShape::lines;
    double width = 1.0;           ///< of lines, in widths of the layer
    std::vector<SeenPart> parts;  ///< lines, or outlines of what lines cover; points one by one
    std::vector<std::vector<CanvasPoint>> rings;  ///< of areas, where no other drawing shows them
    std::string label;
    std::optional<SeenPart> anchor;  ///< of its label: a point
};

/// A layer on a canvas: a plain value.
struct SeenLayer {
    std::vector<SeenFeature> features;
};

/// What is asked of a picture's layers.
struct LayersAsked {
    std::span<const LayerSettings> settings;
    const PlacedLayers& placed;
    CanvasBox frame;        ///< beyond which nothing is looked for
    double length_x = 1.0;  ///< of the bed, metres or sites
    double length_y = 1.0;
    bool areas = false;  ///< with their rings
};

/// Layers as a picture shows them; what ridges hide only where a layer shows it.
std::vector<SeenLayer> seen_layers(const LayersAsked& asked, const GroundSight& sight);

/// The same where the unit square fills a box.
std::vector<SeenLayer> in_box(std::vector<SeenLayer> layers, const CanvasBox& box);

}  // namespace fumon
