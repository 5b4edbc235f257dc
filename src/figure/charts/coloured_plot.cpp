#include "figure/charts/coloured_plot.h"

#include <utility>

namespace fumon {

ColouredPlotPanel::ColouredPlotPanel(Plot plot, std::vector<std::vector<double>> values,
                                     ColourScale colours, BarPosition bar)
    : plot_(std::move(plot)), values_(std::move(values)), colours_(std::move(colours)), bar_(bar) {
    const PlotPanel checked(plot_);
}

PanelMargins ColouredPlotPanel::margins(const Canvas& canvas, double width, double height) const {
    return with_colour_bar(canvas, PlotPanel(plot_).margins(canvas, width, height), bar_, colours_,
                           width, height);
}

void ColouredPlotPanel::draw(Canvas& canvas, const CanvasBox& frame) const {
    Plot plot = plot_;
    for (std::size_t n = 0; n < values_.size(); ++n) {
        for (const double value : values_[n]) plot.series[n].inks.push_back(colours_.ink(value));
    }
    const PlotPanel panel(std::move(plot));
    panel.draw(canvas, frame);
    draw_placed_bar(canvas, frame, panel.margins(canvas, frame.width, frame.height), bar_,
                    colours_);
}

}  // namespace fumon
