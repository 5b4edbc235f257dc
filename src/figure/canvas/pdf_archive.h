#pragma once

#include <string>
#include <string_view>

#include "figure/canvas/pdf_metadata.h"

namespace fumon {

/// A page that Cairo wrote as PDF 1.4, made a file of PDF/A-2b (ISO 19005-2, level B): with XMP
/// that says so and repeats what the document information says, sRGB as the output intent, an
/// identifier from the file's content, and the map from CIDs to glyphs that Cairo leaves out.
/// Throws Error where the bytes are not as Cairo writes them.
std::string pdf_archive(std::string_view pdf, const PdfMetadata& metadata);

}  // namespace fumon
