#include "figure/canvas/canvas_parts.h"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <cmath>
#include <new>

#include "base/error.h"
#include "figure/canvas/marked_text.h"
#include "figure/canvas/svg_text.h"

namespace fumon {

namespace {

constexpr const char* letters_package = "fonts-ipaexfont-gothic";

cairo_status_t append(void* bytes, const unsigned char* more, unsigned int count) {
    try {
        static_cast<std::string*>(bytes)->append(more, more + count);
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Canvas::Parts::Parts(std::optional<PageFormat> format_, double width_, double height_,
                     double dots_per_inch_, double font_size_, CanvasGround ground_)
    : format(format_),
      ground(ground_),
      width(width_),
      height(height_),
      dots_per_inch(dots_per_inch_),
      surface(new_surface()),
      drawing(cairo_create(surface.get())),
      font_size(font_size_),
      line_width(std::max(format_ ? 72.0 / dots_per_inch_ : 1.0, 0.06 * font_size_)) {
    if (const auto status = cairo_status(drawing.get()); status != CAIRO_STATUS_SUCCESS)
        throw Error(fmt::format("cannot draw a figure of {} x {} {}: {}", width, height,
                                format ? "points" : "pixels", cairo_status_to_string(status)));
    cairo_set_line_cap(drawing.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(drawing.get(), CAIRO_LINE_JOIN_ROUND);
    // Whatever the system's settings are: nothing of a display goes into the pixels.
    const FontOptions options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    if (ground == CanvasGround::white) {
        cairo_set_source_rgb(drawing.get(), 1.0, 1.0, 1.0);
        cairo_paint(drawing.get());
    }
    // Before the scale below, so that texts have the same sizes in all formats.
    layout.reset(pango_cairo_create_layout(drawing.get()));
    PangoContext* context = pango_layout_get_context(layout.get());
    pango_cairo_context_set_font_options(context, options.get());
    pango_context_set_round_glyph_positions(context, FALSE);  // which spaces letters unevenly
    pango_layout_set_alignment(layout.get(), PANGO_ALIGN_CENTER);
    pango_context_set_language(context, pango_language_from_string("ja"));
    if (format && has_pixels())
        cairo_scale(drawing.get(), dots_per_inch / points_per_inch,
                    dots_per_inch / points_per_inch);
}

cairo_surface_t* Canvas::Parts::new_surface() {
    if (format == PageFormat::pdf) {
        auto* pdf = cairo_pdf_surface_create_for_stream(append, &file, width, height);
        // Later versions may compress the metadata.
        cairo_pdf_surface_restrict_to_version(pdf, CAIRO_PDF_VERSION_1_4);
        return pdf;
    }
    if (format == PageFormat::eps) {
        auto* eps = cairo_ps_surface_create_for_stream(append, &file, width, height);
        cairo_ps_surface_restrict_to_level(eps, CAIRO_PS_LEVEL_3);
        cairo_ps_surface_set_eps(eps, 1);
        return eps;
    }
    if (format == PageFormat::svg) {
        auto* svg = cairo_svg_surface_create_for_stream(append, &file, width, height);
        cairo_svg_surface_set_document_unit(svg, CAIRO_SVG_UNIT_PT);
        return svg;
    }
    const double scale = format ? dots_per_inch / points_per_inch : 1.0;
    const auto pixels = [scale](double length) {
        constexpr double rounding = 1e-6;  // pixels
        constexpr double most = 1e6;       // more than Cairo takes
        return static_cast<int>(std::clamp(std::ceil(length * scale - rounding), 1.0, most));
    };
    return cairo_image_surface_create(
        ground == CanvasGround::white ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, pixels(width),
        pixels(height));
}

void Canvas::Parts::set_text(const std::string& text, double size, bool bold) {
    const MarkedText marked = read_marked_text(text);
    outlines.reset();
    if (!format) outlines = OutlineText::set(marked, size * font_size, bold);
    if (outlines) return;
    system_fonts = true;
    const double pixels = size * font_size * PANGO_SCALE;
    const Font font(pango_font_description_from_string("DejaVu Sans"));
    if (bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
    pango_font_description_set_absolute_size(font.get(), pixels);
    pango_layout_set_font_description(layout.get(), font.get());
    const Attributes attributes(pango_attr_list_new());
    // Letters that run into one are another letter to whoever searches a page.
    if (format)
        pango_attr_list_insert(attributes.get(), pango_attr_font_features_new("liga=0, clig=0"));
    for (const RaisedPart& part : marked.parts) {
        for (PangoAttribute* attribute :
             {pango_attr_scale_new(RaisedLetters::size),
              pango_attr_rise_new(static_cast<int>(
                  pixels * (part.raised ? RaisedLetters::raised : RaisedLetters::lowered)))}) {
            attribute->start_index = static_cast<guint>(part.begin);
            attribute->end_index = static_cast<guint>(part.end);
            pango_attr_list_insert(attributes.get(), attribute);
        }
    }
    pango_layout_set_attributes(layout.get(), attributes.get());
    pango_layout_set_text(layout.get(), marked.letters.c_str(),
                          static_cast<int>(marked.letters.size()));
}

void Canvas::Parts::show_text(const CanvasPoint& at, const Ink& ink) {
    cairo_t* const on = drawing.get();
    if (letters_as_text) {
        cairo_matrix_t matrix;
        cairo_get_matrix(on, &matrix);
        cairo_matrix_translate(&matrix, at.x, at.y);
        svg_texts += svg_text(
            layout.get(), {matrix.xx, matrix.yx, matrix.xy, matrix.yy, matrix.x0, matrix.y0}, ink);
        return;
    }
    use(ink);
    cairo_move_to(on, at.x, at.y);
    if (outlines)
        outlines->fill(on);
    else
        pango_cairo_show_layout(on, layout.get());
}

int Canvas::Parts::copies_of(const Image& image, const CanvasBox& box) const {
    constexpr double least = 300.0;  // pixels an inch
    constexpr double most = 64.0;
    const double finest = std::max(least, dots_per_inch);
    if (has_pixels()) return 1;
    const double needed =
        std::max(box.width / image.width, box.height / image.height) * finest / points_per_inch;
    return static_cast<int>(std::ceil(std::clamp(needed - 1e-6, 1.0, most)));
}

void Canvas::Parts::note_missing(const std::string& text) {
    if (!missing.empty() || outlines || pango_layout_get_unknown_glyphs_count(layout.get()) == 0)
        return;
    missing = fmt::format(
        "no installed font has all letters of \"{}\": boxes appear instead; Japanese fonts come "
        "with the package {}",
        text, letters_package);
}

}  // namespace fumon
