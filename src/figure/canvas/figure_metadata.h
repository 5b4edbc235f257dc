#pragma once

#include <string>
#include <string_view>

#include "figure/canvas/canvas.h"

namespace fumon {

/// An SVG file with a <metadata> element that holds every text under its keyword, and the "Title"
/// as its <title>. Throws Error where a text has a control character, which XML cannot hold.
std::string with_svg_metadata(const std::string& svg, const FigureMetadata& metadata);

/// The text under a keyword; empty where there is none.
std::string metadata_text(const FigureMetadata& metadata, std::string_view keyword);

/// The metadata of a PDF, SVG, PNG, TIFF or EPS file that fumon drew, in their order, also where
/// another program has written the PDF anew (see pdf_metadata.h); of any other PDF or SVG file,
/// none. `name` is the file's for errors. Throws InputError where the bytes are none of these, or
/// are damaged.
FigureMetadata read_figure_metadata(std::string_view bytes, const std::string& name);

}  // namespace fumon
