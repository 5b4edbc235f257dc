#pragma once

#include <string>
#include <vector>

#include "base/grid.h"
#include "figure/panels/colour_bar.h"
#include "figure/plot/plot_axes.h"
#include "numerics/contour_lines.h"

namespace fumon {

/// One side of a heat map: what its columns or rows stand for and where they lie.
struct HeatAxis {
    std::string label;
    std::vector<std::string> names;  ///< of each, in order
    std::vector<double> middles;     ///< shares of the side, rising from 0 to 1
    std::vector<double> edges;       ///< likewise, one more: the first 0, the last 1
    bool tick_labels = true;         ///< false: neither they nor the label show
};

/// Columns of words, all as wide as each other.
HeatAxis even_axis(std::vector<std::string> names);
/// Columns of rising numbers that reach from halfway to one to halfway to the next, the outermost
/// as far out as in; halfway in the logarithms where the axis is logarithmic (then all are above
/// 0).
HeatAxis value_axis(const std::vector<double>& values, std::vector<std::string> names,
                    bool logarithmic);

/// A table of values as coloured cells: a plain value.
struct HeatMap {
    HeatAxis x;
    HeatAxis y;   ///< upward
    Grid values;  ///< x.names.size() × y.names.size(); NaN: none, a crossed cell
    std::vector<std::string> texts;  ///< of the cells, row by row from the bottom; empty: none
    ColourScale colours;
    std::vector<double> bounds;  ///< of the colours' classes, where it has some
    BarPosition bar = BarPosition::right;
    /// Lines between the middles of cells, which are whole numbers.
    std::vector<ContourLine> lines;
    bool name_lines = false;  ///< their values stand on them

    /// The class of a value, from 0: how many bounds it reaches.
    [[nodiscard]] std::size_t class_of(double value) const;
    [[nodiscard]] Ink ink(double value) const;
};

/// The lines where values, linear between the middles of neighbouring cells and even beyond the
/// outermost, have a level; in cells, from −½ to the number of cells − ½.
std::vector<ContourLine> cell_lines(const Grid& values, double level);

/// A heat map as a panel, with ticks at the middles of its cells.
class HeatMapPanel : public PanelContent {
  public:
    explicit HeatMapPanel(HeatMap map) : map_(std::move(map)) {}

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override;
    void draw(Canvas& canvas, const CanvasBox& frame) const override;

    /// To be changed before it is drawn.
    ColourScale& colours() { return map_.colours; }
    BarPosition& colour_bar() { return map_.bar; }
    bool& x_axis() { return map_.x.tick_labels; }
    bool& y_axis() { return map_.y.tick_labels; }

  private:
    [[nodiscard]] PlotAxes axes_in(const Canvas& canvas, const CanvasBox& frame) const;
    [[nodiscard]] CanvasBox cell_box(const CanvasBox& frame, int x, int y) const;
    void draw_cells(Canvas& canvas, const CanvasBox& frame) const;
    void draw_texts(Canvas& canvas, const CanvasBox& frame) const;
    void draw_lines(Canvas& canvas, const CanvasBox& frame) const;

    HeatMap map_;
};

}  // namespace fumon
