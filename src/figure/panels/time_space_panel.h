#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/snapshot.h"
#include "figure/canvas/panel.h"
#include "figure/panels/colour_bar.h"
#include "figure/plot/axes.h"
#include "render/colour/colouring.h"
#include "scene/scene.h"

namespace fumon {

/// One row of a field at many times: a plain value.
struct TimeSpacePicture {
    Grid values;                ///< nx × records; row n is that of times[n]; NaN: no data
    std::vector<double> times;  ///< ascending, one a record
    std::string time_label;     ///< "step", "t (s)"
    std::string x_label;        ///< with {unit}; empty: x and its unit
    std::string y_label;        ///< likewise; empty: time_label
    double length = 0.0;        ///< along x, metres or sites
    bool in_metres = false;
    ColourScale colours;
};

/// The row `row` of each snapshot (none: the mean over the rows) of what look.colour_by says, as
/// map_pictures() shows it, `tails` being those of its colours. At least two snapshots, in the
/// order of their steps. Throws InputError where they are fewer or `row` is not in the bed, and
/// what map_pictures throws.
TimeSpacePicture time_space_picture(const LookSettings& look, std::span<const Snapshot> snapshots,
                                    std::optional<int> row, const RangeTails& tails = {});

/// A row's course over time as a panel: x to the right, time upward, each record from halfway to
/// the one before to halfway to the next.
class TimeSpacePanel : public PanelContent {
  public:
    explicit TimeSpacePanel(TimeSpacePicture picture, BarPosition colour_bar = BarPosition::right);

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

  private:
    [[nodiscard]] Axes axes_in(const CanvasBox& frame) const;

    TimeSpacePicture picture_;
    BarPosition colour_bar_;
};

}  // namespace fumon
