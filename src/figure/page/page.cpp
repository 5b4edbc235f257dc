#include "figure/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/error.h"
#include "base/nearest_name.h"
#include "figure/page/page_grid.h"
#include "figure/page/page_text.h"
#include "figure/plot/axes.h"

namespace fumon {

namespace {

constexpr double title_size_em = 1.2;    // font sizes
constexpr double title_line_em = 2.2;    // with the gap below it
constexpr double heading_line_em = 1.6;  // likewise
constexpr double heading_gap_em = 0.3;   // below it
constexpr double least_title_size_ratio =
    0.6;  // of its size, to which a title shrinks that is too long
constexpr double points_per_millimetre = 72.0 / 25.4;

struct NamedSize {
    const char* name;
    PageSize size;
};
constexpr std::array<NamedSize, 3> named_sizes{
    {{"single", {85.0 * points_per_millimetre, 0.0}},
     {"double", {175.0 * points_per_millimetre, 0.0}},
     {"slide", {254.0 * points_per_millimetre, 142.9 * points_per_millimetre}}}};

bool has_letters(const Page& page) {
    return page.letters && page.panels.size() > 1;
}

/// The length that the letter before a panel's title takes.
double letter_length(const Page& page, const Canvas& canvas, std::size_t n) {
    if (!has_letters(page)) return 0.0;
    return canvas.text_size(panel_letter(n), 1.0, true)[0] + 0.4 * canvas.font_size();
}

}  // namespace

PageSize page_size(std::string_view name) {
    std::vector<std::string> known;
    for (const NamedSize& one : named_sizes) {
        if (name == one.name) return one.size;
        known.emplace_back(one.name);
    }
    throw InputError(fmt::format("unknown page \"{}\"; {}", name, suggestion(name, known)));
}

double heading_height(const Page& page, std::size_t n) {
    const bool any = has_letters(page) || !page.panels[n].title.empty();
    return any ? heading_line_em * page.font_size : 0.0;
}

double title_height(const Page& page) {
    return page.title.empty() ? 0.0 : title_line_em * page.font_size;
}

CanvasBox inset_box(const PageInset& inset, const CanvasBox& frame, double gap) {
    const double width = inset.width * frame.width;
    const double height = inset.height * frame.height;
    const bool at_left = inset.corner == Corner::upper_left || inset.corner == Corner::lower_left;
    const bool at_top = inset.corner == Corner::upper_left || inset.corner == Corner::upper_right;
    return {at_left ? frame.x + gap : frame.right() - gap - width,
            at_top ? frame.y + gap : frame.bottom() - gap - height, width, height};
}

void check_texts(const Page& page, const PageLayout& layout, const Canvas& canvas) {
    const auto check = [&canvas](const std::string& text, double size, double longest) {
        const double length = canvas.text_size(text, size)[0];
        if (least_title_size_ratio * length > longest)
            throw InputError(
                fmt::format("the title \"{}\" is too long: it needs {:.0f} mm, and {:.0f} mm are "
                            "free; shorten it, or give a larger page or a "
                            "smaller font",
                            text, length / points_per_millimetre,
                            std::max(longest, 0.0) / points_per_millimetre));
    };
    check(page.title, title_size_em, page.width - 2.0 * page.margin);
    for (std::size_t n = 0; n < page.panels.size(); ++n)
        check(page.panels[n].title, 1.0, layout.heading_widths[n] - letter_length(page, canvas, n));
}

void draw_page(const Page& page, const PageLayout& layout, Canvas& canvas) {
    canvas.set_font_size(page.font_size);
    canvas.set_line_width(page.line_width);
    if (!page.title.empty())
        write_within(canvas, page.title, page.width - 2.0 * page.margin,
                     {0.5 * page.width, page.margin}, {0.5, 0.0}, title_size_em);
    for (std::size_t n = 0; n < page.panels.size(); ++n) {
        const PagePanel& panel = page.panels[n];
        panel.content->draw(canvas, layout.frames[n]);
        const CanvasPoint at{layout.headings[n].x,
                             layout.headings[n].y - heading_gap_em * page.font_size};
        const double letter = letter_length(page, canvas, n);
        if (letter > 0.0)
            canvas.write(panel_letter(n), at, {0.0, 1.0}, black_ink, 1.0, false, true);
        if (!panel.title.empty())
            write_within(canvas, panel.title, layout.heading_widths[n] - letter,
                         {at.x + letter, at.y}, {0.0, 1.0}, 1.0);
        canvas.set_font_size(inset_font_ratio * page.font_size);
        for (std::size_t i = 0; i < panel.insets.size(); ++i) {
            const PanelContent& content = *panel.insets[i].content;
            const CanvasBox& frame = layout.insets[n][i];
            const PanelMargins room = content.margins(canvas, frame.width, frame.height);
            canvas.fill(CanvasBox{frame.x - room.left, frame.y - room.above,
                                  frame.width + room.left + room.right,
                                  frame.height + room.above + room.below},
                        white_ink);
            content.draw(canvas, frame);
        }
        canvas.set_font_size(page.font_size);
    }
}

DrawnPage draw_page(const Page& page, PageFormat format, double dots_per_inch,
                    const FigureMetadata& metadata) {
    PageLayout layout = lay_out(page);
    Canvas canvas(format, layout.width, layout.height, dots_per_inch, page.font_size);
    canvas.set_metadata(metadata);
    if (page.svg_text) canvas.keep_letters_as_text();
    if (page.pdf_for_archives) canvas.keep_for_archives();
    if (!page.cmyk_profile.empty()) canvas.print_by(page.cmyk_profile);
    draw_page(page, layout, canvas);
    std::string bytes = canvas.bytes();
    return {std::move(bytes), std::move(layout), canvas.texts(), canvas.missing_letters()};
}

}  // namespace fumon
