#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "figure/canvas/corner.h"
#include "figure/canvas/panel.h"
#include "figure/panels/contours.h"
#include "figure/panels/ground_arrow.h"
#include "figure/panels/map_picture.h"
#include "figure/plot/axes.h"
#include "scene/view/layers.h"

namespace fumon {

/// Velocities over a map, drawn as arrows with one of a round speed above the frame.
struct MapFlow {
    Grid velocity_x;  ///< eastward, of the map's cells
    Grid velocity_y;  ///< northward
    /// Whose arrow is as long as arrows are apart; 0: that which a twentieth of the moving cells
    /// exceeds.
    double fastest = 0.0;
    std::string unit = "m/s";
};

/// The velocity of a snapshot's water; none where it has no water.
std::optional<MapFlow> water_flow_of(const Snapshot& snapshot);

/// A line through the middle of a map, along a direction of the ground.
struct MapLine {
    glm::dvec2 along{1.0, 0.0};  ///< a unit vector, east and north
    bool broken = false;         ///< what is predicted, in red; else what is measured, in black
};

/// What a panel shows of a map and around it.
struct MapPanelSettings {
    bool axes = true;  ///< x and y in metres, millimetres, kilometres or sites; else a plain frame
    std::string x_label;  ///< with {unit}; empty: x and its unit
    std::string y_label;
    /// Where the picture's cells lie, for axes with the coordinates of their file.
    std::optional<WorldScale> coordinates;
    bool x_axis = true;  ///< false: only y has numbers (maps above each other)
    bool y_axis = true;  ///< false: only x has numbers (maps side by side)
    BarPosition colour_bar = BarPosition::right;
    bool scale_bar = false;
    Corner scale_bar_corner = Corner::lower_right;
    std::string label;  ///< within the picture: "t = 100 s"
    Corner label_corner = Corner::upper_left;
    std::optional<GroundDirection> arrow;  ///< of the wind or the flow, see arrow_corner()
    bool compass = false;
    Corner compass_corner = Corner::lower_left;
    Ink blank{1.0, 1.0, 1.0, 1.0};  ///< of cells without a value
    std::optional<MapFlow> flow;
    std::optional<GroundContours> contours;
    std::vector<MapLine> lines;
    std::vector<LayerSettings> layers;  ///< laid over the map; those with a legend have one
    std::shared_ptr<const PlacedLayers> placed_layers{};
    int most_pixels = 2100;  ///< along a side; more cells are averaged
};

/// The corner of a map where an arrow hides least: the upper right one, unless the values under the
/// plate in another that is not `taken` spread less than half as much about their mean. `size` of
/// the plate and its `margin` from the frame are units, as those of the frame.
Corner arrow_corner(const Grid& values, const CanvasBox& frame, const FurnitureSize& size,
                    double margin, const std::vector<Corner>& taken);

/// The corner of a map where a piece covers the fewest cells with a value, of those that are not
/// `taken`; the upper right one where none is better.
Corner emptiest_corner(const MapPicture& picture, const CanvasBox& frame, const FurnitureSize& size,
                       double margin, const std::vector<Corner>& taken);

/// A map as a panel: equal scales along both axes, north up, every cell in the colour that the bar
/// gives to its value.
class MapPanel : public PanelContent {
  public:
    MapPanel(MapPicture picture, MapPanelSettings settings);

    [[nodiscard]] double aspect() const override;
    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

    /// To be changed before it is drawn.
    ColourScale& colours() { return picture_.colours; }
    BarPosition& colour_bar() { return settings_.colour_bar; }
    bool& x_axis() { return settings_.x_axis; }
    bool& y_axis() { return settings_.y_axis; }

  private:
    [[nodiscard]] Axes axes_in(const CanvasBox& frame) const;
    [[nodiscard]] Axes shown_axes(const CanvasBox& frame) const;
    void draw_flow(Canvas& canvas, const Axes& axes) const;
    void draw_contours_over(Canvas& canvas, const CanvasBox& frame) const;
    void draw_lines(Canvas& canvas, const CanvasBox& frame) const;
    void draw_layers_over(Canvas& canvas, const CanvasBox& frame) const;
    void draw_furniture(Canvas& canvas, const CanvasBox& frame) const;
    [[nodiscard]] std::vector<Corner> taken_corners() const;

    MapPicture picture_;
    MapPanelSettings settings_;
};

}  // namespace fumon
