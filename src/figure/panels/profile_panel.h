#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "figure/canvas/panel.h"
#include "figure/panels/ground_arrow.h"
#include "figure/plot/axes.h"

namespace fumon {

/// The ground along x, and the water on it: a plain value.
struct ProfileLine {
    std::vector<double> bed;      ///< metres, or model heights
    std::vector<double> surface;  ///< of the water, likewise; at the bed where dry; empty: no water
    std::string label;            ///< "step 100"
};

/// The row `row` of a snapshot's bed and water (none: the means over all rows), named by its step
/// or time. Cells without data count as gaps. Throws InputError where `row` is not in the bed.
ProfileLine profile_line(const Snapshot& snapshot, std::optional<int> row);

/// Profiles of one extent, the first at the bottom.
struct ProfilePicture {
    std::vector<ProfileLine> lines;
    double length = 0.0;  ///< along x, metres or sites
    bool in_metres = false;
    std::string along = "x";              ///< what runs along the axis
    std::string x_label;                  ///< with {unit}; empty: that, and its unit
    std::string y_label;                  ///< likewise; empty: z and its unit
    std::optional<GroundDirection> wind;  ///< shown where it blows along x
    double exaggeration = 0.0;  ///< vertical; 0: the largest round number that the frame allows
};

/// The profiles of some snapshots of one grid.
ProfilePicture profile_picture(std::span<const Snapshot> snapshots, std::optional<int> row);

/// Profiles above one another, filled with sand and water, with one vertical exaggeration that
/// stands above them. One alone has an axis of heights; several have their names beside them, and
/// an upright bar of a round height.
class ProfilePanel : public PanelContent {
  public:
    /// Throws InputError where there is no profile.
    explicit ProfilePanel(ProfilePicture picture);

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

    /// The vertical exaggeration in a frame of that size.
    [[nodiscard]] double exaggeration(double width, double height) const;

  private:
    [[nodiscard]] Axes axes_in(const CanvasBox& frame) const;
    [[nodiscard]] bool stacked() const { return picture_.lines.size() > 1; }
    void draw_line(Canvas& canvas, const Axes& axes, const ProfileLine& line, double offset) const;
    void draw_height_bar(Canvas& canvas, const Axes& axes) const;

    ProfilePicture picture_;
    double low_ = 0.0;     ///< of all heights
    double relief_ = 1.0;  ///< from it to the highest
};

}  // namespace fumon
