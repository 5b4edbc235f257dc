#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "keys/word_or_real.h"
#include "numerics/curve_law.h"
#include "scene/figure/chart_settings.h"
#include "scene/figure/overlay_kinds.h"
#include "scene/figure/panel_kinds.h"

namespace fumon {

/// Where an overlay stands on a picture.
/// What an overlay is written in.
enum class OverlayInk { black, white };

enum class OverlayCorner {
    upper_left,
    upper_middle,
    upper_right,
    lower_left,
    lower_middle,
    lower_right
};

/// Which rows of data a curve is drawn from.
enum class CurveTable {
    measurements,
    avalanches,
    avalanche_sizes,
    profile,
    section,
    flights,
    file,
    expression
};

enum class CurveSpread { none, deviation, standard_error };
enum class SpreadLook { bars, band };
enum class CurveStyle { automatic, line, points, line_and_points, steps };

/// One curve of a plot, or one for each value of a column.
struct CurveSettings {
    std::string name;  ///< in the legend, with {column} for values; empty: none
    CurveTable table = CurveTable::measurements;
    std::string scene;              ///< another scene's file; empty: this one
    std::vector<std::string> set;   ///< "key=value": changes to it
    std::vector<std::string> over;  ///< what varies; empty: the scene's own sweep.over
    std::int64_t seeds = 0;         ///< 0: the scene's own sweep.seeds
    std::string file;               ///< table "file": CSV
    std::int64_t step = -1;         ///< profile, section, flights: of this step; -1: the last
    std::string x = "step";         ///< columns
    std::string y;
    std::string z;                       ///< heat maps and scatter plots: of the colours
    std::string expression;              ///< table "expression": y of x
    std::vector<std::string> constants;  ///< "name = number": in it
    WordOrReal x_from{"auto", 0.0};      ///< over which it is drawn
    WordOrReal x_to{"auto", 0.0};
    std::vector<std::string> where;  ///< "column=value", "column>=value" …
    std::string group_by;            ///< a curve for each value of this column
    bool average = true;             ///< rows with the same x become one point
    std::int64_t least = 1;          ///< points of fewer runs are left out
    CurveSpread spread = CurveSpread::none;
    SpreadLook bars = SpreadLook::bars;
    double offset_y = 0.0;  ///< added to y, before the scale
    double scale_x = 1.0;
    double scale_y = 1.0;
    CurveFit fit = CurveFit::none;
    WordOrReal fit_low{"auto", 0.0};  ///< range of x that is fitted
    WordOrReal fit_high{"auto", 0.0};
    CurveStyle style = CurveStyle::automatic;
    std::int64_t colour = 0;  ///< number in the cycle; 0: the next
};

/// A labelled range in a plot: where data of others lie.
struct RangeBoxSettings {
    std::string label;
    std::string source;  ///< author and year, for the caption
    double x_low = 0.0, x_high = 1.0;
    double y_low = 0.0, y_high = 1.0;
};

enum class PanelArrow { none, wind, flow, north, wind_and_north, flow_and_north };
enum class PanelRange { shared, own };
enum class PanelRelief { clear, scene };
enum class PanelColouring { automatic, plain, height };
enum class PanelLegend {
    automatic,
    none,
    outside,
    upper_left,
    upper_right,
    lower_left,
    lower_right
};
enum class InsetCorner { none, upper_left, upper_right, lower_left, lower_right };

/// One panel of a figure; one for each of its steps where it has several and is a picture.
struct PanelSettings {
    PanelKind kind = PanelKind::plot;
    std::string title;     ///< with {step}, {time}, {seed} or {key} for values
    std::int64_t row = 0;  ///< counted from 1; 0: in reading order
    std::int64_t column = 0;
    std::int64_t rows = 1;  ///< that it spans
    std::int64_t columns = 1;
    InsetCorner inset = InsetCorner::none;  ///< stands within the panel before it
    double inset_size = 0.4;                ///< share of that panel's frame

    // pictures
    std::string scene;                ///< another scene's file; empty: this one
    std::vector<std::string> set;     ///< "key=value": changes to it
    std::vector<std::int64_t> steps;  ///< empty: the last
    std::int64_t every = 0;  ///< time-space: steps between its lines; 0: a 200th of the run
    WordOrReal row_of_bed{"middle", 0.0};  ///< profile and time-space
    std::string field = "bed";
    PanelRange range = PanelRange::shared;  ///< of colours, between the steps
    WordOrReal low{"auto", 0.0};
    WordOrReal high{"auto", 0.0};
    std::string palette;  ///< empty: the scene's look.palette
    bool palette_reversed = false;
    double shading = 0.0;  ///< hill shading of a map
    bool shading_from_all_sides = false;
    WordOrReal contours{"none", 0.0};                    ///< metres between lines of equal height
    PanelRelief relief = PanelRelief::clear;             ///< of a view
    PanelColouring colours = PanelColouring::automatic;  ///< likewise
    bool axes = true;
    bool coordinates = false;  ///< of the terrain's file, along a map or a view's block
    bool colour_bar = true;
    bool scale_bar = false;
    bool vectors = false;  ///< arrows of the water's velocity on a map
    bool crests = false;   ///< measured and predicted directions of crests on a map
    PanelArrow arrow = PanelArrow::none;
    double flux_ratio = 1.6;           ///< of the prediction: γ
    std::string section = "velocity";  ///< as in section.panels

    // axes
    std::string x_label;  ///< with {unit}; empty: what runs along it, and its unit
    std::string y_label;
    std::string bar_label;  ///< of the colours, likewise

    // plots
    bool x_logarithmic = false;
    bool y_logarithmic = false;
    WordOrReal x_low{"auto", 0.0}, x_high{"auto", 0.0};
    WordOrReal y_low{"auto", 0.0}, y_high{"auto", 0.0};
    PanelLegend legend = PanelLegend::automatic;
    std::vector<CurveSettings> curves;
    std::vector<RangeBoxSettings> boxes;
    ChartSettings chart;
};

enum class SvgText { outlines, text };
enum class PdfStandard { none, a_2b };

/// A paper's figure: panels on a page.
struct FigureSettings {
    WordOrReal width{"double", 0.0};  ///< mm
    WordOrReal height{"auto", 0.0};   ///< mm
    std::int64_t columns = 0;         ///< of the grid of panels; 0: by their number
    double font_size = 8.0;           ///< points
    double line_width = 0.8;          ///< points
    bool letters = true;
    double dots_per_inch = 300.0;  ///< of pictures, and of the PNG
    std::vector<std::string> formats{"pdf", "svg", "png"};
    SvgText svg_text = SvgText::outlines;
    std::string language;  ///< of what fumon writes; empty: that of pictures
    std::string words;     ///< a file with words in their place; empty: none
    PdfStandard pdf_standard = PdfStandard::none;
    std::string icc_profile;  ///< file; empty: sRGB
    std::string journal;      ///< empty: none
    std::string caption;      ///< comes before the parameters
    std::vector<PanelSettings> panels;
};

/// Something written or drawn over the frames.
struct OverlaySettings {
    OverlayKind kind = OverlayKind::title;
    bool show = true;
    OverlayCorner corner = OverlayCorner::upper_left;
    std::string text;  ///< title, time, plot: with {title}, {step}, {time}, {key}; empty: usual
    std::vector<std::string> keys;  ///< parameters: the keys whose values are shown
    std::string x = "time";         ///< plot: columns of the measurements
    std::string y = "wavelength_spectrum";
    WordOrReal low{"auto", 0.0};  ///< plot: ends of its upward axis
    WordOrReal high{"auto", 0.0};
    double size = 0.25;                 ///< share of the picture's width; map: of its shorter side
    WordOrReal font_size{"auto", 0.0};  ///< pixels
    double opacity = 0.6;               ///< of the plate behind it, 0 … 1
    OverlayInk ink = OverlayInk::black;
};

}  // namespace fumon
