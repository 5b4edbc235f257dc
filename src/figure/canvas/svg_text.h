#pragma once

#include <pango/pango.h>

#include <array>
#include <string>

#include "figure/canvas/canvas.h"

namespace fumon {

/// A layout of one or more lines as SVG elements "text", which readers can select, search and edit:
/// each line at its baseline, raised and lowered letters as parts of it. `matrix`: a, b, c, d, e
/// and f of SVG's matrix() from the layout's upper left corner to the page.
std::string svg_text(PangoLayout* layout, const std::array<double, 6>& matrix, const Ink& ink);

/// An SVG file with elements as its last ones, before whose others they stand.
std::string with_svg_texts(const std::string& svg, const std::string& elements);

}  // namespace fumon
