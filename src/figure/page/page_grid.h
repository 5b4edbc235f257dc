#pragma once

#include <string>
#include <vector>

#include "figure/page/page.h"

namespace fumon {

/// The rows and columns of a page's grid that a panel takes.
struct GridSpan {
    int row = 0;
    int column = 0;
    int rows = 1;
    int columns = 1;

    [[nodiscard]] int last_row() const { return row + rows - 1; }
    [[nodiscard]] int last_column() const { return column + columns - 1; }
};

/// Where every panel stands. Throws InputError where a place is outside the grid or taken.
std::vector<GridSpan> grid_spans(const Page& page);

/// "(a)", "(b)" … "(z)", "(aa)" …
std::string panel_letter(std::size_t n);

/// How an error calls a panel: its letter, and its title if it has one.
std::string panel_name(const Page& page, std::size_t n);

}  // namespace fumon
