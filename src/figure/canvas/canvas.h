#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"
#include "figure/canvas/canvas_box.h"

namespace fumon {

/// sRGB and opacity, 0 … 1.
struct Ink {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double opacity = 1.0;
};

inline constexpr Ink black_ink{0.0, 0.0, 0.0, 1.0};
inline constexpr Ink white_ink{1.0, 1.0, 1.0, 1.0};

/// A text that stands on a canvas, and the box around it.
struct PlacedText {
    std::string text;
    CanvasBox box;
};

/// What lies under a drawing.
enum class CanvasGround { white, transparent };

/// Pixels to lay over a picture, top row first: sRGB of 8 bits times the opacity, which is the
/// highest byte.
struct CanvasLayer {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;
};

/// What file a page becomes.
enum class PageFormat { pdf, svg, png, tiff, eps };

/// Keyword → UTF-8 text that travels within a figure's file.
using FigureMetadata = std::vector<std::pair<std::string, std::string>>;

/// A white sheet to draw a figure on, with Cairo and Pango: an image of pixels, or a page in points
/// (1/72 inch), which becomes a PDF, SVG, PNG, TIFF or
/// EPS file. One unit, here "units", is a pixel of an
/// image and a point of a page. The same calls give the same pixels and bytes with the same
/// versions of these libraries and the same fonts: the shapes of letters come from the system's
/// DejaVu Sans (or what stands in for it), those that it lacks from other fonts. Texts have the
/// same sizes in all formats. Belongs to one thread at a time.
class Canvas {
  public:
    /// An image. `font_size` in pixels. Throws Error where the size is more than Cairo can hold.
    Canvas(int width, int height, double font_size, CanvasGround ground = CanvasGround::white);
    /// A page. Sizes in points; `dots_per_inch` of a PNG's pixels, and
    /// at least of pictures in other files. Throws Error where the size is
    /// more than Cairo can hold.
    Canvas(PageFormat format, double width, double height, double dots_per_inch, double font_size);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    void fill(const CanvasBox& box, const Ink& ink);
    void fill(std::span<const CanvasPoint> corners, const Ink& ink);
    /// What lies within an odd number of outlines.
    void fill_rings(std::span<const std::vector<CanvasPoint>> rings, const Ink& ink);
    void fill_circle(const CanvasPoint& middle, double radius, const Ink& ink);
    /// `width` in units. Round ends and joints; dashes, which alternate with gaps of the lengths
    /// that follow them, have flat ends.
    void stroke(std::span<const CanvasPoint> line, double width, const Ink& ink,
                std::span<const double> dashes = {});
    void stroke_circle(const CanvasPoint& middle, double radius, double width, const Ink& ink);
    /// Stretches an image over a box, each of its pixels one even patch: PDF and SVG pages hold it
    /// with its own pixels, or a whole number of copies of each if they would be coarser than 300
    /// an inch or the page's dots_per_inch, since readers blur coarse ones; where a PNG or an image
    /// has fewer pixels than it, they are averages. `opacity`: 0 … 255 a pixel, top row first;
    /// empty where the image covers all.
    void draw(const Image& image, const CanvasBox& box, std::span<const std::uint8_t> opacity = {});

    /// Width and height that a text takes, with x^{2} raised and A_{s} lowered, units, `size` times
    /// the canvas's font size.
    [[nodiscard]] std::array<double, 2> text_size(const std::string& text, double size = 1.0,
                                                  bool bold = false) const;
    /// Writes a text so that the share `anchor` of its box (0, 0: upper left; 1, 1: lower right)
    /// lies at `at`; upright texts read from below.
    void write(const std::string& text, const CanvasPoint& at, const CanvasPoint& anchor,
               const Ink& ink, double size = 1.0, bool upright = false, bool bold = false);
    /// Writes a text with its middle at a point, turned clockwise by an angle in radians.
    void write_turned(const std::string& text, const CanvasPoint& middle, double angle,
                      const Ink& ink, double size = 1.0);

    [[nodiscard]] double width() const;   ///< units
    [[nodiscard]] double height() const;  ///< units
    [[nodiscard]] double font_size() const;
    void set_font_size(double font_size);
    /// The width of frames' and ticks' lines, units; at first 0.06 font sizes and at least 1 pixel.
    [[nodiscard]] double line_width() const;
    void set_line_width(double width);
    /// Every text written so far.
    [[nodiscard]] const std::vector<PlacedText>& texts() const;
    /// One line for the user where no font has a letter of a text, naming the text and the package
    /// to install; else empty.
    [[nodiscard]] const std::string& missing_letters() const;
    /// Whether a text that was measured or written is set in the system's fonts. Frames' texts are
    /// so where they have letters that fumon does not ship, a page's always.
    [[nodiscard]] bool uses_system_fonts() const;

    /// The pixels of an image or of a PNG page. Throws Error for other pages.
    [[nodiscard]] Image image() const;
    /// The pixels of an image with their opacity. Throws Error for pages.
    [[nodiscard]] CanvasLayer layer() const;

    /// Lets an SVG file hold texts that are written from now on as text, in DejaVu Sans or what a
    /// reader has for it, above all else; in place of outlines, which look the same everywhere.
    void keep_letters_as_text();
    /// What bytes() writes into the file beside the drawing. "Title" and "Software" are also what
    /// other programs show as title and creator.
    void set_metadata(FigureMetadata metadata);
    /// Makes a PDF file one of PDF/A-2b (see pdf_archive.h).
    void keep_for_archives();
    /// Gives a TIFF file the inks of a printer's ICC profile (its bytes) in place of sRGB.
    void print_by(std::string cmyk_profile);
    /// The page's finished file; nothing can be drawn after it. Holds no date, and the same calls
    /// give the same bytes. Throws Error for an image, where Cairo fails, and where the metadata
    /// cannot stand in such a file.
    std::string bytes();

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
