#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/canvas/corner.h"
#include "figure/canvas/panel.h"

namespace fumon {

/// A small panel within the frame of another.
struct PageInset {
    std::unique_ptr<const PanelContent> content;
    Corner corner = Corner::upper_right;
    double width = 0.4;   ///< with all its margins, of the frame's
    double height = 0.4;  ///< likewise
};

/// One panel of a page and its place in the grid.
struct PagePanel {
    std::unique_ptr<const PanelContent> content;
    std::string title;
    int row = -1;     ///< from 0; −1: the next free place, row by row
    int column = -1;  ///< likewise, and given where the row is
    int rows = 1;     ///< that it spans
    int columns = 1;
    std::vector<PageInset> insets;
};

/// A figure of panels in a grid. Lengths in points (1/72 inch).
struct Page {
    double width = 241.0;
    double height = 0.0;  ///< 0: as much as the panels take
    int columns = 1;
    double margin = 4.0;       ///< around everything
    double column_gap = 10.0;  ///< between what two panels take with their margins
    double row_gap = 8.0;      ///< likewise
    double font_size = 8.0;    ///< of labels; ticks and legends are 0.85 of it
    bool svg_text = false;     ///< whether an SVG file holds its letters as text, not as outlines
    bool pdf_for_archives = false;  ///< whether a PDF file is one of PDF/A-2b
    std::string cmyk_profile;       ///< bytes of the ICC profile of a TIFF file's inks; empty: sRGB
    double line_width = 0.5;        ///< of frames and ticks; curves are twice as wide
    double panel_aspect = 1.5;      ///< width over height of frames that are free to have any
    bool letters = true;            ///< "(a)", "(b)" … above the panels, where they are several
    std::string title;
    std::vector<PagePanel> panels;
};

/// Width and height in points of a page of that name: "single" and "double" columns of a journal
/// (85 and 175 mm wide, as high as needed: height 0), "slide" (254 × 142.9 mm). Throws InputError
/// with the known names for any other.
struct PageSize {
    double width = 0.0;
    double height = 0.0;
};
PageSize page_size(std::string_view name);

/// Where everything of a page stands, in points.
struct PageLayout {
    double width = 0.0;
    double height = 0.0;
    std::vector<CanvasBox> frames;               ///< of the panels, in order
    std::vector<PanelMargins> margins;           ///< kept free around each for its content
    std::vector<std::vector<CanvasBox>> insets;  ///< the insets' frames, per panel
    std::vector<CanvasPoint> headings;   ///< lower left end of each panel's letter and title
    std::vector<double> heading_widths;  ///< the room of each
};

/// Solves the frames: those of a column have the same left and right edges and those of a row the
/// same top and height, unless their aspects forbid it; then they are as large as the place
/// allows. Margins, titles and letters fit, and nothing overlaps. Throws InputError where the page
/// is too small for its panels or a place is given twice or outside the grid.
PageLayout lay_out(const Page& page);

/// A page drawn on a canvas of its layout's size.
void draw_page(const Page& page, const PageLayout& layout, Canvas& canvas);

/// A finished page.
struct DrawnPage {
    std::string bytes;  ///< the file
    PageLayout layout;
    std::vector<PlacedText> texts;
    std::string missing_letters;  ///< of Canvas
};

/// Lays a page out and draws it as a file. Throws what lay_out and Canvas throw.
DrawnPage draw_page(const Page& page, PageFormat format, double dots_per_inch,
                    const FigureMetadata& metadata);

}  // namespace fumon
