#pragma once

#include <vector>

#include "figure/canvas/canvas.h"
#include "figure/panels/section_panel.h"

namespace fumon {

/// A figure and the texts in it.
struct SectionFigure {
    Image image;
    std::vector<PlacedText> texts;
    std::vector<CanvasBox> frames;  ///< of the panels, in order
    double exaggeration = 1.0;      ///< vertical, of the maps
};

/// Draws the flat figure of a section: its panels on a page of as many columns as show them
/// largest, under the step and its time. Contains text: its pixels depend on fonts and on the
/// versions of Cairo and Pango. Throws KeyError("section.font_size") where the text leaves no room
/// for the panels, and what section_panels and make_section_panel throw.
SectionFigure draw_section_figure(const View& view, const Snapshot& snapshot);

}  // namespace fumon
