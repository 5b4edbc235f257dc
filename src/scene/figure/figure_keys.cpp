#include "scene/figure/figure_keys.h"

#include "base/limits.h"
#include "scene/figure/chart_keys.h"

namespace fumon {

namespace {

void list_curve_data_keys(CurveSettings& curve, const std::string& path, KeyTable& table) {
    table.text(path + ".name", curve.name,
               {.help = "in the legend; {column} or {key} stands for a value; empty: none, or with "
                        "group_by its name and value"});
    table.choice(
        path + ".table", curve.table,
        {{CurveTable::measurements, "measurements",
          "measurements.csv of the run, or of every run of the sweep"},
         {CurveTable::avalanches, "avalanches", "a row an avalanche"},
         {CurveTable::avalanche_sizes, "avalanche-sizes",
          "how often each size came: size, avalanches, share"},
         {CurveTable::profile, "profile",
          "along the bed's middle row: x, height, every field, and water_level over water"},
         {CurveTable::section, "section",
          "along the profile under the air: x, bed and the section's curves"},
         {CurveTable::flights, "flights", "a row a grain's flight"},
         {CurveTable::file, "file", "a CSV file"},
         {CurveTable::expression, "expression", "no rows: a formula, as of a theory"}},
        {.help = "which rows it is drawn from"});
    table.text(path + ".scene", curve.scene,
               {.help = "another scene's file, relative to this one; empty: this scene"});
    table.text_list(path + ".set", curve.set, {.help = "\"key=value\": changes to the scene"});
    table.text_list(
        path + ".over", curve.over,
        {.help = "what varies, as in sweep.over; empty: the scene's own; \"none\": nothing"});
    table.integer(path + ".seeds", curve.seeds,
                  {.unit = "seeds", .range = {0, 1e6}, .help = "0: the scene's own sweep.seeds"});
    table.text(path + ".file", curve.file, {.help = "the CSV file, relative to the scene"});
    table.integer(path + ".step", curve.step,
                  {.unit = "steps",
                   .range = {-1, largest_step},
                   .help = "profile, section, flights: of this step; -1: the last"});
    table.text(path + ".x", curve.x, {.help = "column along the plot"});
    table.text(path + ".y", curve.y, {.help = "column up the plot"});
    table.text(path + ".z", curve.z,
               {.help = "column of the colours, in heat-map and scatter panels"});
    table.text(path + ".expression", curve.expression,
               {.help = "y as a formula of x: + - * / ^, parentheses, sqrt, exp, ln, log10, sin, "
                        "cos, tan, tanh, atan, abs, pi, e and the constants"});
    table.text_list(path + ".constants", curve.constants,
                    {.help = "\"name = number\", each a constant of the formula"});
    table.word_or_real(path + ".x_from", curve.x_from,
                       {{"auto", "where the panel's other curves begin, or its axis"}},
                       {.help = "x where a formula's line begins"});
    table.word_or_real(path + ".x_to", curve.x_to, {{"auto", "where they end"}},
                       {.help = "x where it ends"});
    table.text_list(
        path + ".where", curve.where,
        {.help = "rows to draw: \"column=value\", \"column>=value\", \"column<value\" …"});
    table.text(path + ".group_by", curve.group_by,
               {.help = "a curve for each value of this column, such as a varied key"});
    table.boolean(path + ".average", curve.average,
                  {.help = "rows with the same x (of several seeds) become one point, their mean"});
    table.integer(path + ".least", curve.least,
                  {.unit = "runs",
                   .range = {1, 1e9},
                   .help = "points of fewer runs (of a file: rows) are left out; points of fewer "
                           "runs than others are hollow"});
}

void list_curve_keys(CurveSettings& curve, const std::string& path, KeyTable& table) {
    list_curve_data_keys(curve, path, table);
    table.choice(path + ".spread", curve.spread,
                 {{CurveSpread::none, "none", "no bars"},
                  {CurveSpread::deviation, "deviation", "standard deviation of what is averaged"},
                  {CurveSpread::standard_error, "standard-error", "of the mean"}},
                 {.help = "error bars"});
    table.choice(path + ".bars", curve.bars,
                 {{SpreadLook::bars, "bars", "a bar at each point"},
                  {SpreadLook::band, "band", "a shaded band along the curve"}},
                 {.help = "how spread is drawn"});
    table.real(path + ".offset_y", curve.offset_y,
               {.help = "added to y, before scale_y; such as minus the mean height"});
    table.real(path + ".scale_x", curve.scale_x, {.help = "x times this, such as metres per site"});
    table.real(path + ".scale_y", curve.scale_y, {.help = "y times this"});
    table.choice(path + ".fit", curve.fit,
                 {{CurveFit::none, "none", "no fit"},
                  {CurveFit::line, "line", "y = a + b x"},
                  {CurveFit::power, "power", "y = a x^b, a line in the logarithms"},
                  {CurveFit::exponential, "exponential", "y = a exp(b x), a line in ln y"},
                  {CurveFit::hop, "hop", "y = a^x - 1, the hop law, lengths in mm"},
                  {CurveFit::cosine, "cosine",
                   "y = a + b cos(2 pi x / length + c), over the curve's length"}},
                 {.help = "least squares; drawn, and written with its R² in the legend"});
    table.word_or_real(path + ".fit_low", curve.fit_low, {{"auto", "from the first point"}},
                       {.help = "lower end of the x that are fitted"});
    table.word_or_real(path + ".fit_high", curve.fit_high, {{"auto", "to the last point"}},
                       {.help = "upper end"});
    table.choice(path + ".style", curve.style,
                 {{CurveStyle::automatic, "auto",
                   "a line for many points, points with a line for few, points for a fit"},
                  {CurveStyle::line, "line", "a line"},
                  {CurveStyle::points, "points", "points"},
                  {CurveStyle::line_and_points, "line-and-points", "both"},
                  {CurveStyle::steps, "steps", "steps"}},
                 {.help = "how it is drawn"});
    table.integer(path + ".colour", curve.colour,
                  {.range = {0, 8}, .help = "number in the colour cycle; 0: the next"});
}

void list_box_keys(RangeBoxSettings& box, const std::string& path, KeyTable& table) {
    table.text(path + ".label", box.label, {.help = "what lies in this range"});
    table.text(path + ".source", box.source, {.help = "author and year, for the caption"});
    table.real(path + ".x_low", box.x_low, {.help = "left end"});
    table.real(path + ".x_high", box.x_high, {.help = "right end"});
    table.real(path + ".y_low", box.y_low, {.help = "lower end"});
    table.real(path + ".y_high", box.y_high, {.help = "upper end"});
}

void list_place_keys(PanelSettings& panel, const std::string& path, KeyTable& table) {
    table.choice(path + ".kind", panel.kind, choices_of(panel_kinds),
                 {.help = "what the panel shows"});
    table.text(
        path + ".title", panel.title,
        {.help = "above it; {step}, {time}, {time:h}, {seed} and {model.creep_rate} "
                 "stand for values; x^{2} raises and A_{s} lowers letters, here and in all texts"});
    table.integer(path + ".row", panel.row,
                  {.range = {0, 100}, .help = "in the grid of panels, from 1; 0: reading order"});
    table.integer(path + ".column", panel.column,
                  {.range = {0, 100}, .help = "in the grid of panels, from 1; 0: reading order"});
    table.integer(path + ".rows", panel.rows, {.range = {1, 100}, .help = "rows that it spans"});
    table.integer(path + ".columns", panel.columns,
                  {.range = {1, 100}, .help = "columns that it spans"});
    table.choice(path + ".inset", panel.inset,
                 {{InsetCorner::none, "none", "a panel of its own"},
                  {InsetCorner::upper_left, "upper-left", "in the panel before it"},
                  {InsetCorner::upper_right, "upper-right", "in the panel before it"},
                  {InsetCorner::lower_left, "lower-left", "in the panel before it"},
                  {InsetCorner::lower_right, "lower-right", "in the panel before it"}},
                 {.help = "whether it stands within the panel before it"});
    table.real(path + ".inset_size", panel.inset_size,
               {.range = {0.1, 0.9}, .help = "share of that panel's frame, along both sides"});
}

void list_view_panel_keys(PanelSettings& panel, const std::string& path, KeyTable& table) {
    table.choice(
        path + ".relief", panel.relief,
        {{PanelRelief::clear, "clear",
          "look.relief = \"clear\" with a thin block; the sun across the crests unless the "
          "scene sets another, and the exaggeration that shows the relief unless "
          "look.exaggeration is a number"},
         {PanelRelief::scene, "scene",
          "light, exaggeration and block of the scene's frames in look.mode = "
          "\"figure\""}},
        {.help = "how a view shows heights", .earlier = {"0.3.0", "\"scene\""}});
    table.choice(path + ".colours", panel.colours,
                 {{PanelColouring::automatic, "auto",
                   "as look.colour_by says; where that is \"natural\", plain"},
                  {PanelColouring::plain, "plain", "one pale colour, shaded"},
                  {PanelColouring::height, "height", "by height, with a colour bar"}},
                 {.help = "of a view of the bed with relief = \"clear\""});
}

void list_picture_keys(PanelSettings& panel, const std::string& path, KeyTable& table) {
    table.text(path + ".scene", panel.scene,
               {.help = "another scene's file, relative to this one; empty: this scene"});
    table.text_list(path + ".set", panel.set, {.help = "\"key=value\": changes to the scene"});
    table.integer_list(path + ".steps", panel.steps,
                       {.unit = "steps",
                        .range = {0, largest_step},
                        .help = "a picture for each; in one panel for a profile; empty: the last"});
    table.integer(path + ".every", panel.every,
                  {.unit = "steps",
                   .range = {0, largest_step},
                   .help = "between the lines of a time-space panel; 0: a 200th of the run"});
    table.word_or_real(path + ".row_of_bed", panel.row_of_bed,
                       {{"middle", "the row in the middle"}, {"mean", "the mean over the rows"}},
                       {.unit = "cells",
                        .range = {0, largest_grid_side},
                        .help = "of a profile or time-space panel, counted from the south"});
    table.text(path + ".field", panel.field,
               {.help = "bed, change (since the start), or a field of the model: water_depth …"});
    table.choice(path + ".range", panel.range,
                 {{PanelRange::shared, "shared", "one range for all steps"},
                  {PanelRange::own, "own", "each step its own"}},
                 {.help = "of the colours, where low and high are auto"});
    const KeyWord previous{
        "auto-0.2",
        "what auto was in version 0.2: percentile for bed, change and water_depth "
        "of maps and time-space panels, without a word on values beyond"};
    table.word_or_real(
        path + ".low", panel.low,
        {{"auto", "the least value that is shown; for change as far below 0 as high is above"},
         {"percentile", "the value below which 0.5 % of the cells lie"},
         previous},
        {.help = "value at the palette's start; where values lie below, the bar ends in a triangle",
         .earlier = {"0.3.0", "\"auto-0.2\""}});
    table.word_or_real(
        path + ".high", panel.high,
        {{"auto", "the greatest value that is shown"},
         {"percentile", "the value above which 0.5 % of the cells lie"},
         previous},
        {.help = "value at its end; likewise", .earlier = {"0.3.0", "\"auto-0.2\""}});
    table.text(path + ".palette", panel.palette, {.help = "empty: the scene's look.palette"});
    table.boolean(path + ".palette_reversed", panel.palette_reversed,
                  {.help = "reversed; without a palette of its own, the opposite of the scene's"});
    table.real(path + ".shading", panel.shading,
               {.range = {0, 1}, .help = "hill shading of a map; 0: the colours alone"});
    table.boolean(path + ".shading_from_all_sides", panel.shading_from_all_sides,
                  {.help = "hill shading by light from four sides, so that no crest lies along it; "
                           "false: from the north-west"});
    table.word_or_real(path + ".contours", panel.contours,
                       {{"none", "no lines"}, {"auto", "a round interval: up to 16 lines"}},
                       {.unit = "m",
                        .range = {0, 1e6, true},
                        .help = "interval of contour lines on a map or view, every fifth labelled; "
                                "in model heights where there are no metres; on a heat map in the "
                                "unit of its colours"});
    list_view_panel_keys(panel, path, table);
    table.boolean(path + ".axes", panel.axes, {.help = "ticks and labels around a map"});
    table.boolean(path + ".coordinates", panel.coordinates,
                  {.help = "the coordinates of the terrain's file: in place of x and y around a "
                           "map, and along the edges of a view's block"});
    table.boolean(path + ".colour_bar", panel.colour_bar,
                  {.help = "beside the last of the panel's pictures, where colours mean numbers"});
    table.boolean(path + ".scale_bar", panel.scale_bar,
                  {.help = "in a map (of the first step) or view"});
    table.boolean(path + ".vectors", panel.vectors,
                  {.help = "arrows of the water's velocity on a map"});
    table.choice(path + ".arrow", panel.arrow,
                 {{PanelArrow::none, "none", "none"},
                  {PanelArrow::wind, "wind", "along the wind, +x"},
                  {PanelArrow::flow, "flow", "down the slope, -y"},
                  {PanelArrow::north, "north", "to the north, +y"},
                  {PanelArrow::wind_and_north, "wind-and-north", "both"},
                  {PanelArrow::flow_and_north, "flow-and-north", "both"}},
                 {.help = "an arrow in the corner of a map (of the first step) or view; of a "
                          "profile, the wind's"});
    table.boolean(path + ".crests", panel.crests,
                  {.help = "lines through a map's middle: along its crests (unbroken), and along "
                           "those that the bed instability predicts of its winds (broken)"});
    table.real(path + ".flux_ratio", panel.flux_ratio,
               {.range = {0, 100},
                .help = "gamma of that prediction: how much more sand moves over a crest across "
                        "the wind than over flat ground"});
    table.text(path + ".section", panel.section,
               {.help = "velocity, pressure, stress, flights, flight-law or paths"});
}

void list_panel_keys(PanelSettings& panel, const std::string& path, KeyTable& table) {
    list_place_keys(panel, path, table);
    list_picture_keys(panel, path, table);
    constexpr const char* label =
        "beside the axis, in any language, {unit} for its unit; empty: what runs along it, and its "
        "unit";
    table.text(path + ".x_label", panel.x_label, {.help = label});
    table.text(path + ".y_label", panel.y_label, {.help = label});
    table.text(path + ".bar_label", panel.bar_label,
               {.help = "beside the colour bar, likewise; empty: the quantity and its unit"});
    table.boolean(path + ".x_logarithmic", panel.x_logarithmic, {.help = "logarithmic x axis"});
    table.boolean(path + ".y_logarithmic", panel.y_logarithmic, {.help = "logarithmic y axis"});
    table.word_or_real(path + ".x_low", panel.x_low, {{"auto", "from the data"}},
                       {.help = "start of the x axis"});
    table.word_or_real(path + ".x_high", panel.x_high, {{"auto", "from the data"}},
                       {.help = "end of the x axis"});
    table.word_or_real(path + ".y_low", panel.y_low, {{"auto", "from the data"}},
                       {.help = "start of the y axis"});
    table.word_or_real(path + ".y_high", panel.y_high, {{"auto", "from the data"}},
                       {.help = "end of the y axis"});
    table.choice(path + ".legend", panel.legend,
                 {{PanelLegend::automatic, "auto", "in the emptiest corner"},
                  {PanelLegend::none, "none", "no legend"},
                  {PanelLegend::outside, "outside", "right of the frame"},
                  {PanelLegend::upper_left, "upper-left", "the upper left corner"},
                  {PanelLegend::upper_right, "upper-right", "the upper right corner"},
                  {PanelLegend::lower_left, "lower-left", "the lower left corner"},
                  {PanelLegend::lower_right, "lower-right", "the lower right corner"}},
                 {.help = "where the curves' names stand"});
    list_chart_keys(panel.chart, path, table);
    table.tables(path + ".curve", panel.curves, "a curve of the plot", list_curve_keys);
    table.tables(path + ".box", panel.boxes, "a labelled range in the plot", list_box_keys);
}

void list_one_overlay(OverlaySettings& overlay, const std::string& path, KeyTable& table) {
    table.choice(path + ".kind", overlay.kind, choices_of(overlay_kinds),
                 {.help = "what is drawn over the frames"});
    table.boolean(path + ".show", overlay.show, {.help = "false switches it off"});
    table.choice(path + ".corner", overlay.corner,
                 {{OverlayCorner::upper_left, "upper-left", "the upper left corner"},
                  {OverlayCorner::upper_middle, "upper-middle", "the middle of the upper edge"},
                  {OverlayCorner::upper_right, "upper-right", "the upper right corner"},
                  {OverlayCorner::lower_left, "lower-left", "the lower left corner"},
                  {OverlayCorner::lower_middle, "lower-middle", "the middle of the lower edge"},
                  {OverlayCorner::lower_right, "lower-right", "the lower right corner"}},
                 {.help = "where it is placed; several in one corner are stacked"});
    table.text(path + ".text", overlay.text,
               {.help = "title, time; plot: its heading; colour-bar: what it shows. {title}, "
                        "{step}, {time}, {time:h}, {seed} and "
                        "{model.creep_rate} stand for values; empty: as usual"});
    table.text_list(
        path + ".keys", overlay.keys,
        {.help = "parameters: the keys that are shown; empty: the model's that are written"});
    table.text(path + ".x", overlay.x, {.help = "plot: column of the measurements along it"});
    table.text(path + ".y", overlay.y, {.help = "plot: column up it"});
    table.word_or_real(path + ".low", overlay.low, {{"auto", "0, or below the values so far"}},
                       {.help = "plot: lower end of its axis"});
    table.word_or_real(path + ".high", overlay.high, {{"auto", "grows with them by round steps"}},
                       {.help = "plot: upper end"});
    table.real(path + ".size", overlay.size,
               {.range = {0.05, 0.9},
                .help = "plot, colour bar: share of the picture's width; inset-map: of its shorter "
                        "side"});
    table.word_or_real(
        path + ".font_size", overlay.font_size,
        {{"auto", "a 36th of the picture's shorter side, at least 10; smaller to fit"}},
        {.unit = "pixels", .range = {4, 1000}, .help = "of its text"});
    table.real(path + ".opacity", overlay.opacity,
               {.range = {0, 1}, .help = "of the plate behind it; 0: no plate"});
    table.choice(
        path + ".ink", overlay.ink,
        {{OverlayInk::black, "black", "on a white plate"},
         {OverlayInk::white, "white", "on a black plate; without one, with a soft shadow"}},
        {.help = "colour of letters and lines, where no colours mean anything: not of "
                 "colour bars, plots, maps and legends"});
}

}  // namespace

void list_figure_keys(FigureSettings& figure, KeyTable& table) {
    table.role(KeyRole::figure);
    table.word_or_real("figure.width", figure.width,
                       {{"single", "85 mm, one column of a journal"},
                        {"double", "175 mm, both columns"},
                        {"slide", "254 mm; 142.9 mm high, 16:9"}},
                       {.unit = "mm", .range = {20, 2000}, .help = "of the page"});
    table.word_or_real("figure.height", figure.height,
                       {{"auto", "as high as its panels need; 142.9 mm for a slide"}},
                       {.unit = "mm", .range = {20, 2000}, .help = "of the page"});
    table.integer("figure.columns", figure.columns,
                  {.range = {0, 100}, .help = "of the grid of panels; 0: by their number"});
    table.real("figure.font_size", figure.font_size,
               {.unit = "points", .range = {3, 100}, .help = "of labels; others follow"});
    table.real("figure.line_width", figure.line_width,
               {.unit = "points", .range = {0.05, 20}, .help = "of curves; others follow"});
    table.boolean("figure.letters", figure.letters, {.help = "(a), (b) … before the titles"});
    table.real("figure.dots_per_inch", figure.dots_per_inch,
               {.range = {50, 1200}, .help = "of pictures in the page, and of its PNG"});
    table.text_list("figure.formats", figure.formats, {.help = "pdf, svg, png, tif, eps"});
    table.choice<SvgText>(
        "figure.svg_text", figure.svg_text,
        {{SvgText::outlines, "outlines", "shapes, which look the same everywhere"},
         {SvgText::text, "text",
          "text in DejaVu Sans, to select, search and edit; above all else"}},
        {.help = "letters of the figure's SVG"});
    table.text(
        "figure.language", figure.language,
        {.help = "of the words and units that fumon writes into the figure and its caption: en, "
                 "or a table of assets/words (ja); empty: as image.language"});
    table.text(
        "figure.words", figure.words,
        {.help = "a file of the form of assets/words/ja.toml with words in the place of those"});
    table.choice<PdfStandard>(
        "figure.pdf_standard", figure.pdf_standard,
        {{PdfStandard::none, "none", "PDF 1.4"},
         {PdfStandard::a_2b, "a-2b", "PDF/A-2b, for archives: sRGB and XMP inside"}},
        {.help = "of the figure's PDF"});
    table.text("figure.icc_profile", figure.icc_profile,
               {.help = "ICC profile of a printer's inks: the TIFF has these (CMYK); empty: sRGB"});
    table.text(
        "figure.journal", figure.journal,
        {.help = "whose rules hold (`fumon figure --check`): agu, copernicus, elsevier, nature; "
                 "it sets width, font_size, line_width and dots_per_inch where the scene "
                 "does not"});
    table.text("figure.caption", figure.caption,
               {.help = "the caption's first sentences; parameters, seeds and version follow"});
    table.tables("figure.panel", figure.panels, "a panel of the figure, for `fumon figure`",
                 list_panel_keys);
}

void list_overlay_keys(std::vector<OverlaySettings>& overlays, KeyTable& table) {
    table.role(KeyRole::look);
    table.tables("overlay", overlays, "something that stands over every frame", list_one_overlay);
}

}  // namespace fumon
