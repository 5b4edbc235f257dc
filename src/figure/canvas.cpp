#include "figure/canvas.h"

#include <fmt/format.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "support/error.h"

namespace fumon {

namespace {

template <auto destroy>
struct Destroy {
    template <class Object>
    void operator()(Object* object) const {
        destroy(object);
    }
};

using Surface = std::unique_ptr<cairo_surface_t, Destroy<cairo_surface_destroy>>;
using Drawing = std::unique_ptr<cairo_t, Destroy<cairo_destroy>>;
using Layout = std::unique_ptr<PangoLayout, Destroy<g_object_unref>>;
using Font = std::unique_ptr<PangoFontDescription, Destroy<pango_font_description_free>>;
using FontOptions = std::unique_ptr<cairo_font_options_t, Destroy<cairo_font_options_destroy>>;

}  // namespace

struct Canvas::Parts {
    Parts(int width, int height, double font_size_)
        : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
          drawing(cairo_create(surface.get())),
          font_size(font_size_) {
        if (const auto status = cairo_status(drawing.get()); status != CAIRO_STATUS_SUCCESS)
            throw Error(fmt::format("cannot draw a figure of {} x {} pixels: {}", width, height,
                                    cairo_status_to_string(status)));
        cairo_set_line_cap(drawing.get(), CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(drawing.get(), CAIRO_LINE_JOIN_ROUND);
        // Whatever the system's settings are: nothing of a display goes into the pixels.
        const FontOptions options(cairo_font_options_create());
        cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
        cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
        cairo_set_source_rgb(drawing.get(), 1.0, 1.0, 1.0);
        cairo_paint(drawing.get());
        layout.reset(pango_cairo_create_layout(drawing.get()));
        pango_cairo_context_set_font_options(pango_layout_get_context(layout.get()), options.get());
    }

    void set_text(const std::string& text, double size) const {
        const Font font(pango_font_description_from_string("DejaVu Sans"));
        pango_font_description_set_absolute_size(font.get(), size * font_size * PANGO_SCALE);
        pango_layout_set_font_description(layout.get(), font.get());
        pango_layout_set_text(layout.get(), text.c_str(), static_cast<int>(text.size()));
    }

    [[nodiscard]] std::array<double, 2> size_of_text() const {
        int width = 0;
        int height = 0;
        pango_layout_get_size(layout.get(), &width, &height);
        return {static_cast<double>(width) / PANGO_SCALE,
                static_cast<double>(height) / PANGO_SCALE};
    }

    void use(const Ink& ink) const {
        cairo_set_source_rgba(drawing.get(), ink.red, ink.green, ink.blue, ink.opacity);
    }

    void trace(std::span<const CanvasPoint> points) const {
        cairo_new_path(drawing.get());
        for (const CanvasPoint& point : points) cairo_line_to(drawing.get(), point.x, point.y);
    }

    Surface surface;
    Drawing drawing;
    Layout layout;
    double font_size;
    std::vector<PlacedText> texts;
};

Canvas::Canvas(int width, int height, double font_size)
    : parts_(std::make_unique<Parts>(width, height, font_size)) {}

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

void Canvas::stroke(std::span<const CanvasPoint> line, double width, const Ink& ink) {
    parts_->use(ink);
    parts_->trace(line);
    cairo_set_line_width(parts_->drawing.get(), width);
    cairo_stroke(parts_->drawing.get());
}

void Canvas::draw(const Image& image, const CanvasBox& box, std::span<const std::uint8_t> opacity) {
    if (image.width < 1 || image.height < 1 || !(box.width > 0.0) || !(box.height > 0.0)) return;
    const Surface pixels(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
    unsigned char* data = cairo_image_surface_get_data(pixels.get());
    const int stride = cairo_image_surface_get_stride(pixels.get());
    std::size_t n = 0;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* in = image.row(y);
        for (int x = 0; x < image.width; ++x, ++n) {
            const std::uint32_t alpha = opacity.empty() ? 255U : opacity[n];
            std::uint32_t pixel = alpha;
            for (int c = 0; c < 3; ++c) pixel = (pixel << 8U) | ((*in++ * alpha + 127U) / 255U);
            std::memcpy(data + std::ptrdiff_t{stride} * y + std::ptrdiff_t{4} * x, &pixel, 4);
        }
    }
    cairo_surface_mark_dirty(pixels.get());
    cairo_t* drawing = parts_->drawing.get();
    cairo_save(drawing);
    cairo_rectangle(drawing, box.x, box.y, box.width, box.height);
    cairo_clip(drawing);
    cairo_translate(drawing, box.x, box.y);
    cairo_scale(drawing, box.width / image.width, box.height / image.height);
    cairo_set_source_surface(drawing, pixels.get(), 0.0, 0.0);
    const bool large = box.width >= image.width && box.height >= image.height;
    cairo_pattern_set_filter(cairo_get_source(drawing),
                             large ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
    if (!large) cairo_pattern_set_extend(cairo_get_source(drawing), CAIRO_EXTEND_PAD);
    cairo_paint(drawing);
    cairo_restore(drawing);
}

std::array<double, 2> Canvas::text_size(const std::string& text, double size) const {
    parts_->set_text(text, size);
    return parts_->size_of_text();
}

void Canvas::write(const std::string& text, const CanvasPoint& at, const CanvasPoint& anchor,
                   const Ink& ink, double size, bool upright) {
    parts_->set_text(text, size);
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
    parts_->texts.push_back({text, box});
}

double Canvas::font_size() const {
    return parts_->font_size;
}

double Canvas::line_width() const {
    return std::max(1.0, 0.06 * parts_->font_size);
}

const std::vector<PlacedText>& Canvas::texts() const {
    return parts_->texts;
}

Image Canvas::image() const {
    cairo_surface_t* surface = parts_->surface.get();
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
