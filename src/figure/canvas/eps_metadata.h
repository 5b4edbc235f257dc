#pragma once

#include <string>
#include <string_view>

#include "figure/canvas/canvas.h"

namespace fumon {

/// An EPS file with the metadata in its comments ("%fumon: …", a JSON list of pairs in ASCII, in
/// pieces), their Title as %%Title, and no date. Throws Error where a text is not UTF-8.
std::string with_eps_metadata(const std::string& eps, const FigureMetadata& metadata);

/// The metadata of such a file; of another, none. Throws InputError where they are damaged; `name`
/// is the file's.
FigureMetadata eps_metadata(std::string_view eps, const std::string& name);

}  // namespace fumon
