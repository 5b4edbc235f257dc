#pragma once

#include <optional>
#include <string_view>

namespace fumon {

/// A grid in text that is no ESRI ASCII grid.
struct OtherTextGrid {
    std::string_view title;   ///< "a Surfer ASCII grid (DSAA)"
    std::string_view remedy;  ///< how it becomes one
    bool is_list = false;     ///< of points
};

/// What a text (its first kilobytes suffice) is by its beginning: a grid of Surfer ("DSAA"), or a
/// list of points, three numbers or a heading of three names on each line (XYZ). Nothing for
/// others.
std::optional<OtherTextGrid> other_text_grid(std::string_view text);

}  // namespace fumon
