#pragma once

#include <string>
#include <vector>

#include "figure/canvas.h"
#include "models/model.h"
#include "scene/scene.h"

namespace fumon {

enum class SectionPanel { velocity, pressure, stress, flights, flight_law, paths };

/// The panels of a snapshot's section that the settings ask for. Throws KeyError("section.panels")
/// for one that there is none of, or that the section does not give.
std::vector<SectionPanel> section_panels(const SectionSettings& settings, const Snapshot& snapshot);

/// A figure and the texts in it.
struct SectionFigure {
    Image image;
    std::vector<PlacedText> texts;
    std::vector<CanvasBox> frames;  ///< of the panels, in order
    double exaggeration = 1.0;      ///< vertical, of the maps
};

/// Draws the flat figure of a section: its panels below one another or side by side, whichever
/// shows them larger. Maps have equal scales along both axes, or a vertical exaggeration that their
/// titles state. Contains text: its pixels depend on fonts and on the versions of Cairo and Pango.
/// Throws KeyError("section.font_size") where the text leaves no room for the panels, and what
/// section_panels and read_palette throw.
SectionFigure draw_section_figure(const View& view, const Snapshot& snapshot);

}  // namespace fumon
