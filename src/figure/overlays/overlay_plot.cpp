#include "figure/overlays/overlay_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary_power.h"
#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "base/quantity_text.h"
#include "figure/overlays/overlay_text.h"
#include "figure/words/words.h"
#include "scene/uses_metres.h"

namespace fumon {

namespace {

constexpr double plot_text_size_em = 0.8;  // of the overlays' font size
constexpr double plot_height_share = 0.6;  // of its width
constexpr Ink curve{0.0, 0.28, 0.55, 1.0};

/// The smallest round number not below a positive one.
double round_up(double value) {
    constexpr std::array<double, 9> leading{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
    constexpr double rounding = 1.0 + 1e-9;
    const double power = elementary::pow(10.0, std::floor(elementary::log10(value)));
    for (const double one : leading) {
        if (value <= one * power * rounding) return one * power;
    }
    return 10.0 * power;
}

PlotAxis axis_of(const MeasuredColumn& column, double run_end) {
    const std::string& name = column.column.name;
    const bool of_run = (name == "step" || name == "time") && run_end > 0.0;
    const auto range =
        of_run
            ? std::pair{0.0, std::max(run_end, column.values.empty() ? 0.0 : column.values.back())}
            : growing_range(column.values);
    PlotAxis axis;
    axis.label = name == "time" && column.column.unit == "steps"
                     ? word("step")
                     : quantity_in_words(name, column.column.unit);
    axis.low = range.first;
    axis.high = range.second;
    return axis;
}

class LivePlot : public Overlay {
  public:
    LivePlot(const OverlayScene& on, std::size_t number)
        : settings_(on.scene.view.overlays[number]),
          width_(settings_.size * static_cast<double>(on.scene.view.image.width)),
          times_(time_text_of(on.scene, on.first)),
          run_end_(settings_.x == "step" ? static_cast<double>(times_.last)
                                         : times_.end.value_or(on.end_time.value_or(0.0))),
          scene_(on.scene) {
        MeasureSuite suite(measured_landform(on.first), on.first,
                           {on.scene.output.channel_area, uses_metres(on.scene)});
        const auto columns = measured_columns(suite.columns(), on.first);
        std::vector<std::string> names;
        names.reserve(columns.size());
        for (const MeasureColumn& column : columns) names.push_back(column.name);
        const auto find = [&](const std::string& key, const std::string& name) {
            if (const MeasureColumn* found = find_named(columns, name)) return *found;
            throw KeyError(overlay_key(number, key),
                           fmt::format("the measurements of {} have no column {}; {}",
                                       on.scene.model.name, name, suggestion(name, names)));
        };
        find("x", settings_.x);
        const MeasureColumn shown = find("y", settings_.y);
        heading_ = quantity_in_words(shown.name, shown.unit);
        if (!settings_.low.is_word() && !settings_.high.is_word() &&
            !(settings_.low.value < settings_.high.value)) {
            throw KeyError(overlay_key(number, "high"),
                           fmt::format("overlay.{}.high ({}) must be above overlay.{}.low ({})",
                                       number, settings_.high.value, number, settings_.low.value));
        }
        if (!settings_.text.empty()) heading_ = settings_.text;
        try {
            heading_ = filled_text(heading_, scene_, times_, 0, 0.0);
        } catch (const InputError& fault) {
            throw KeyError(overlay_key(number, "text"), fault.what());
        }
    }

    [[nodiscard]] FurnitureSize size(const Canvas& canvas) const override {
        // Where a small picture leaves no room for the axes, the plot cannot be smaller.
        const double font = plot_text_size_em * canvas.font_size();
        return {std::max(width_, least_width * font),
                std::max(plot_height_share * width_, least_height * font)};
    }
    [[nodiscard]] std::string appearance_in(const OverlayFrame& frame) const override {
        const MeasuredColumn* column = frame.rows.find(settings_.y);
        return fmt::format("{}", column == nullptr ? 0 : column->values.size());
    }
    void draw(Canvas& canvas, const CanvasBox& box, const OverlayFrame& frame) const override {
        const double outer_font = canvas.font_size();
        canvas.set_font_size(plot_text_size_em * outer_font);
        canvas.set_line_width(std::max(1.0, 0.06 * canvas.font_size()));
        const double font = canvas.font_size();
        const auto [length, height] = canvas.text_size(heading_);
        canvas.write(heading_, {box.x, box.y}, {0.0, 0.0}, black_ink,
                     std::min(1.0, box.width / std::max(length, 1.0)));
        const PlotPanel panel(live_plot(settings_, frame.rows, run_end_));
        const double top = height + 0.55 * font;
        // Twice, since the margins depend on the frame's size.
        CanvasBox inner{box.x, box.y + top, box.width, box.height - top};
        for (int i = 0; i < 2; ++i) {
            const PanelMargins margins = panel.margins(canvas, inner.width, inner.height);
            const double left = std::max(margins.left, 2.6 * font);  // so that it stays in place
            inner = {box.x + left, box.y + top, box.width - left - margins.right,
                     box.height - top - margins.below};
        }
        panel.draw(canvas, inner);
        canvas.set_font_size(outer_font);
    }

  private:
    static constexpr double least_width = 12.0;  // font sizes of the plot
    static constexpr double least_height = 8.5;

    OverlaySettings settings_;
    double width_;
    TimeText times_;
    double run_end_;
    const Scene& scene_;
    std::string heading_;
};

}  // namespace

std::pair<double, double> growing_range(std::span<const double> values) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!(low <= high)) return {0.0, 1.0};
    const double largest = std::max(std::abs(low), std::abs(high));
    if (largest == 0.0) return {0.0, 1.0};
    constexpr double narrow = 0.005;
    const double spread = high - low;
    if (spread > 0.0 && spread < narrow * largest && low * high > 0.0) {
        const double step = round_up(spread);
        return {std::floor(low / step) * step, std::ceil(high / step) * step};
    }
    return {low < 0.0 ? -round_up(-low) : 0.0, high > 0.0 ? round_up(high) : 0.0};
}

Plot live_plot(const OverlaySettings& settings, const MeasuredRows& rows, double run_end) {
    Plot plot;
    plot.legend = LegendPosition::none;
    plot.x.low = plot.y.low = 0.0;
    plot.x.high = plot.y.high = 1.0;
    const MeasuredColumn* x = rows.find(settings.x);
    const MeasuredColumn* y = rows.find(settings.y);
    if (x == nullptr || y == nullptr) return plot;
    plot.x = axis_of(*x, run_end);
    plot.y = axis_of(*y, run_end);
    plot.y.label.clear();  // it stands above the plot
    if (!settings.low.is_word()) plot.y.low = settings.low.value;
    if (!settings.high.is_word()) plot.y.high = settings.high.value;
    if (!(*plot.y.low < *plot.y.high)) {  // one end is fixed beyond all values
        const double room = std::max(1.0, std::abs(*plot.y.low));
        if (settings.high.is_word())
            plot.y.high = *plot.y.low + room;
        else
            plot.y.low = *plot.y.high - room;
    }
    PlotSeries line;
    line.x = x->values.copied();
    line.y = y->values.copied();
    line.ink = curve;
    line.dashes = LineDashes{};
    PlotSeries latest;
    latest.kind = SeriesKind::points;
    latest.ink = curve;
    latest.marker = Marker::circle;
    if (!y->values.empty()) {
        latest.x = {x->values.back()};
        latest.y = {y->values.back()};
    }
    plot.series = {line, latest};
    return plot;
}

/// A measurement over time, up to the frame, overlay.size of the picture's width across. None where
/// the measurements have no such column, nor where overlay.high is not above overlay.low.
std::unique_ptr<Overlay> make_plot_overlay(const OverlayScene& on, std::size_t number) {
    return std::make_unique<LivePlot>(on, number);
}

}  // namespace fumon
