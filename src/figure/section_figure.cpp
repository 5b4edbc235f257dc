#include "figure/section_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "figure/section_map.h"
#include "figure/section_paths.h"
#include "support/error.h"
#include "terrain/elementary_power.h"

namespace fumon {

namespace {

struct PanelName {
    SectionPanel panel;
    const char* name;
    const char* title;
};

constexpr std::array<PanelName, 6> panel_names{
    {{SectionPanel::velocity, "velocity", "Velocity of the air"},
     {SectionPanel::pressure, "pressure", "Pressure"},
     {SectionPanel::stress, "stress", "Shear stress"},
     {SectionPanel::flights, "flights", "Flight length"},
     {SectionPanel::flight_law, "flight-law", "Flight length and height"},
     {SectionPanel::paths, "paths", "Paths of grains"}}};

constexpr double room_of_heading = 2.0;  // font sizes
constexpr double room_above = 1.9;
constexpr double room_right = 2.0;  // half a tick label and a little

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

bool is_map(SectionPanel panel) {
    return panel == SectionPanel::velocity || panel == SectionPanel::pressure;
}

/// Panels in rows and columns: the size of one panel's frame.
struct Arrangement {
    int columns = 1;
    double cell_width = 0.0;
    double cell_height = 0.0;
    double frame_width = 0.0;  ///< that the room allows
    double frame_height = 0.0;
    double map_width = 0.0;  ///< with the maps' scales
    double map_height = 0.0;
    double exaggeration = 1.0;
};

/// The map's size in a frame: equal scales where these fill at least half of the frame's height.
void fit_map(Arrangement& arrangement, double aspect) {
    const double equal_height = arrangement.frame_width * aspect;
    arrangement.map_width = arrangement.frame_width;
    arrangement.map_height = std::min(equal_height, arrangement.frame_height);
    if (equal_height > arrangement.frame_height) {
        arrangement.map_width = arrangement.frame_height / aspect;
        return;
    }
    if (2.0 * equal_height >= arrangement.frame_height) return;
    const double largest = arrangement.frame_height / equal_height;
    const double power = elementary::pow(10.0, std::floor(elementary::log10(largest)));
    const double step = largest >= 5.0 * power ? 5.0 : largest >= 2.0 * power ? 2.0 : 1.0;
    const double exaggeration = step * power;
    arrangement.exaggeration = exaggeration;
    arrangement.map_height = exaggeration * equal_height;
}

Arrangement arrange(const ImageSettings& image, double font, double aspect,
                    const std::vector<SectionPanel>& panels) {
    const int count = static_cast<int>(panels.size());
    const auto maps = static_cast<int>(std::count_if(panels.begin(), panels.end(), is_map));
    Arrangement best;
    double best_area = -1.0;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        Arrangement one;
        one.columns = columns;
        one.cell_width = static_cast<double>(image.width) / columns;
        one.cell_height = (static_cast<double>(image.height) - room_of_heading * font) / rows;
        one.frame_width =
            one.cell_width -
            (Axes::room_left + room_right + (maps > 0 ? colour_bar_room : 0.0)) * font;
        one.frame_height = one.cell_height - (room_above + Axes::room_below + 0.4) * font;
        if (one.frame_width < 6.0 * font || one.frame_height < 3.0 * font) continue;
        fit_map(one, aspect);
        if (maps > 0 && one.map_width < 6.0 * font) continue;
        const bool aligned = columns == 1 && maps > 0;
        const double line_width = aligned ? one.map_width : one.frame_width;
        const double area = maps * one.map_width * one.map_height +
                            0.5 * (count - maps) * line_width * one.frame_height;
        if (area > best_area) {
            best = one;
            best_area = area;
        }
    }
    if (best_area < 0.0) best.frame_width = -1.0;
    return best;
}

/// Draws one figure: its canvas and what all panels share.
class Drawing {
  public:
    Drawing(const View& view, const Snapshot& snapshot, std::vector<SectionPanel> panels,
            double font, const Arrangement& arrangement)
        : view_(view),
          snapshot_(snapshot),
          air_(snapshot),
          panels_(std::move(panels)),
          arrangement_(arrangement),
          canvas_(static_cast<int>(view.image.width), static_cast<int>(view.image.height), font),
          unit_(air_.length() < 1.0 ? 1e-3 : 1.0),
          symbol_(unit_ < 1.0 ? "mm" : "m") {}

    SectionFigure draw() {
        const double font = canvas_.font_size();
        const auto step = snapshot_.time_unit == "steps"
                              ? fmt::format("step {}", snapshot_.step)
                              : fmt::format("step {}, t = {:.4g} {}", snapshot_.step,
                                            snapshot_.time, snapshot_.time_unit);
        write_within(canvas_, step, static_cast<double>(view_.image.width) - 2.0 * font,
                     {0.5 * static_cast<double>(view_.image.width), 0.5 * font}, {0.5, 0.0}, 1.1);
        for (std::size_t i = 0; i < panels_.size(); ++i)
            draw_panel(panels_[i], static_cast<int>(i));
        return {canvas_.image(), canvas_.texts(), frames_, arrangement_.exaggeration};
    }

  private:
    CanvasBox frame_at(int place, double width, double height) {
        const double font = canvas_.font_size();
        const int column = place % arrangement_.columns;
        const int row = place / arrangement_.columns;
        const double x = column * arrangement_.cell_width + Axes::room_left * font + 0.4 * font +
                         0.5 * (arrangement_.frame_width - width);
        const double y = (room_of_heading + room_above) * font + row * arrangement_.cell_height +
                         0.5 * (arrangement_.frame_height - height);
        const CanvasBox frame{std::round(x), std::round(y), std::floor(width), std::floor(height)};
        frames_.push_back(frame);
        return frame;
    }

    void write_title(const CanvasBox& frame, const std::string& title, double taken) {
        const double font = canvas_.font_size();
        write_within(canvas_, title, frame.width - taken - 0.5 * font,
                     {frame.x, frame.y - 0.8 * font}, {0.0, 0.5}, 1.0);
    }

    void draw_panel(SectionPanel panel, int place) {
        if (is_map(panel)) return draw_map(panel, place);
        draw_lines(panel, place);
    }

    void draw_map(SectionPanel panel, int place) {
        const Axes axes(frame_at(place, arrangement_.map_width, arrangement_.map_height),
                        {0.0, air_.length() / unit_, fmt::format("x ({})", symbol_)},
                        {0.0, air_.height() / unit_, fmt::format("z ({})", symbol_)});
        const bool velocity = panel == SectionPanel::velocity;
        const MapQuantity quantity =
            velocity ? static_cast<MapQuantity>(view_.section.colour_by) : MapQuantity::pressure;
        const WordOrReal automatic{"auto", 0.0};
        const ColourScale scale =
            map_scale(air_, quantity, view_.look, velocity ? view_.section.low : automatic,
                      velocity ? view_.section.high : automatic);
        draw_section_map(canvas_, axes, unit_, air_, quantity, scale);
        double taken = 0.0;
        if (velocity) {
            taken = draw_section_flow(canvas_, axes, unit_, air_, view_.section.arrows);
            draw_section_bed(canvas_, axes, unit_, air_);
        }
        axes.draw(canvas_);
        draw_colour_bar(canvas_, axes.frame(), scale);
        write_title(axes.frame(), title_of(panel), taken);
    }

    void draw_lines(SectionPanel kind, int place) {
        const LinePanel panel = lines_of(kind);
        const bool maps = std::any_of(panels_.begin(), panels_.end(), is_map);
        const double width =
            arrangement_.columns == 1 && maps ? arrangement_.map_width : arrangement_.frame_width;
        const Axes axes(frame_at(place, width, arrangement_.frame_height), panel.x, panel.y);
        if (kind == SectionPanel::paths) draw_section_bed(canvas_, axes, unit_, air_);
        if (kind == SectionPanel::stress || kind == SectionPanel::flights) draw_profile(axes);
        draw_series(canvas_, axes, panel.series);
        axes.draw(canvas_);
        const double font = canvas_.font_size();
        const double legend =
            draw_legend(canvas_, axes, panel.series, 0.6 * axes.frame().width - font);
        const bool beside = kind == SectionPanel::stress || kind == SectionPanel::flights;
        write_title(axes.frame(), std::string(title_of(kind)) + (beside ? " over the bed" : ""),
                    legend);
    }

    /// The bed along a panel's foot, a quarter of it high, behind its lines.
    void draw_profile(const Axes& axes) {
        const double highest =
            *std::max_element(snapshot_.bed.values().begin(), snapshot_.bed.values().end()) *
            snapshot_.scale.height_unit / unit_;
        if (!(highest > 0.0)) return;
        const Axes behind(axes.frame(), axes.x(), {0.0, 4.0 * highest, ""});
        draw_section_bed(canvas_, behind, unit_, air_);
    }

    [[nodiscard]] LinePanel lines_of(SectionPanel panel) const {
        switch (panel) {
            case SectionPanel::flights:
                return flights_panel(snapshot_, unit_, symbol_);
            case SectionPanel::flight_law:
                return flight_law_panel(snapshot_, unit_, symbol_);
            case SectionPanel::paths:
                return paths_panel(snapshot_, unit_, symbol_);
            default:
                return stress_panel(snapshot_, unit_, symbol_);
        }
    }

    [[nodiscard]] std::string title_of(SectionPanel panel) const {
        const auto named = std::find_if(panel_names.begin(), panel_names.end(),
                                        [&](const PanelName& name) { return name.panel == panel; });
        if (!is_map(panel) || arrangement_.exaggeration == 1.0) return named->title;
        return fmt::format("{}, heights × {:g}", named->title, arrangement_.exaggeration);
    }

    const View& view_;
    const Snapshot& snapshot_;
    SectionAir air_;
    std::vector<SectionPanel> panels_;
    Arrangement arrangement_;
    Canvas canvas_;
    double unit_;
    std::string symbol_;
    std::vector<CanvasBox> frames_;
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
        const auto named = std::find_if(panel_names.begin(), panel_names.end(),
                                        [&](const PanelName& name) { return name.name == wanted; });
        if (named == panel_names.end()) {
            throw KeyError("section.panels",
                           fmt::format("section.panels has no \"{}\"; take velocity, pressure, "
                                       "stress, flights, flight-law or paths",
                                       wanted));
        }
        if (!gives(snapshot, named->panel)) {
            throw KeyError("section.panels",
                           fmt::format("section.panels: the model gives no \"{}\" (flights and "
                                       "paths need model.flights = true)",
                                       wanted));
        }
        panels.push_back(named->panel);
    }
    return panels;
}

SectionFigure draw_section_figure(const View& view, const Snapshot& snapshot) {
    std::vector<SectionPanel> panels = section_panels(view.section, snapshot);
    const SectionAir air(snapshot);
    const double aspect = air.length() > 0.0 ? air.height() / air.length() : 1.0;
    const double shorter = static_cast<double>(std::min(view.image.width, view.image.height));
    const WordOrReal& size = view.section.font_size;
    constexpr double points_per_inch = 72.0;
    double font =
        size.is_word() ? shorter / 36.0 : size.value * view.image.dots_per_inch / points_per_inch;
    Arrangement arrangement = arrange(view.image, font, aspect, panels);
    while (size.is_word() && arrangement.frame_width < 0.0 && font > 1.0) {
        font *= 0.9;
        arrangement = arrange(view.image, font, aspect, panels);
    }
    if (arrangement.frame_width < 0.0) {
        throw KeyError("section.font_size",
                       fmt::format("section.font_size = {:g} leaves no room for {} panels in {} x "
                                   "{} pixels; take a smaller one or \"auto\"",
                                   size.value, panels.size(), view.image.width, view.image.height));
    }
    return Drawing(view, snapshot, std::move(panels), font, arrangement).draw();
}

}  // namespace fumon
