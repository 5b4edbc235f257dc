#include "figure/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "figure/cairo_image.h"
#include "figure/figure_metadata.h"
#include "figure/svg_ids.h"
#include "output/png.h"
#include "support/error.h"

namespace fumon {

namespace {

constexpr double points_per_inch = 72.0;
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

struct Canvas::Parts {
    Parts(std::optional<PageFormat> format_, double width_, double height_, double dots_per_inch_,
          double font_size_)
        : format(format_),
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
        cairo_set_source_rgb(drawing.get(), 1.0, 1.0, 1.0);
        cairo_paint(drawing.get());
        // Before the scale below, so that texts have the same sizes in all formats.
        layout.reset(pango_cairo_create_layout(drawing.get()));
        PangoContext* context = pango_layout_get_context(layout.get());
        pango_cairo_context_set_font_options(context, options.get());
        if (format) {
            // Letters that run into one are another letter to whoever searches a page.
            const Attributes attributes(pango_attr_list_new());
            pango_attr_list_insert(attributes.get(),
                                   pango_attr_font_features_new("liga=0, clig=0"));
            pango_layout_set_attributes(layout.get(), attributes.get());
        }
        pango_layout_set_alignment(layout.get(), PANGO_ALIGN_CENTER);
        pango_context_set_language(context, pango_language_from_string("ja"));
        if (format == PageFormat::png)
            cairo_scale(drawing.get(), dots_per_inch / points_per_inch,
                        dots_per_inch / points_per_inch);
    }

    cairo_surface_t* new_surface() {
        if (format == PageFormat::pdf) {
            auto* pdf = cairo_pdf_surface_create_for_stream(append, &file, width, height);
            // Later versions may compress the metadata.
            cairo_pdf_surface_restrict_to_version(pdf, CAIRO_PDF_VERSION_1_4);
            return pdf;
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
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height));
    }

    void set_text(const std::string& text, double size, bool bold) const {
        const Font font(pango_font_description_from_string("DejaVu Sans"));
        if (bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
        pango_font_description_set_absolute_size(font.get(), size * font_size * PANGO_SCALE);
        pango_layout_set_font_description(layout.get(), font.get());
        pango_layout_set_text(layout.get(), text.c_str(), static_cast<int>(text.size()));
    }

    [[nodiscard]] std::array<double, 2> size_of_text() const {
        int text_width = 0;
        int text_height = 0;
        pango_layout_get_size(layout.get(), &text_width, &text_height);
        return {static_cast<double>(text_width) / PANGO_SCALE,
                static_cast<double>(text_height) / PANGO_SCALE};
    }

    void use(const Ink& ink) const {
        cairo_set_source_rgba(drawing.get(), ink.red, ink.green, ink.blue, ink.opacity);
    }

    void trace(std::span<const CanvasPoint> points) const {
        cairo_new_path(drawing.get());
        for (const CanvasPoint& point : points) cairo_line_to(drawing.get(), point.x, point.y);
    }

    void trace_circle(const CanvasPoint& middle, double radius) const {
        cairo_new_path(drawing.get());
        cairo_arc(drawing.get(), middle.x, middle.y, radius, 0.0, 2.0 * std::numbers::pi);
        cairo_close_path(drawing.get());
    }

    [[nodiscard]] bool has_pixels() const {
        return format != PageFormat::pdf && format != PageFormat::svg;
    }

    /// How often a file holds each pixel of an image across and down.
    [[nodiscard]] int copies_of(const Image& image, const CanvasBox& box) const {
        constexpr double finest = 300.0;  // pixels an inch
        constexpr double most = 64.0;
        if (has_pixels()) return 1;
        const double needed =
            std::max(box.width / image.width, box.height / image.height) * finest / points_per_inch;
        return static_cast<int>(std::ceil(std::clamp(needed - 1e-6, 1.0, most)));
    }

    /// Whether an image in a box is shown with no fewer pixels than it has.
    [[nodiscard]] bool has_room_for(const Image& image, const CanvasBox& box) const {
        if (!has_pixels()) return true;
        const double scale = format ? dots_per_inch / points_per_inch : 1.0;
        return scale * box.width >= image.width && scale * box.height >= image.height;
    }

    void note_missing(const std::string& text) {
        if (!missing.empty() || pango_layout_get_unknown_glyphs_count(layout.get()) == 0) return;
        missing = fmt::format(
            "no font here has all letters of \"{}\": boxes stand for them; Japanese ones come with "
            "the package {}",
            text, letters_package);
    }

    std::optional<PageFormat> format;  ///< none: an image
    double width;
    double height;
    double dots_per_inch;
    std::string file;  ///< what Cairo has written of it; outlives the surface, which writes on
    Surface surface;
    Drawing drawing;
    Layout layout;
    double font_size;
    double line_width;
    std::vector<PlacedText> texts;
    std::string missing;
    FigureMetadata metadata;
};

Canvas::Canvas(int width, int height, double font_size)
    : parts_(std::make_unique<Parts>(std::nullopt, width, height, points_per_inch, font_size)) {}

Canvas::Canvas(PageFormat format, double width, double height, double dots_per_inch,
               double font_size)
    : parts_(std::make_unique<Parts>(format, width, height, dots_per_inch, font_size)) {}

Canvas::~Canvas() = default;

void Canvas::fill(const CanvasBox& box, const Ink& ink) {
    parts_->use(ink);
    cairo_rectangle(parts_->drawing.get(), box.x, box.y, box.width, box.height);
    cairo_fill(parts_->drawing.get());
}

void Canvas::fill(std::span<const CanvasPoint> corners, const Ink& ink) {
    parts_->use(ink);
    parts_->trace(corners);
    cairo_fill(parts_->drawing.get());
}

void Canvas::fill_circle(const CanvasPoint& middle, double radius, const Ink& ink) {
    parts_->use(ink);
    parts_->trace_circle(middle, radius);
    cairo_fill(parts_->drawing.get());
}

void Canvas::stroke(std::span<const CanvasPoint> line, double width, const Ink& ink,
                    std::span<const double> dashes) {
    cairo_t* drawing = parts_->drawing.get();
    parts_->use(ink);
    parts_->trace(line);
    cairo_set_line_width(drawing, width);
    if (!dashes.empty()) {
        cairo_set_dash(drawing, dashes.data(), static_cast<int>(dashes.size()), 0.0);
        cairo_set_line_cap(drawing, CAIRO_LINE_CAP_BUTT);
    }
    cairo_stroke(drawing);
    cairo_set_dash(drawing, nullptr, 0, 0.0);
    cairo_set_line_cap(drawing, CAIRO_LINE_CAP_ROUND);
}

void Canvas::stroke_circle(const CanvasPoint& middle, double radius, double width, const Ink& ink) {
    parts_->use(ink);
    parts_->trace_circle(middle, radius);
    cairo_set_line_width(parts_->drawing.get(), width);
    cairo_stroke(parts_->drawing.get());
}

void Canvas::draw(const Image& image, const CanvasBox& box, std::span<const std::uint8_t> opacity) {
    if (image.width < 1 || image.height < 1 || !(box.width > 0.0) || !(box.height > 0.0)) return;
    const int copies = parts_->copies_of(image, box);
    const Surface pixels = cairo_image(image, opacity, copies);
    const Pattern pattern(cairo_pattern_create_for_surface(pixels.get()));
    const bool large = parts_->has_room_for(image, box);
    cairo_pattern_set_filter(pattern.get(), large ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
    if (!large) cairo_pattern_set_extend(pattern.get(), CAIRO_EXTEND_PAD);
    cairo_t* drawing = parts_->drawing.get();
    cairo_save(drawing);
    cairo_rectangle(drawing, box.x, box.y, box.width, box.height);
    cairo_clip(drawing);
    cairo_translate(drawing, box.x, box.y);
    cairo_scale(drawing, box.width / (copies * image.width), box.height / (copies * image.height));
    cairo_set_source(drawing, pattern.get());
    cairo_paint(drawing);
    cairo_restore(drawing);
}

std::array<double, 2> Canvas::text_size(const std::string& text, double size, bool bold) const {
    parts_->set_text(text, size, bold);
    return parts_->size_of_text();
}

void Canvas::write(const std::string& text, const CanvasPoint& at, const CanvasPoint& anchor,
                   const Ink& ink, double size, bool upright, bool bold) {
    parts_->set_text(text, size, bold);
    const auto [length, height] = parts_->size_of_text();
    const double box_width = upright ? height : length;
    const double box_height = upright ? length : height;
    const CanvasBox box{at.x - anchor.x * box_width, at.y - anchor.y * box_height, box_width,
                        box_height};
    cairo_t* drawing = parts_->drawing.get();
    cairo_save(drawing);
    cairo_translate(drawing, box.x, upright ? box.y + box.height : box.y);
    constexpr double quarter_turn = -1.5707963267948966;
    if (upright) cairo_rotate(drawing, quarter_turn);
    parts_->use(ink);
    cairo_move_to(drawing, 0.0, 0.0);
    pango_cairo_show_layout(drawing, parts_->layout.get());
    cairo_restore(drawing);
    parts_->note_missing(text);
    parts_->texts.push_back({text, box});
}

double Canvas::width() const {
    return parts_->width;
}

double Canvas::height() const {
    return parts_->height;
}

double Canvas::font_size() const {
    return parts_->font_size;
}

void Canvas::set_font_size(double font_size) {
    parts_->font_size = font_size;
}

double Canvas::line_width() const {
    return parts_->line_width;
}

void Canvas::set_line_width(double width) {
    parts_->line_width = width;
}

const std::vector<PlacedText>& Canvas::texts() const {
    return parts_->texts;
}

const std::string& Canvas::missing_letters() const {
    return parts_->missing;
}

Image Canvas::image() const {
    cairo_surface_t* surface = parts_->surface.get();
    if (cairo_surface_get_type(surface) != CAIRO_SURFACE_TYPE_IMAGE)
        throw Error("a page of lines and letters has no pixels");
    return image_of_cairo(surface);
}

void Canvas::set_metadata(FigureMetadata metadata) {
    parts_->metadata = std::move(metadata);
}

std::string Canvas::bytes() {
    if (!parts_->format) throw Error("an image of pixels is no page that becomes a file");
    if (*parts_->format == PageFormat::png) {
        const auto file = encode_png(image(), parts_->dots_per_inch, parts_->metadata);
        return {file.begin(), file.end()};
    }
    cairo_surface_t* surface = parts_->surface.get();
    if (*parts_->format == PageFormat::pdf) {
        const PdfMetadata metadata = pdf_metadata(parts_->metadata);
        const auto set = [surface](cairo_pdf_metadata_t which, const std::string& text) {
            if (!text.empty()) cairo_pdf_surface_set_metadata(surface, which, text.c_str());
        };
        set(CAIRO_PDF_METADATA_TITLE, metadata.title);
        set(CAIRO_PDF_METADATA_CREATOR, metadata.creator);
        set(CAIRO_PDF_METADATA_KEYWORDS, metadata.keywords);
        set(CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");  // else Cairo writes today's
    }
    cairo_show_page(parts_->drawing.get());
    cairo_surface_finish(surface);
    for (const auto status : {cairo_status(parts_->drawing.get()), cairo_surface_status(surface)}) {
        if (status != CAIRO_STATUS_SUCCESS)
            throw Error(fmt::format("cannot draw a page of {} x {} points: {}", parts_->width,
                                    parts_->height, cairo_status_to_string(status)));
    }
    if (*parts_->format == PageFormat::pdf) return parts_->file;
    return with_svg_metadata(with_counted_ids(parts_->file), parts_->metadata);
}

CanvasClip::CanvasClip(Canvas& canvas, const CanvasBox& box) : canvas_(canvas) {
    cairo_t* drawing = canvas.parts_->drawing.get();
    cairo_save(drawing);
    cairo_rectangle(drawing, box.x, box.y, box.width, box.height);
    cairo_clip(drawing);
}

CanvasClip::~CanvasClip() {
    cairo_restore(canvas_.parts_->drawing.get());
}

std::string figure_library() {
    return fmt::format("Cairo {}, Pango {}", cairo_version_string(), pango_version_string());
}

}  // namespace fumon
