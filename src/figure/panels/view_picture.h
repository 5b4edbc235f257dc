#pragma once

#include <memory>
#include <vector>

#include "base/image.h"
#include "base/snapshot.h"
#include "figure/layers/seen_layers.h"
#include "figure/panels/contours.h"
#include "figure/panels/ground_axes.h"
#include "scene/scene.h"

namespace fumon {

/// A shaded view as the renderer drew it on white, cut to what it shows, and where the ground lies
/// in it: a plain value.
struct ViewPicture {
    Image image;
    Camera camera;
    Block block;
    /// The whole of the renderer's picture in terms of the cut one: its left, top, width and
    /// height, of which the cut picture is (0, 0, 1, 1).
    CanvasBox whole{0.0, 0.0, 1.0, 1.0};
    bool in_metres = false;
    double exaggeration = 1.0;  ///< vertical
    WorldScale scale;           ///< of the bed
    double length_x = 1.0;      ///< of the bed, metres or sites
    double length_y = 1.0;
    /// Lines of equal height where they are seen: the cut picture is 1 wide and 1 high.
    std::vector<CanvasContour> contours{};
    double contour_interval = 1.0;
    /// Layers where they are seen, in the same square; their settings, and how they lie on the bed.
    std::vector<SeenLayer> layers{};
    std::vector<LayerSettings> layer_settings{};
    std::shared_ptr<const PlacedLayers> placed_layers{};

    /// The view where the cut picture fills `frame`.
    [[nodiscard]] ViewProjection in(const CanvasBox& frame) const;
};

/// A renderer's picture of `snapshot`, framed by `first` with that vertical exaggeration, at a
/// share of the run; cut to the pixels that differ from the one in its upper left corner. `view`
/// has look.mode = figure. With look.relief = clear the ground gets a thin outline where the
/// renderer left the paper transparent.
ViewPicture view_picture(const View& view, const Image& image, const Snapshot& first,
                         double exaggeration, double progress = 0.0);

/// The width of that outline in pixels.
double outline_width(const ImageSettings& image);

/// Draws lines of equal height over the ground of a snapshot whose picture that is. Throws as
/// ground_contours().
void add_contours(ViewPicture& picture, const View& view, const WordOrReal& asked,
                  const Snapshot& first, const Snapshot& snapshot);

/// Draws the layers of a view over the ground of a snapshot whose picture that is.
void add_layers(ViewPicture& picture, const View& view, const Snapshot& first,
                const Snapshot& snapshot);

}  // namespace fumon
