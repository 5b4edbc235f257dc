#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fumon {

/// Letters that stand higher or lower than those around them, and are smaller.
struct RaisedPart {
    std::size_t begin = 0;  ///< bytes of MarkedText::letters
    std::size_t end = 0;
    bool raised = true;  ///< else lowered
};

/// A text as it is written, without its marks.
struct MarkedText {
    std::string letters;
    std::vector<RaisedPart> parts;
};

/// Reads the marks of a text: ^{…} raises what is in the braces, _{…} lowers it, and ^ raises a
/// number that follows a letter, as in m^2 and s^-1. Other marks are letters like others.
MarkedText read_marked_text(const std::string& text);

}  // namespace fumon
