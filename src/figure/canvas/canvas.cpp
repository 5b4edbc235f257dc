#include "figure/canvas/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "base/image.h"
#include "figure/canvas/cairo_handles.h"
#include "figure/canvas/canvas_parts.h"
#include "figure/canvas/eps_metadata.h"
#include "figure/canvas/figure_metadata.h"
#include "figure/canvas/marked_text.h"
#include "figure/canvas/pdf_archive.h"
#include "figure/canvas/pdf_metadata.h"
#include "figure/canvas/svg_ids.h"
#include "figure/canvas/svg_text.h"
#include "picture/png.h"
#include "picture/stills/tiff.h"

namespace fumon {

namespace {

/// Pixels as Cairo keeps them, 32 bits each, premultiplied by the opacity (0 … 255 a pixel; empty:
/// opaque), `copies` by `copies` of each. Throws Error where they are more than Cairo can hold.
Surface cairo_image(const Image& image, std::span<const std::uint8_t> opacity, int copies) {
    const bool opaque = opacity.empty();
    Surface surface(cairo_image_surface_create(opaque ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                               copies * image.width, copies * image.height));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
        throw Error(fmt::format("cannot draw an image of {} x {} pixels into a figure: {}",
                                image.width, image.height,
                                cairo_status_to_string(cairo_surface_status(surface.get()))));
    unsigned char* pixels = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    std::vector<std::uint32_t> line(static_cast<std::size_t>(copies) *
                                    static_cast<std::size_t>(image.width));
    std::size_t n = 0;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* in = image.row(y);
        auto out = line.begin();
        for (int x = 0; x < image.width; ++x, ++n) {
            const std::uint32_t alpha = opaque ? 255U : opacity[n];
            std::uint32_t pixel = alpha;
            for (int c = 0; c < 3; ++c) pixel = (pixel << 8U) | ((*in++ * alpha + 127U) / 255U);
            out = std::fill_n(out, copies, pixel);
        }
        for (int copy = 0; copy < copies; ++copy)
            std::memcpy(pixels + std::ptrdiff_t{stride} * (std::ptrdiff_t{copies} * y + copy),
                        line.data(), 4 * line.size());
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

/// Pixels that are there or are not.
struct OpaquePixels {
    Image image;
    std::vector<std::uint8_t> opacity;  ///< 0 or 255
};

/// What is seen through is as if on white.
OpaquePixels composited_on_white(const Image& image, std::span<const std::uint8_t> opacity) {
    OpaquePixels flat{image, {opacity.begin(), opacity.end()}};
    for (std::size_t i = 0; i < opacity.size(); ++i) {
        if (opacity[i] == 0) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            std::uint8_t& level = flat.image.rgb[3 * i + c];
            level = static_cast<std::uint8_t>(255U - ((255U - level) * opacity[i] + 127U) / 255U);
        }
        flat.opacity[i] = 255;
    }
    return flat;
}

/// The pixels of an opaque image of Cairo's.
Image image_of_cairo(cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    Image image(cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface));
    const unsigned char* pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < image.height; ++y) {
        std::uint8_t* out = image.row(y);
        for (int x = 0; x < image.width; ++x) {
            std::uint32_t pixel = 0;
            std::memcpy(&pixel, pixels + std::ptrdiff_t{stride} * y + std::ptrdiff_t{4} * x, 4);
            *out++ = static_cast<std::uint8_t>(pixel >> 16U);
            *out++ = static_cast<std::uint8_t>(pixel >> 8U);
            *out++ = static_cast<std::uint8_t>(pixel);
        }
    }
    return image;
}

}  // namespace

Canvas::Canvas(int width, int height, double font_size, CanvasGround ground)
    : parts_(std::make_unique<Parts>(std::nullopt, width, height, points_per_inch, font_size,
                                     ground)) {}

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

void Canvas::fill_rings(std::span<const std::vector<CanvasPoint>> rings, const Ink& ink) {
    cairo_t* drawing = parts_->drawing.get();
    parts_->use(ink);
    for (const std::vector<CanvasPoint>& ring : rings) {
        cairo_new_sub_path(drawing);
        for (const CanvasPoint& point : ring) cairo_line_to(drawing, point.x, point.y);
        cairo_close_path(drawing);
    }
    cairo_set_fill_rule(drawing, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_fill(drawing);
    cairo_set_fill_rule(drawing, CAIRO_FILL_RULE_WINDING);
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
    const bool without_opacity = parts_->format == PageFormat::eps && !opacity.empty();
    const OpaquePixels flat =
        without_opacity ? composited_on_white(image, opacity) : OpaquePixels();
    const Surface pixels = without_opacity ? cairo_image(flat.image, flat.opacity, copies)
                                           : cairo_image(image, opacity, copies);
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
    parts_->show_text({0.0, 0.0}, ink);
    cairo_restore(drawing);
    parts_->note_missing(text);
    parts_->texts.push_back({read_marked_text(text).letters, box});
}

void Canvas::write_turned(const std::string& text, const CanvasPoint& middle, double angle,
                          const Ink& ink, double size) {
    parts_->set_text(text, size, false);
    const auto [length, height] = parts_->size_of_text();
    cairo_t* drawing = parts_->drawing.get();
    cairo_save(drawing);
    cairo_translate(drawing, middle.x, middle.y);
    cairo_rotate(drawing, angle);
    parts_->show_text({-0.5 * length, -0.5 * height}, ink);
    cairo_restore(drawing);
    parts_->note_missing(text);
    const double across = std::abs(elementary::cos(angle));
    const double down = std::abs(elementary::sin(angle));
    const double width = across * length + down * height;
    const double tall = down * length + across * height;
    parts_->texts.push_back({read_marked_text(text).letters,
                             {middle.x - 0.5 * width, middle.y - 0.5 * tall, width, tall}});
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

bool Canvas::uses_system_fonts() const {
    return parts_->system_fonts;
}

Image Canvas::image() const {
    cairo_surface_t* surface = parts_->surface.get();
    if (cairo_surface_get_type(surface) != CAIRO_SURFACE_TYPE_IMAGE)
        throw Error("a vector page has no pixels");
    return image_of_cairo(surface);
}

CanvasLayer Canvas::layer() const {
    cairo_surface_t* surface = parts_->surface.get();
    if (cairo_surface_get_type(surface) != CAIRO_SURFACE_TYPE_IMAGE)
        throw Error("a vector page has no pixels");
    cairo_surface_flush(surface);
    CanvasLayer layer{
        cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
    const auto width = static_cast<std::size_t>(layer.width);
    layer.pixels.resize(width * static_cast<std::size_t>(layer.height));
    const unsigned char* pixels = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < layer.height; ++y) {
        std::memcpy(layer.pixels.data() + static_cast<std::size_t>(y) * width,
                    pixels + std::ptrdiff_t{stride} * y, 4 * width);
    }
    return layer;
}

void Canvas::keep_letters_as_text() {
    parts_->letters_as_text = parts_->format == PageFormat::svg;
}

void Canvas::keep_for_archives() {
    parts_->for_archives = parts_->format == PageFormat::pdf;
}

void Canvas::print_by(std::string cmyk_profile) {
    parts_->cmyk_profile = std::move(cmyk_profile);
}

void Canvas::set_metadata(FigureMetadata metadata) {
    parts_->metadata = std::move(metadata);
}

std::string Canvas::bytes() {
    if (!parts_->format) throw Error("an image canvas cannot be written as a page");
    if (*parts_->format == PageFormat::png) {
        const auto file = encode_png(image(), parts_->dots_per_inch, parts_->metadata);
        return {file.begin(), file.end()};
    }
    if (*parts_->format == PageFormat::tiff) {
        const auto file =
            encode_tiff(image(), parts_->dots_per_inch, parts_->metadata, parts_->cmyk_profile);
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
    if (*parts_->format == PageFormat::eps)
        return with_eps_metadata(parts_->file, parts_->metadata);
    if (parts_->for_archives) return pdf_archive(parts_->file, pdf_metadata(parts_->metadata));
    if (*parts_->format == PageFormat::pdf) return parts_->file;
    return with_svg_metadata(with_svg_texts(with_counted_ids(parts_->file), parts_->svg_texts),
                             parts_->metadata);
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
