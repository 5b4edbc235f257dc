#include "figure/canvas/outline_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/sha256.h"
#include "figure/canvas/canvas.h"
#include "files/hash.h"

namespace fumon {
namespace {

OutlineText set(const std::string& text, double size = 20.48, bool bold = false) {
    return OutlineText::set(read_marked_text(text), size, bold).value();
}

// 20.48 pixels: a hundredth of a pixel a unit of the font. Advances are DejaVu Sans': A 1401, V
// 1401, t 803, space 651.
TEST(OutlineText, HasTheWidthOfItsLettersAndTheirKerning) {
    EXPECT_NEAR(set("A").width(), 14.01, 1e-9);
    EXPECT_NEAR(set("A A").width(), 14.01 * 2 + 6.51, 1e-9);
    EXPECT_NEAR(set("AV").width(), 14.01 * 2 - 1.31, 1e-9);
    EXPECT_NEAR(set("A").height(), 19.01 + 4.83, 1e-9);
    EXPECT_GT(set("A", 20.48, true).width(), 14.01);
}

TEST(OutlineText, SetsLinesOneBelowAnother) {
    EXPECT_NEAR(set("A\nAAA").width(), 3 * 14.01 + 2 * 0.57, 1e-9);
    EXPECT_NEAR(set("A\n\nA").height(), 3 * (19.01 + 4.83), 1e-9);
}

TEST(OutlineText, RaisesAndLowersSmallerLetters) {
    EXPECT_NEAR(set("A^{A}").width(), 14.01 * 1.7, 1e-9);
    EXPECT_NEAR(set("A^{A}").height(), 0.7 * 19.01 + 0.35 * 20.48 + 4.83, 1e-9);
    EXPECT_NEAR(set("A_{A}").height(), 19.01 + 0.7 * 4.83 + 0.2 * 20.48, 1e-9);
}

TEST(OutlineText, LeavesLettersThatItLacksToTheSystemsFonts) {
    EXPECT_FALSE(OutlineText::set(read_marked_text("風紋"), 20.0, false).has_value());
    EXPECT_FALSE(OutlineText::set(read_marked_text("e\u0301"), 20.0, false).has_value());
    EXPECT_TRUE(
        OutlineText::set(read_marked_text("τ ≥ 0.02 m²/s × 10⁻³ – Дюна, fjörð…"), 20.0, false)
            .has_value());
}

TEST(OutlineText, RefusesALineThatBelongsToNoFont) {
    const auto message = [](const std::string& text) {
        try {
            (void)OutlineFont::parse(text, "font.txt");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(message("# letters\nglyph 41 1401 M 3"),
              "font.txt:2: '' is not valid in a font file");
    EXPECT_EQ(message("glyph 4x 1"), "font.txt:1: '4x' is not valid in a font file");
    EXPECT_EQ(message("em 2048 ascent 1901 depth 4"),
              "font.txt:1: 'em' is not valid in a font file");
    EXPECT_EQ(message("glyph 41 1401"),
              "font.txt: a line 'em UNITS ascent UNITS descent UNITS' is missing");
}

// Read on Debian 12 and Debian 13, whose FreeType, Pango and Cairo are others.
TEST(OutlineText, HasTheSamePixelsOnEverySystem) {
    Canvas canvas(260, 130, 17.3);
    canvas.write("Tension AV, t = 12.5 yr", {4.3, 3.2}, {0.0, 0.0}, {}, 1.0, false, true);
    canvas.write("discharge (m^{3}/s), τ_{c}", {130.4, 60.7}, {0.5, 0.5}, {0.2, 0.3, 0.6, 0.8},
                 0.9);
    canvas.write("upright @ 45°", {255.0, 120.0}, {1.0, 1.0}, {}, 0.8, true);
    canvas.write_turned("contour 120", {100.0, 100.0}, 0.4, {}, 0.7);
    const Image image = canvas.image();
    Sha256Stream pixels;
    for (int y = 0; y < image.height; ++y)
        pixels.add(image.row(y), std::size_t{3} * static_cast<std::size_t>(image.width));
    EXPECT_EQ(hex(pixels.finish()),
              "c3ee2c59e8e01ec08e4db4ccf1caea75d25c35345ffccf389bd611e9e9b01a39");
}

}  // namespace
}  // namespace fumon
