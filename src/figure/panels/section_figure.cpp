#include "figure/panels/section_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "figure/page/page.h"
#include "figure/panels/step_text.h"
#include "figure/words/chosen_words.h"

namespace fumon {

namespace {

constexpr double least_frame_side_em = 5.0;  // font sizes, along both sides

/// A page without its panels' columns: those are tried.
Page page_of(const View& view, const Snapshot& snapshot, const std::vector<SectionPanel>& panels,
             double font) {
    Page page;
    page.width = static_cast<double>(view.image.width);
    page.height = static_cast<double>(view.image.height);
    page.margin = 0.5 * font;
    page.column_gap = 1.2 * font;
    page.row_gap = 0.8 * font;
    page.font_size = font;
    page.line_width = std::max(1.0, 0.06 * font);
    page.letters = false;
    page.title = step_text(snapshot);
    for (const SectionPanel panel : panels) {
        PagePanel placed;
        placed.content = make_section_panel(view, snapshot, panel);
        placed.title = section_title(panel);
        page.panels.push_back(std::move(placed));
    }
    return page;
}

/// Lets the last panel fill its row, where it may have any shape.
void set_columns(Page& page, int columns) {
    page.columns = columns;
    const int beside = static_cast<int>(page.panels.size()) % columns;
    PagePanel& last = page.panels.back();
    last.columns = beside == 1 && last.content->aspect() == 0.0 ? columns : 1;
}

/// How large the panels are: the sum of their areas; 0 where one is too small to be read.
double shown_area(const PageLayout& layout, double font) {
    double area = 0.0;
    for (const CanvasBox& frame : layout.frames) {
        if (std::min(frame.width, frame.height) < least_frame_side_em * font) return 0.0;
        area += frame.width * frame.height;
    }
    return area;
}

/// The layout that shows the panels largest, with the page's columns set to it; none where the
/// texts leave no room.
std::optional<PageLayout> best_layout(Page& page) {
    std::optional<PageLayout> best;
    double best_area = 0.0;
    int best_columns = 1;
    for (int columns = 1; columns <= static_cast<int>(page.panels.size()); ++columns) {
        set_columns(page, columns);
        try {
            PageLayout layout = lay_out(page);
            const double area = shown_area(layout, page.font_size);
            if (area <= best_area) continue;
            best = std::move(layout);
            best_area = area;
            best_columns = columns;
        } catch (const InputError&) {  // too small for its texts
            continue;
        }
    }
    set_columns(page, best_columns);
    return best;
}

}  // namespace

SectionFigure draw_section_figure(const View& view, const Snapshot& snapshot) {
    const LanguageScope speaking(picture_words(view.image));
    const std::vector<SectionPanel> panels = section_panels(view.section, snapshot);
    const double shorter = static_cast<double>(std::min(view.image.width, view.image.height));
    const WordOrReal& size = view.section.font_size;
    constexpr double points_per_inch = 72.0;
    double font =
        size.is_word() ? shorter / 36.0 : size.value * view.image.dots_per_inch / points_per_inch;
    Page page = page_of(view, snapshot, panels, font);
    auto layout = best_layout(page);
    while (!layout && size.is_word() && font > 1.0) {
        font *= 0.9;
        page = page_of(view, snapshot, panels, font);
        layout = best_layout(page);
    }
    if (!layout) {
        throw KeyError("section.font_size",
                       fmt::format("section.font_size = {:g} leaves no room for {} panels in {} x "
                                   "{} pixels; take a smaller one or \"auto\"",
                                   size.value, panels.size(), view.image.width, view.image.height));
    }
    Canvas canvas(static_cast<int>(view.image.width), static_cast<int>(view.image.height), font);
    draw_page(page, *layout, canvas);
    return {canvas.image(), canvas.texts(), layout->frames, section_exaggeration(snapshot)};
}

}  // namespace fumon
