#pragma once

#include <string>
#include <string_view>

#include "figure/canvas/canvas.h"

namespace fumon {

/// What a PDF file's own entries say of a figure. `keywords` is all of the metadata, as a JSON list
/// of pairs in ASCII, which survives a PDF string unchanged.
struct PdfMetadata {
    std::string title;
    std::string creator;
    std::string keywords;
};

/// Throws Error where a keyword or text is not UTF-8.
PdfMetadata pdf_metadata(const FigureMetadata& metadata);

/// An SVG file with a <metadata> element that holds every text under its keyword, and the "Title"
/// as its <title>. Throws Error where a text has a control character, which XML cannot hold.
std::string with_svg_metadata(const std::string& svg, const FigureMetadata& metadata);

/// The metadata of a PDF, SVG or PNG file that fumon drew, in their order; of any other PDF or SVG
/// file, none. `name` is the file's for errors. Throws InputError where the bytes are neither of
/// the three, or are damaged.
FigureMetadata read_figure_metadata(std::string_view bytes, const std::string& name);

}  // namespace fumon
