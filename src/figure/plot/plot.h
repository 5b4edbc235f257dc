#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/canvas/panel.h"
#include "figure/plot/marker.h"

namespace fumon {

/// One side's axis of a plot.
struct PlotAxis {
    std::string label = {};  ///< the quantity, with its unit in brackets
    bool logarithmic = false;
    std::optional<double> low = {};   ///< else from the data, at a round number
    std::optional<double> high = {};  ///< likewise
    bool tick_labels = true;          ///< false: neither they nor the label show (a shared axis)
    bool ticks = true;                ///< false: no marks either
    /// Marks at these values alone, with these words, in place of round numbers; in rising order.
    std::vector<std::pair<double, std::string>> named = {};
};

enum class SeriesKind {
    line,
    points,  ///< a marker each
    line_and_points,
    step,  ///< constant from each x to the next
    band,  ///< filled between y_low and y
    area,  ///< filled within the line through all points, which is closed
    fit,   ///< a thin line behind all points, bars and curves
};

/// One quantity over another. Values that are not finite, or not above 0 on a logarithmic axis, are
/// gaps.
struct PlotSeries {
    std::string label;  ///< in the legend; empty: not there
    SeriesKind kind = SeriesKind::line;
    std::vector<double> x;
    std::vector<double> y;             ///< as many as x
    std::vector<double> y_low;         ///< of a band: as many as x
    std::vector<double> x_error;       ///< half the length of each point's bar; empty: none
    std::vector<double> y_error;       ///< likewise
    std::vector<Ink> inks;             ///< of the points' markers; empty: the series's
    std::vector<bool> hollow;          ///< points whose markers are not filled; empty: none
    bool with_band = false;            ///< whose legend shows the band of its colour too
    bool on_right = false;             ///< counts on the right axis
    std::optional<Ink> ink;            ///< else the next of the cycle
    std::optional<Marker> marker;      ///< else the next of the cycle
    std::optional<LineDashes> dashes;  ///< else the next of the cycle
    double width = 0.0;                ///< of the line, units; 0: twice that of the frame
};

/// A range of both quantities that a source states, drawn as a tinted box with its label.
struct PlotBox {
    std::string label;
    double x_low = 0.0;
    double x_high = 1.0;
    double y_low = 0.0;
    double y_high = 1.0;
};

/// A thin dashed line across the frame at a value.
struct ReferenceLine {
    bool upright = false;  ///< at a value of x, else of y
    double value = 0.0;
    std::string label;
};

/// A text at a place of the axes.
struct PlotText {
    std::string text;
    double x = 0.0;
    double y = 0.0;
    CanvasPoint anchor{0.0, 1.0};  ///< which share of the text's box stands there
};

enum class LegendPosition {
    automatic,  ///< the emptiest corner; where all are taken, below the frame or right of it
    none,
    upper_left,
    upper_right,
    lower_left,
    lower_right,
    right,
    below,
};

/// All that a plot shows.
struct Plot {
    PlotAxis x;
    PlotAxis y;
    std::optional<PlotAxis> right;  ///< of the series on the right
    std::vector<PlotSeries> series;
    std::vector<PlotBox> boxes;
    std::vector<ReferenceLine> lines;
    std::vector<PlotText> texts;
    LegendPosition legend = LegendPosition::automatic;
    /// What else covers the frame, as an inset: shares of its width and height from its upper left
    /// corner, where no legend is put.
    std::vector<CanvasBox> taken;
};

/// A plot as a panel of a page.
class PlotPanel : public PanelContent {
  public:
    /// Throws InputError where a series has lists of different lengths, an axis an empty range or
    /// a logarithmic one a limit that is not above 0.
    explicit PlotPanel(Plot plot);
    ~PlotPanel() override;

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

    [[nodiscard]] const Plot& plot() const { return plot_; }

  private:
    Plot plot_;
};

/// Gives plots that stand in a grid of `columns`, row by row, the same x ranges in each column
/// (`share_x`) and the same y ranges in each row (`share_y`), and leaves the tick labels to the
/// outer ones. The plots' axes have the same kind.
void share_axes(std::span<Plot> plots, int columns, bool share_x, bool share_y);

}  // namespace fumon
