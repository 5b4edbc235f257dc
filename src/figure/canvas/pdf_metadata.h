#pragma once

#include <string>
#include <string_view>

#include "figure/canvas/canvas.h"

namespace fumon {

/// What a PDF file's own entries say of a figure. `keywords` is all of the metadata, as a JSON list
/// of pairs in ASCII, which survives a PDF string unchanged; packed (packed_text.h) where longer
/// than readers are bound to take.
struct PdfMetadata {
    std::string title;
    std::string creator;
    std::string keywords;
};

/// Throws Error where a keyword or text is not UTF-8.
PdfMetadata pdf_metadata(const FigureMetadata& metadata);

/// The metadata in the keywords of a PDF file, in the last of its document information or, where
/// there are none, of its XMP; also of files that other programs have written anew, with object
/// streams, linearized, in other kinds of strings. Empty where no keywords are those of a figure.
/// Throws InputError where they are damaged or the file is encrypted; `name` is the file's.
FigureMetadata read_pdf_metadata(std::string_view pdf, const std::string& name);

/// The metadata that keywords of pdf_metadata() stand for; none of other keywords. Throws
/// InputError where they are damaged.
FigureMetadata figure_keywords(const std::string& keywords, const std::string& name);

}  // namespace fumon
