#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/figure/figure_settings.h"

namespace fumon {

/// What a journal asks of figures, as far as its pages say (assets/journals/journals.toml).
struct Journal {
    std::string name;  ///< empty: of what nearly all journals print
    std::string title;
    std::optional<double> single;         ///< width of a column, mm
    std::optional<double> both;           ///< width of two columns, mm
    std::optional<double> highest;        ///< mm
    std::optional<double> least_letters;  ///< points
    std::optional<double> least_raised;   ///< of raised and lowered letters, points
    std::optional<double> most_letters;   ///< points
    std::optional<double> least_lines;    ///< points
    std::optional<double> most_lines;     ///< points
    std::vector<std::string> formats;     ///< as figure.formats; empty: not said
    std::optional<double> line_art;       ///< least dots per inch of black and white
    std::optional<double> halftone;       ///< of colours and greys
    std::optional<double> combination;    ///< of these with letters and lines
    bool units_in_brackets = false;       ///< axes are labelled "name (unit)"
    bool rgb = false;                     ///< colours are to be RGB
    std::vector<std::string> pages;       ///< where it was read
    int read = 0;                         ///< in which year
};

/// All journals that fumon knows, the first of none in particular. Throws Error where the table
/// cannot be read.
const std::vector<Journal>& journals();

/// The journal of that name; nullptr where it is unknown.
const Journal* find_journal(std::string_view name);

/// Of a figure's labels: the letters of ticks and legends, and raised and lowered ones. Of curves:
/// the lines of frames and ticks.
inline constexpr double tick_share = 0.85;
inline constexpr double raised_share = 0.7;
inline constexpr double frame_share = 0.5;

/// Makes a figure one for its journal: "single" and "double" are its columns, and letters, lines
/// and dots per inch are large enough, where the scene does not give them. `given`: paths of keys.
void use_journal(FigureSettings& figure, const std::set<std::string>& given);

/// The names of those that have one.
std::vector<std::string> journal_names();

}  // namespace fumon
