#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/image.h"

namespace fumon {

/// A place on a canvas, pixels rightward and downward from its upper left corner.
struct CanvasPoint {
    double x = 0.0;
    double y = 0.0;
};

struct CanvasBox {
    double x = 0.0;  ///< left
    double y = 0.0;  ///< top
    double width = 0.0;
    double height = 0.0;
};

/// sRGB and opacity, 0 … 1.
struct Ink {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double opacity = 1.0;
};

/// A text that stands on a canvas, and the box around it.
struct PlacedText {
    std::string text;
    CanvasBox box;
};

/// A white sheet to draw a figure on, of pixels, with Cairo and Pango. The same calls give the same
/// pixels with the same versions of these libraries and the same fonts: the shapes of letters come
/// from the system's DejaVu Sans (or what stands in for it). Belongs to one thread at a time.
class Canvas {
  public:
    /// `font_size` in pixels. Throws Error where the size is more than Cairo can hold.
    Canvas(int width, int height, double font_size);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void fill(const CanvasBox& box, const Ink& ink);
    void fill(std::span<const CanvasPoint> corners, const Ink& ink);
    /// `width` in pixels; round ends and joints.
    void stroke(std::span<const CanvasPoint> line, double width, const Ink& ink);

    /// Stretches an image over a box: each of its pixels one even patch, or averages of them where
    /// the box has fewer. `opacity`: 0 … 255 a pixel, top row first; empty where the image covers
    /// all.
    void draw(const Image& image, const CanvasBox& box, std::span<const std::uint8_t> opacity = {});

    /// Width and height that a text takes, pixels, `size` times the canvas's font size.
    [[nodiscard]] std::array<double, 2> text_size(const std::string& text, double size = 1.0) const;
    /// Writes a text so that the share `anchor` of its box (0, 0: upper left; 1, 1: lower right)
    /// lies at `at`; upright texts read from below.
    void write(const std::string& text, const CanvasPoint& at, const CanvasPoint& anchor,
               const Ink& ink, double size = 1.0, bool upright = false);

    [[nodiscard]] double font_size() const;
    /// The width of frames' and ticks' lines.
    [[nodiscard]] double line_width() const;
    /// Every text written so far.
    [[nodiscard]] const std::vector<PlacedText>& texts() const;
    [[nodiscard]] Image image() const;

  private:
    friend class CanvasClip;
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// While it lives, what is drawn shows within a box only.
class CanvasClip {
  public:
    CanvasClip(Canvas& canvas, const CanvasBox& box);
    ~CanvasClip();
    CanvasClip(const CanvasClip&) = delete;
    CanvasClip& operator=(const CanvasClip&) = delete;

  private:
    Canvas& canvas_;
};

/// The libraries that draw figures, with their versions, for records.
std::string figure_library();

}  // namespace fumon
