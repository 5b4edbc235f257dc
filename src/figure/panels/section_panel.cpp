#include "figure/panels/section_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/find_named.h"
#include "base/snapshot.h"
#include "figure/panels/axis_units.h"
#include "figure/panels/scale_bar.h"
#include "figure/panels/section_lines.h"
#include "figure/panels/section_map.h"
#include "figure/plot/plot.h"
#include "figure/words/words.h"

namespace fumon {

namespace {

/// The shown paths of grains, in one colour per launch angle, over the height above the profile's
/// zero, to be drawn over the bed. `unit` is what lengths are shown in.
Plot paths_plot(const Snapshot& snapshot, const LengthUnit& unit) {
    const SnapshotSection& section = *snapshot.section;
    std::set<double> angles;
    for (const GrainPath& path : section.paths) angles.insert(path.launch_angle);
    double highest = highest_bed(snapshot) / unit.length;
    double east = snapshot.bed.nx() * section.dx / unit.length;
    Plot plot;
    std::set<double> named;
    for (const GrainPath& path : section.paths) {
        const auto place = std::distance(angles.begin(), angles.find(path.launch_angle));
        const SeriesLook look = series_look(static_cast<std::size_t>(place));
        PlotSeries series;
        if (named.insert(path.launch_angle).second)
            series.label = fmt::format("{:g}°", path.launch_angle);
        series.ink = look.ink;
        series.dashes = LineDashes{};
        for (std::size_t i = 0; i < path.x.size(); ++i) {
            series.x.push_back(path.x[i] / unit.length);
            series.y.push_back(path.z[i] / unit.length);
            east = std::max(east, series.x.back());
            highest = std::max(highest, series.y.back());
        }
        plot.series.push_back(std::move(series));
    }
    plot.x.label = labelled("x", unit.symbol);
    plot.x.low = 0.0;
    plot.x.high = east;
    plot.y.label = labelled("z", unit.symbol);
    plot.y.low = 0.0;
    plot.y.high = highest > 0.0 ? 1.1 * highest : 1.0;
    return plot;
}

struct PanelName {
    SectionPanel panel;
    std::string_view name;
    Word title;
};

constexpr std::array<PanelName, 6> panel_names{
    {{SectionPanel::velocity, "velocity", "Velocity of the air"},
     {SectionPanel::pressure, "pressure", "Pressure"},
     {SectionPanel::stress, "stress", "Shear stress over the bed"},
     {SectionPanel::flights, "flights", "Flight length over the bed"},
     {SectionPanel::flight_law, "flight-law", "Flight length and height"},
     {SectionPanel::paths, "paths", "Paths of grains"}}};

constexpr double longest_equal_scale_ratio = 6.0;  // length over height of a map with equal scales
constexpr double shortest_exaggerated_ratio = 3.0;
constexpr double room_of_heading_em = 1.5;  // font sizes
constexpr double bed_share = 0.25;          // of a panel's height, for the bed behind its lines

bool gives(const Snapshot& snapshot, SectionPanel panel) {
    const SnapshotSection& section = *snapshot.section;
    const SectionAir air(snapshot);
    switch (panel) {
        case SectionPanel::velocity:
            return air.find("velocity_x") && air.find("velocity_z");
        case SectionPanel::pressure:
            return air.find("pressure") != nullptr;
        case SectionPanel::stress:
            return !section_curves(section, "bed_shear_stress").empty();
        case SectionPanel::paths:
            return !section.paths.empty();
        default:
            return !section_curves(section, "flight_length_").empty();
    }
}

SectionQuantity quantity_of(const View& view, SectionPanel panel) {
    return panel == SectionPanel::velocity ? static_cast<SectionQuantity>(view.section.colour_by)
                                           : SectionQuantity::pressure;
}

ColourScale scale_of(const View& view, const SectionAir& air, SectionPanel panel) {
    const WordOrReal automatic{"auto", 0.0};
    const bool velocity = panel == SectionPanel::velocity;
    return map_scale(air, quantity_of(view, panel), view.look,
                     velocity ? view.section.low : automatic,
                     velocity ? view.section.high : automatic);
}

/// The air as colours, with its velocity.
class SectionMapPanel : public PanelContent {
  public:
    SectionMapPanel(const View& view, const Snapshot& snapshot, SectionPanel panel,
                    BarPosition colour_bar)
        : snapshot_(snapshot),
          air_(snapshot_),
          unit_(length_unit(true, air_.length())),
          exaggeration_(section_exaggeration(snapshot)),
          colour_bar_(colour_bar),
          velocity_(panel == SectionPanel::velocity),
          arrows_(view.section.arrows) {
        quantity_ = quantity_of(view, panel);
        scale_ = scale_of(view, air_, panel);
    }

    [[nodiscard]] double aspect() const override {
        return air_.length() / (exaggeration_ * air_.height());
    }

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override {
        PanelMargins room = axes_in({0.0, 0.0, width, height}).margins(canvas);
        if (has_heading())
            room.above = std::max(room.above, room_of_heading_em * canvas.font_size());
        return with_colour_bar(canvas, room, colour_bar_, scale_, width, height);
    }

    void draw(Canvas& canvas, const CanvasBox& frame) const override {
        const Axes axes = axes_in(frame);
        draw_section_map(canvas, axes, unit_.length, air_, quantity_, scale_);
        double taken = 0.0;
        if (velocity_ && arrows_ == SectionArrows::streamlines)
            draw_section_streamlines(canvas, axes, unit_.length, air_);
        if (has_arrows()) {
            const ArrowField arrows = section_arrows(air_, unit_.length);
            draw_arrow_field(canvas, axes, arrows);
            taken = draw_reference_arrow(canvas, axes, arrows);
        }
        if (velocity_) draw_section_bed(canvas, axes, unit_.length, air_);
        axes.draw(canvas);
        draw_placed_bar(canvas, frame, axes.margins(canvas), colour_bar_, scale_);
        if (exaggeration_ == 1.0) return;
        const double font = canvas.font_size();
        write_within(canvas, phrase("heights × {}", fmt::format("{:g}", exaggeration_)),
                     frame.width - taken - 0.5 * font,
                     {frame.x, frame.y - 0.5 * room_of_heading_em * font}, {0.0, 0.5},
                     tick_text_size_em);
    }

  private:
    [[nodiscard]] Axes axes_in(const CanvasBox& frame) const {
        return {frame,
                {0.0, air_.length() / unit_.length, labelled("x", unit_.symbol)},
                {0.0, air_.height() / unit_.length, labelled("z", unit_.symbol)}};
    }
    [[nodiscard]] bool has_arrows() const { return velocity_ && arrows_ == SectionArrows::arrows; }
    [[nodiscard]] bool has_heading() const { return has_arrows() || exaggeration_ != 1.0; }

    Snapshot snapshot_;
    SectionAir air_;
    LengthUnit unit_;
    double exaggeration_;
    BarPosition colour_bar_;
    bool velocity_;
    SectionArrows arrows_;
    SectionQuantity quantity_ = SectionQuantity::speed;
    ColourScale scale_;
};

/// Lines along the bed, or of its grains, with the bed behind them where they share its x.
class SectionLinePanel : public PanelContent {
  public:
    SectionLinePanel(const Snapshot& snapshot, SectionPanel panel)
        : snapshot_(snapshot),
          air_(snapshot_),
          unit_(length_unit(true, air_.length())),
          panel_(panel),
          plot_(plot_of(snapshot_, panel, unit_)) {}

    [[nodiscard]] PanelMargins margins(const Canvas& canvas, double width,
                                       double height) const override {
        return plot_.margins(canvas, width, height);
    }

    void draw(Canvas& canvas, const CanvasBox& frame) const override {
        const AxisRange x{plot_.plot().x.low.value_or(0.0), plot_.plot().x.high.value_or(1.0), ""};
        if (panel_ == SectionPanel::paths) {
            const AxisRange z{plot_.plot().y.low.value_or(0.0), plot_.plot().y.high.value_or(1.0),
                              ""};
            draw_section_bed(canvas, {frame, x, z}, unit_.length, air_);
        }
        if (panel_ == SectionPanel::stress || panel_ == SectionPanel::flights) {
            const double highest = highest_bed(snapshot_) / unit_.length;
            const AxisRange z{0.0, highest / bed_share, ""};
            if (highest > 0.0) draw_section_bed(canvas, {frame, x, z}, unit_.length, air_);
        }
        plot_.draw(canvas, frame);
    }

  private:
    static Plot plot_of(const Snapshot& snapshot, SectionPanel panel, const LengthUnit& unit) {
        switch (panel) {
            case SectionPanel::flights:
                return flights_plot(snapshot, unit);
            case SectionPanel::flight_law:
                return flight_law_plot(snapshot, unit);
            case SectionPanel::paths:
                return paths_plot(snapshot, unit);
            default:
                return stress_plot(snapshot, unit);
        }
    }

    Snapshot snapshot_;
    SectionAir air_;
    LengthUnit unit_;
    SectionPanel panel_;
    PlotPanel plot_;
};

}  // namespace

std::vector<SectionPanel> section_panels(const SectionSettings& settings,
                                         const Snapshot& snapshot) {
    std::vector<SectionPanel> panels;
    if (settings.panels.empty()) {
        for (const auto panel :
             {SectionPanel::velocity, SectionPanel::pressure, SectionPanel::stress}) {
            if (gives(snapshot, panel)) panels.push_back(panel);
        }
        return panels;
    }
    for (const std::string& wanted : settings.panels) {
        const PanelName* named = find_named(panel_names, wanted);
        if (named == nullptr) {
            throw KeyError("section.panels",
                           fmt::format("section.panels has no \"{}\"; take velocity, pressure, "
                                       "stress, flights, flight-law or paths",
                                       wanted));
        }
        if (!gives(snapshot, named->panel)) {
            throw KeyError("section.panels",
                           fmt::format("section.panels: the model has no \"{}\" (flights and "
                                       "paths need model.flights = true)",
                                       wanted));
        }
        panels.push_back(named->panel);
    }
    return panels;
}

std::string section_title(SectionPanel panel) {
    return word(find_by(panel_names, &PanelName::panel, panel)->title);
}

double section_exaggeration(const Snapshot& snapshot) {
    const SectionAir air(snapshot);
    const double aspect = air.length() / air.height();
    if (!(aspect > longest_equal_scale_ratio)) return 1.0;
    return std::max(1.0, round_length(aspect / shortest_exaggerated_ratio));
}

ColourScale section_colours(const View& view, const Snapshot& snapshot, SectionPanel panel) {
    return scale_of(view, SectionAir(snapshot), panel);
}

std::unique_ptr<PanelContent> make_section_panel(const View& view, const Snapshot& snapshot,
                                                 SectionPanel panel, BarPosition colour_bar) {
    if (panel == SectionPanel::velocity || panel == SectionPanel::pressure)
        return std::make_unique<SectionMapPanel>(view, snapshot, panel, colour_bar);
    return std::make_unique<SectionLinePanel>(snapshot, panel);
}

}  // namespace fumon
