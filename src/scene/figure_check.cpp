#include "scene/figure_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "scene/figure/chart_check.h"
#include "scene/figure/journals.h"
#include "scene/placeholders.h"
#include "scene/view/palette_names.h"

namespace fumon {

namespace {

class FigureCheck {
  public:
    FigureCheck(const Scene& scene, Faults& faults) : scene_(scene), faults_(faults) {}

    void check() const {
        check_formats();
        check_journal();
        const std::vector<PanelSettings>& panels = scene_.figure.panels;
        for (std::size_t p = 0; p < panels.size(); ++p) {
            const std::string path = fmt::format("figure.panel.{}", p);
            if (p == 0 && panels[p].inset != InsetCorner::none)
                refuse(path + ".inset",
                       "an inset lies in the panel before it, but this is the first panel");
            check_place(panels[p], path);
            check_keys_of_kind(panels[p], path);
            check_labels(panels[p], path);
            check_palette(panels[p], path);
            check_chart(panels[p], within(path));
            if (shown_by(panels[p].kind) == PanelShows::curves) {
                check_plot(panels[p], path);
            } else {
                check_picture(panels[p], path);
            }
        }
    }

  private:
    void refuse(const std::string& key, const std::string& what) const {
        faults_.add(InputError(place_of(key) + fmt::format("{}: {}", key, what)));
    }

    /// Refuses keys of a panel or curve.
    [[nodiscard]] ChartFault within(const std::string& path) const {
        return [this, path](const std::string& key, const std::string& what) {
            refuse(fmt::format("{}.{}", path, key), what);
        };
    }

    /// Where a key stands, else another key of its panel or curve.
    [[nodiscard]] std::string place_of(const std::string& key) const {
        if (scene_.locations.contains(key)) return scene_.at(key);
        const std::string owner = key.substr(0, key.rfind('.') + 1);
        const auto near = scene_.locations.lower_bound(owner);
        const bool found = near != scene_.locations.end() && near->first.starts_with(owner);
        return scene_.at(found ? near->first : key);
    }

    void check_formats() const {
        const std::vector<std::string>& formats = scene_.figure.formats;
        const std::vector<std::string> known{"pdf", "svg", "png", "tif", "eps"};
        if (formats.empty())
            refuse("figure.formats", "there is none; take pdf, svg, png, tif, eps");
        std::set<std::string> seen;
        for (const std::string& format : formats) {
            if (std::find(known.begin(), known.end(), format) == known.end()) {
                refuse("figure.formats",
                       fmt::format("unknown format \"{}\"; {}", format, suggestion(format, known)));
            }
            if (!seen.insert(format).second)
                refuse("figure.formats", fmt::format("\"{}\" occurs twice", format));
        }
    }

    void check_journal() const {
        const std::string& name = scene_.figure.journal;
        if (name.empty() || find_journal(name) != nullptr) return;
        refuse("figure.journal",
               fmt::format("unknown journal \"{}\"; {}", name, suggestion(name, journal_names())));
    }

    void check_place(const PanelSettings& panel, const std::string& path) const {
        if ((panel.row > 0) != (panel.column > 0)) {
            const std::string missing = panel.row > 0 ? ".column" : ".row";
            refuse(path + (panel.row > 0 ? ".row" : ".column"),
                   fmt::format("a position in the grid needs a row and a column; also give {}{}",
                               path, missing));
        }
        if (panel.inset != InsetCorner::none &&
            (panel.row > 0 || panel.rows > 1 || panel.columns > 1)) {
            refuse(path + ".inset",
                   "an inset has no position in the grid; drop row, column, rows and columns");
        }
    }

    void check_palette(const PanelSettings& panel, const std::string& path) const {
        if (panel.palette.empty()) return;
        try {
            check_palette_name(panel.palette);
        } catch (const InputError& unknown) {
            refuse(path + ".palette", unknown.what());
        }
    }

    /// In labels {unit} alone stands for something.
    void check_labels(const PanelSettings& panel, const std::string& path) const {
        const auto check = [&](const std::string& label, const char* key) {
            try {
                fill_placeholders(
                    label,
                    [](const std::string& name) {
                        return name == "unit" ? std::optional<std::string>("") : std::nullopt;
                    },
                    "{unit} stands for the unit");
            } catch (const InputError& fault) {
                refuse(path + key, fault.what());
            }
        };
        check(panel.x_label, ".x_label");
        check(panel.y_label, ".y_label");
        check(panel.bar_label, ".bar_label");
    }

    /// Refuses what a panel of this kind would not show.
    void check_keys_of_kind(const PanelSettings& panel, const std::string& path) const {
        using enum PanelKind;
        const std::vector<PanelKind> charts{plot, heat_map, scatter, histogram, box_plot};
        const std::vector<PanelKind> along_x{plot, scatter};
        const std::vector<PanelKind> scaled_x{plot, heat_map, scatter, histogram};
        const std::vector<PanelKind> up_y{plot, scatter, histogram, box_plot};
        const std::vector<PanelKind> pictures{map, view, profile, time_space, section, difference};
        const std::vector<PanelKind> stepped{map, view, profile, section, difference};
        const std::vector<PanelKind> from_low{map, view, time_space, section, heat_map, scatter};
        const std::vector<PanelKind> coloured{map,      view,    time_space, section,
                                              heat_map, scatter, difference};
        const std::vector<PanelKind> maps{map};
        const std::vector<PanelKind> views{view};
        const std::vector<PanelKind> with_coordinates{map, view};
        const std::vector<PanelKind> with_frame{map, difference};
        const std::vector<PanelKind> with_lines{map, view, heat_map};
        const std::vector<PanelKind> with_bar_label{map,      view,    time_space,
                                                    heat_map, scatter, difference};
        const std::vector<PanelKind> sharing{map, difference, heat_map, scatter};
        const std::vector<PanelKind> with_sides{map, difference, heat_map};
        const std::vector<PanelKind> heat_maps{heat_map};
        const std::vector<PanelKind> histograms{histogram};
        const std::vector<PanelKind> box_plots{box_plot};
        const std::vector<PanelKind> differences{difference};
        const ChartSettings& chart = panel.chart;
        const PanelSettings usual;
        struct Asked {
            const char* key;
            bool given;  ///< otherwise than it is where nothing is said
            const std::vector<PanelKind>& kinds;
        };
        const std::vector<PanelKind> along_rows{profile, time_space};
        const std::vector<PanelKind> of_fields{map, time_space, difference};
        const std::vector<PanelKind> with_ground{map, view, difference};
        const std::vector<PanelKind> with_arrow{map, view, profile};
        const std::vector<PanelKind> over_time{time_space};
        const std::vector<PanelKind> with_axes{plot,    map,       profile,  time_space, heat_map,
                                               scatter, histogram, box_plot, difference};
        const std::vector<PanelKind> sections{section};
        const std::vector<Asked> all{
            {"x_label", panel.x_label != usual.x_label, with_axes},
            {"y_label", panel.y_label != usual.y_label, with_axes},
            {"bar_label", panel.bar_label != usual.bar_label, with_bar_label},
            {"x_logarithmic", panel.x_logarithmic, scaled_x},
            {"y_logarithmic", panel.y_logarithmic, charts},
            {"x_low", panel.x_low != usual.x_low, along_x},
            {"x_high", panel.x_high != usual.x_high, along_x},
            {"y_low", panel.y_low != usual.y_low, up_y},
            {"y_high", panel.y_high != usual.y_high, up_y},
            {"legend", panel.legend != usual.legend, up_y},
            {"scene", panel.scene != usual.scene, pictures},
            {"set", panel.set != usual.set, pictures},
            {"steps", panel.steps != usual.steps, stepped},
            {"every", panel.every != usual.every, over_time},
            {"row_of_bed", panel.row_of_bed != usual.row_of_bed, along_rows},
            {"field", panel.field != usual.field, of_fields},
            {"low", is_given(panel.low), from_low},
            {"high", is_given(panel.high), coloured},
            {"palette", panel.palette != usual.palette, coloured},
            {"palette_reversed", panel.palette_reversed, coloured},
            {"shading", panel.shading != usual.shading, maps},
            {"shading_from_all_sides", panel.shading_from_all_sides, maps},
            {"axes", panel.axes != usual.axes, with_frame},
            {"contours", panel.contours != usual.contours, with_lines},
            {"coordinates", panel.coordinates, with_coordinates},
            {"colours", panel.colours != usual.colours, views},
            {"vectors", panel.vectors, maps},
            {"scale_bar", panel.scale_bar, with_ground},
            {"arrow", panel.arrow != usual.arrow, with_arrow},
            {"section", panel.section != usual.section, sections},
            {"cell_text", chart.cell_text != CellText::none, heat_maps},
            {"even_cells", chart.even_cells, heat_maps},
            {"levels", !chart.levels.empty(), heat_maps},
            {"classes", !chart.classes.empty(), heat_maps},
            {"bins", chart.bins > 0, histograms},
            {"bin_low", !chart.bin_low.is_word(), histograms},
            {"bin_high", !chart.bin_high.is_word(), histograms},
            {"bar_height", chart.bar_height != BarHeight::count, histograms},
            {"shape", chart.shape != DistributionShape::box, box_plots},
            {"show_values", chart.show_values, box_plots},
            {"name", !chart.name.empty(), differences},
            {"minus_name", !chart.minus_name.empty(), differences},
            {"minus_scene", !chart.minus_scene.empty(), differences},
            {"minus_set", !chart.minus_set.empty(), differences},
            {"minus_step", chart.minus_step >= 0, differences},
            {"share_axes", chart.share_axes, with_sides},
            {"share_colours", chart.share_colours, sharing}};
        for (const Asked& asked : all) {
            if (!asked.given || std::ranges::find(asked.kinds, panel.kind) != asked.kinds.end())
                continue;
            refuse(fmt::format("{}.{}", path, asked.key),
                   fmt::format("belongs to {}; a {} panel would not show it", names_of(asked.kinds),
                               word_of(panel.kind)));
        }
    }

    /// Whether an end of the colours is no word for what it is where nothing is said.
    static bool is_given(const WordOrReal& end) {
        return !end.is_word() || end.word == "percentile";
    }

    static std::string_view word_of(PanelKind kind) {
        return panel_kinds[static_cast<std::size_t>(kind)].choice.word;
    }

    /// "map and view panels".
    static std::string names_of(const std::vector<PanelKind>& kinds) {
        std::string names;
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            if (k > 0) names += k + 1 == kinds.size() ? " and " : ", ";
            names += word_of(kinds[k]);
        }
        return names + " panels";
    }

    void check_plot(const PanelSettings& panel, const std::string& path) const {
        if (panel.curves.empty() && panel.boxes.empty()) {
            refuse(path + ".kind", fmt::format("the {} shows nothing; add [[figure.panel.curve]]",
                                               word_of(panel.kind)));
        }
        check_range(panel.x_low, panel.x_high, path, "x", panel.x_logarithmic);
        check_range(panel.y_low, panel.y_high, path, "y", panel.y_logarithmic);
        for (std::size_t c = 0; c < panel.curves.size(); ++c)
            check_curve(panel, panel.curves[c], fmt::format("{}.curve.{}", path, c));
        for (std::size_t b = 0; b < panel.boxes.size(); ++b)
            check_box(panel, panel.boxes[b], fmt::format("{}.box.{}", path, b));
    }

    void check_range(const WordOrReal& low, const WordOrReal& high, const std::string& path,
                     const std::string& axis, bool logarithmic) const {
        const std::string dot = axis.empty() ? path + "." : path + "." + axis + "_";
        const auto above_zero = [&](const WordOrReal& end, const char* name) {
            if (logarithmic && !end.is_word() && end.value <= 0.0)
                refuse(dot + name, "a logarithmic axis takes only values above 0");
        };
        above_zero(low, "low");
        above_zero(high, "high");
        if (!low.is_word() && !high.is_word() && !(low.value < high.value)) {
            refuse(dot + "high",
                   fmt::format("{} must be above the low end {}", high.value, low.value));
        }
    }

    void check_curve(const PanelSettings& panel, const CurveSettings& curve,
                     const std::string& path) const {
        check_chart_curve(panel, curve, within(path));
        if (curve.table == CurveTable::expression) return;
        if (curve.y.empty()) refuse(path + ".y", "is missing; name the column to draw");
        if (curve.x.empty()) refuse(path + ".x", "is empty; name a column");
        const bool from_file = curve.table == CurveTable::file;
        if (from_file && curve.file.empty())
            refuse(path + ".file", "is missing; name the CSV file");
        if (!from_file && !curve.file.empty())
            refuse(path + ".file", "is given but not read; write table = \"file\"");
        if (from_file && (!curve.scene.empty() || !curve.set.empty() || !curve.over.empty() ||
                          curve.seeds > 0)) {
            refuse(path + ".table",
                   "a file has no runs; drop scene, set, over and seeds, or table = \"file\"");
        }
        if (curve.spread != CurveSpread::none && !curve.average)
            refuse(path + ".spread", "needs averages; write average = true");
        if (curve.least > 1 && !curve.average)
            refuse(path + ".least", "needs averages; write average = true");
        if (curve.fit == CurveFit::none && !(curve.fit_low.is_word() && curve.fit_high.is_word()))
            refuse(path + (curve.fit_low.is_word() ? ".fit_high" : ".fit_low"),
                   "there is no fit; write fit = \"line\" or another");
        check_range(curve.fit_low, curve.fit_high, path, "fit", curve.fit == CurveFit::power);
        const bool scaled_x = curve.scale_x != 1.0 && panel.x_label.empty();
        const bool scaled_y = curve.scale_y != 1.0 && panel.y_label.empty();
        if (scaled_x || scaled_y) {
            refuse(path + (scaled_x ? ".scale_x" : ".scale_y"),
                   fmt::format("the column's unit no longer applies; name the quantity and its new "
                               "unit with the panel's {}_label",
                               scaled_x ? "x" : "y"));
        }
    }

    void check_box(const PanelSettings& panel, const RangeBoxSettings& box,
                   const std::string& path) const {
        if (box.label.empty()) refuse(path + ".label", "is missing; name what lies in this range");
        if (box.source.empty())
            refuse(path + ".source", "is missing; name author and year, or leave the box out");
        if (!(box.x_low < box.x_high)) refuse(path + ".x_high", "must be above x_low");
        if (!(box.y_low < box.y_high)) refuse(path + ".y_high", "must be above y_low");
        if (panel.x_logarithmic && box.x_low <= 0.0)
            refuse(path + ".x_low", "a logarithmic axis takes only values above 0");
        if (panel.y_logarithmic && box.y_low <= 0.0)
            refuse(path + ".y_low", "a logarithmic axis takes only values above 0");
    }

    void check_picture(const PanelSettings& panel, const std::string& path) const {
        if (!panel.curves.empty())
            refuse(path + ".kind",
                   "curves belong to plots; write kind = \"plot\" or another with curves");
        if (!panel.boxes.empty())
            refuse(path + ".kind", "boxes belong to plots; write kind = \"plot\"");
        check_range(panel.low, panel.high, path, "", false);
        if (panel.kind == PanelKind::section) {
            for (const auto& [end, name] : {std::pair{&panel.low, "low"}, {&panel.high, "high"}}) {
                if (end->word == "percentile")
                    refuse(fmt::format("{}.{}", path, name),
                           "a section shows all its values; write \"auto\" or a number");
            }
        }
        const bool also_north = panel.arrow == PanelArrow::north ||
                                panel.arrow == PanelArrow::wind_and_north ||
                                panel.arrow == PanelArrow::flow_and_north;
        if (panel.kind == PanelKind::profile && also_north)
            refuse(path + ".arrow", "a profile has no north; take \"wind\"");
        if (panel.inset != InsetCorner::none && panel.steps.size() > 1)
            refuse(path + ".steps", "an inset shows one step");
        const PanelShows shows = shown_by(panel.kind);
        if (shows == PanelShows::each_step && panel.row > 0 && panel.steps.size() > 1)
            refuse(path + ".row", "several steps are several panels; place them in reading order");
    }

    const Scene& scene_;
    Faults& faults_;
};

}  // namespace

void check_figure(const Scene& scene, Faults& faults) {
    if (!scene.figure.panels.empty()) FigureCheck(scene, faults).check();
}

}  // namespace fumon
