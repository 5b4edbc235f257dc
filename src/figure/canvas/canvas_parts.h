#pragma once

#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "figure/canvas/cairo_handles.h"
#include "figure/canvas/canvas.h"
#include "figure/canvas/outline_text.h"

namespace fumon {

inline constexpr double points_per_inch = 72.0;

/// What a canvas draws with: Cairo's surface, and a text in outlines that fumon ships (on frames)
/// or laid out by Pango (on a figure's page, and where those outlines lack a letter).
struct Canvas::Parts {
    Parts(std::optional<PageFormat> format_, double width_, double height_, double dots_per_inch_,
          double font_size_, CanvasGround ground_ = CanvasGround::white);

    cairo_surface_t* new_surface();
    /// Of a text with x^{2} and A_{s} in it (figure/marked_text.h).
    void set_text(const std::string& text, double size, bool bold);
    [[nodiscard]] std::array<double, 2> size_of_text() const {
        if (outlines) return {outlines->width(), outlines->height()};
        int text_width = 0;
        int text_height = 0;
        pango_layout_get_size(layout.get(), &text_width, &text_height);
        return {static_cast<double>(text_width) / PANGO_SCALE,
                static_cast<double>(text_height) / PANGO_SCALE};
    }

    /// PostScript has no opacity, and Cairo would lay pixels over what is seen through: there an
    /// ink is as if on white.
    void use(const Ink& ink) const {
        if (format == PageFormat::eps) {
            const auto on_white = [&](double level) { return 1.0 + ink.opacity * (level - 1.0); };
            cairo_set_source_rgb(drawing.get(), on_white(ink.red), on_white(ink.green),
                                 on_white(ink.blue));
            return;
        }
        cairo_set_source_rgba(drawing.get(), ink.red, ink.green, ink.blue, ink.opacity);
    }

    /// Writes the text that was set, from the current origin on, at an offset from it.
    void show_text(const CanvasPoint& at, const Ink& ink);

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
        return format != PageFormat::pdf && format != PageFormat::svg && format != PageFormat::eps;
    }

    /// How often a file holds each pixel of an image across and down.
    [[nodiscard]] int copies_of(const Image& image, const CanvasBox& box) const;
    void note_missing(const std::string& text);

    /// Whether an image in a box is shown with no fewer pixels than it has.
    [[nodiscard]] bool has_room_for(const Image& image, const CanvasBox& box) const {
        if (!has_pixels()) return true;
        const double scale = format ? dots_per_inch / points_per_inch : 1.0;
        return scale * box.width >= image.width && scale * box.height >= image.height;
    }

    std::optional<PageFormat> format;  ///< none: an image
    CanvasGround ground;
    double width;
    double height;
    double dots_per_inch;
    std::string file;  ///< what Cairo has written of it; outlives the surface, which writes on
    Surface surface;
    Drawing drawing;
    Layout layout;
    std::optional<OutlineText> outlines;  ///< of the text that was set; none: Pango has it
    double font_size;
    double line_width;
    std::vector<PlacedText> texts;
    std::string missing;
    bool system_fonts = false;     ///< Pango has set a text
    bool letters_as_text = false;  ///< of an SVG file
    std::string svg_texts;         ///< elements that come last in it
    bool for_archives = false;     ///< of a PDF file
    std::string cmyk_profile;      ///< of a TIFF file; empty: sRGB
    FigureMetadata metadata;
};

}  // namespace fumon
