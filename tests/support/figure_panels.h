#pragma once

#include <memory>
#include <string>
#include <utility>

#include "figure/page/page.h"
#include "figure/plot/plot.h"

namespace fumon::test {

/// A panel with a given aspect and margins, which draws to the ends of both.
class PlainPanel : public PanelContent {
  public:
    PlainPanel(double aspect, const PanelMargins& margins) : aspect_(aspect), margins_(margins) {}

    [[nodiscard]] double aspect() const override { return aspect_; }
    [[nodiscard]] PanelMargins margins(const Canvas& /*canvas*/, double /*width*/,
                                       double /*height*/) const override {
        return margins_;
    }
    void draw(Canvas& canvas, const CanvasBox& frame) const override {
        canvas.fill(CanvasBox{frame.x - margins_.left, frame.y - margins_.above,
                              frame.width + margins_.left + margins_.right,
                              frame.height + margins_.above + margins_.below},
                    {0.8, 0.8, 0.8});
        canvas.fill(frame, {0.4, 0.4, 0.4});
    }

  private:
    double aspect_;
    PanelMargins margins_;
};

/// A curve of that many points in x = 0 … 1.
template <class Curve>
PlotSeries series_of(std::string label, int count, Curve curve) {
    PlotSeries series;
    series.label = std::move(label);
    for (int i = 0; i < count; ++i) {
        series.x.push_back(static_cast<double>(i) / (count - 1));
        series.y.push_back(curve(series.x.back()));
    }
    return series;
}

inline PagePanel panel_of(Plot plot, std::string title = "") {
    PagePanel panel;
    panel.content = std::make_unique<PlotPanel>(std::move(plot));
    panel.title = std::move(title);
    return panel;
}

}  // namespace fumon::test
