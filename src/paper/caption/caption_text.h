#pragma once

#include <string>

namespace fumon {

/// A caption as plain text, whose raised and lowered numbers and letters are those of Unicode.
std::string plain_caption(const std::string& caption);

/// The same for LaTeX, as one paragraph: \caption{\protect\input{FILE}} takes it.
std::string latex_caption(const std::string& caption);

/// The same as Markdown.
std::string markdown_caption(const std::string& caption);

}  // namespace fumon
