#include "figure/canvas/svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include "picture/markup.h"

namespace fumon {

namespace {

struct FreeIter {
    void operator()(PangoLayoutIter* iter) const { pango_layout_iter_free(iter); }
};

struct FreeAttributes {
    void operator()(PangoAttrIterator* iter) const { pango_attr_iterator_destroy(iter); }
};

double units(int pango) {
    return static_cast<double>(pango) / PANGO_SCALE;
}

/// How far letters stand above the baseline, and what share of the font's size they have.
struct Raise {
    double up = 0.0;
    double scale = 1.0;
};

Raise raise_of(PangoAttrIterator* attributes) {
    Raise raise;
    if (const PangoAttribute* up = pango_attr_iterator_get(attributes, PANGO_ATTR_RISE))
        raise.up = units(reinterpret_cast<const PangoAttrInt*>(up)->value);
    if (const PangoAttribute* scale = pango_attr_iterator_get(attributes, PANGO_ATTR_SCALE))
        raise.scale = reinterpret_cast<const PangoAttrFloat*>(scale)->value;
    return raise;
}

/// The letters from one byte to another, as parts that are raised alike.
std::string parts_of(PangoLayout* layout, std::string_view letters, int begin, int end,
                     double font_size) {
    std::string text;
    PangoAttrList* list = pango_layout_get_attributes(layout);
    const std::unique_ptr<PangoAttrIterator, FreeAttributes> attributes(
        pango_attr_list_get_iterator(list));
    double before = 0.0;
    do {
        int first = 0;
        int last = 0;
        pango_attr_iterator_range(attributes.get(), &first, &last);
        first = std::max(first, begin);
        last = std::min(last, end);
        if (first >= last) continue;
        const std::string part = markup_text(letters.substr(
            static_cast<std::size_t>(first), static_cast<std::size_t>(last - first)));
        const Raise raise = raise_of(attributes.get());
        if (raise.up == before && raise.scale == 1.0) {
            text += part;
        } else {
            text += fmt::format("<tspan dy=\"{:.4g}\" font-size=\"{:.4g}\">{}</tspan>",
                                before - raise.up, font_size * raise.scale, part);
        }
        before = raise.up;
    } while (pango_attr_iterator_next(attributes.get()) != 0);
    return text;
}

}  // namespace

std::string svg_text(PangoLayout* layout, const std::array<double, 6>& matrix, const Ink& ink) {
    const std::string_view letters(pango_layout_get_text(layout));
    const PangoFontDescription* font = pango_layout_get_font_description(layout);
    const double size = units(pango_font_description_get_size(font));
    const bool bold = pango_font_description_get_weight(font) >= PANGO_WEIGHT_BOLD;
    const auto level = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
    std::string elements;
    const std::unique_ptr<PangoLayoutIter, FreeIter> iter(pango_layout_get_iter(layout));
    do {
        const PangoLayoutLine* line = pango_layout_iter_get_line_readonly(iter.get());
        PangoRectangle place{};
        pango_layout_iter_get_line_extents(iter.get(), nullptr, &place);
        if (line->length == 0) continue;
        const double x = units(place.x);
        const double y = units(pango_layout_iter_get_baseline(iter.get()));
        const auto& [a, b, c, d, e, f] = matrix;
        elements += fmt::format(
            "<text transform=\"matrix({:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g})\" "
            "font-family=\"'{}', sans-serif\" font-size=\"{:.4g}\"{} fill=\"rgb({}, {}, {})\"{} "
            "textLength=\"{:.6g}\" xml:space=\"preserve\">{}</text>\n",
            a, b, c, d, e + a * x + c * y, f + b * x + d * y,
            markup_text(pango_font_description_get_family(font)), size,
            bold ? " font-weight=\"bold\"" : "", level(ink.red), level(ink.green), level(ink.blue),
            ink.opacity < 1.0 ? fmt::format(" fill-opacity=\"{:.4g}\"", ink.opacity) : "",
            units(place.width),
            parts_of(layout, letters, line->start_index, line->start_index + line->length, size));
    } while (pango_layout_iter_next_line(iter.get()) != 0);
    return elements;
}

std::string with_svg_texts(const std::string& svg, const std::string& elements) {
    const std::size_t end = svg.rfind("</svg>");
    if (elements.empty() || end == std::string::npos) return svg;
    return svg.substr(0, end) + elements + svg.substr(end);
}

}  // namespace fumon
