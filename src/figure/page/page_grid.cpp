#include "figure/page/page_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

using Cells = std::set<std::pair<int, int>>;

bool is_free(const Cells& taken, const GridSpan& place) {
    for (int row = place.row; row <= place.last_row(); ++row) {
        for (int column = place.column; column <= place.last_column(); ++column) {
            if (taken.contains({row, column})) return false;
        }
    }
    return true;
}

void take(Cells& taken, const GridSpan& place) {
    for (int row = place.row; row <= place.last_row(); ++row) {
        for (int column = place.column; column <= place.last_column(); ++column)
            taken.emplace(row, column);
    }
}

}  // namespace

std::vector<GridSpan> grid_spans(const Page& page) {
    if (page.panels.empty()) throw InputError("a page has no panels");
    if (page.columns < 1) throw InputError("a page has at least 1 column");
    std::vector<GridSpan> places;
    Cells taken;
    for (std::size_t n = 0; n < page.panels.size(); ++n) {
        const PagePanel& panel = page.panels[n];
        const bool automatic = panel.row < 0 && panel.column < 0;
        if (!automatic && (panel.row < 0 || panel.column < 0))
            throw InputError(fmt::format("panel {} has only one of row and column; give both",
                                         panel_name(page, n)));
        if (panel.rows < 1 || panel.columns < 1 ||
            std::max(panel.column, 0) + panel.columns > page.columns)
            throw InputError(fmt::format("panel {} does not fit into the page's {} columns",
                                         panel_name(page, n), page.columns));
        GridSpan place{std::max(panel.row, 0), std::max(panel.column, 0), panel.rows,
                       panel.columns};
        while (automatic && !is_free(taken, place)) {
            if (++place.column + place.columns <= page.columns) continue;
            place.column = 0;
            ++place.row;
        }
        if (!is_free(taken, place))
            throw InputError(
                fmt::format("panel {} overlaps another panel (row {}, column "
                            "{}, counted from 0)",
                            panel_name(page, n), place.row, place.column));
        take(taken, place);
        places.push_back(place);
    }
    return places;
}

std::string panel_letter(std::size_t n) {
    std::string letters;
    constexpr std::size_t alphabet = 26;
    for (std::size_t rest = n + 1; rest > 0; rest = (rest - 1) / alphabet)
        letters.insert(letters.begin(), static_cast<char>('a' + (rest - 1) % alphabet));
    return "(" + letters + ")";
}

std::string panel_name(const Page& page, std::size_t n) {
    const std::string& title = page.panels[n].title;
    return title.empty() ? panel_letter(n) : fmt::format("{} \"{}\"", panel_letter(n), title);
}

}  // namespace fumon
