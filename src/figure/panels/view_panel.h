#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figure/canvas/panel.h"
#include "figure/panels/colour_bar.h"
#include "figure/panels/ground_arrow.h"
#include "figure/panels/scale_bar.h"
#include "figure/panels/view_picture.h"
#include "figure/plot/coordinate_marks.h"

namespace fumon {

/// What a panel shows beside a view.
struct ViewSettings {
    bool scale_bar = true;                 ///< along the edge of the ground that faces the camera
    bool exaggeration = true;              ///< state it, where it is not 1
    std::string label;                     ///< in the upper left corner: "t = 100 s"
    std::optional<GroundDirection> arrow;  ///< of the wind or the flow, as seen
    bool compass = false;
    bool coordinates = false;  ///< of the bed's file, along the block's lower edges
    BarPosition colour_bar = BarPosition::none;
    ColourScale colours;  ///< of the bar
};

/// A shaded view as a panel. Its furniture stands in empty corners of the picture or, where these
/// are too small, below it.
class ViewPanel : public PanelContent {
  public:
    ViewPanel(ViewPicture picture, ViewSettings settings);

    [[nodiscard]] double aspect() const override;
    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

    /// The bar on the ground beside the edge that faces the camera, where the picture fills
    /// `frame`.
    [[nodiscard]] GroundBar ground_bar(const CanvasBox& frame) const;

  private:
    struct Placement;
    [[nodiscard]] GroundBar bar_beside(const CanvasBox& frame, double off) const;
    [[nodiscard]] Placement place(const Canvas& canvas, const CanvasBox& frame) const;
    [[nodiscard]] std::vector<CoordinateMark> marks_in(const Canvas& canvas,
                                                       const CanvasBox& frame) const;
    void draw_contours_over(Canvas& canvas, const CanvasBox& frame) const;
    void draw_layers_over(Canvas& canvas, const CanvasBox& frame) const;
    void draw_coordinates(Canvas& canvas, const CanvasBox& frame) const;
    [[nodiscard]] bool empty(const CanvasBox& frame, const CanvasBox& box) const;

    ViewPicture picture_;
    ViewSettings settings_;
};

}  // namespace fumon
