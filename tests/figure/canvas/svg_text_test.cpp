#include <gtest/gtest.h>

#include <string>

#include "figure/canvas/canvas.h"

namespace fumon {
namespace {

std::string svg(bool as_text) {
    Canvas canvas(PageFormat::svg, 300.0, 160.0, 100.0, 12.0);
    if (as_text) canvas.keep_letters_as_text();
    const Ink ink{0.0, 0.0, 0.0};
    canvas.write("Height of m^{2} & <b>", {20.0, 20.0}, {0.0, 0.0}, ink);
    canvas.write("Upright label", {20.0, 150.0}, {0.0, 1.0}, ink, 1.0, true);
    return canvas.bytes();
}

TEST(SvgText, IsOutlinesUnlessAskedFor) {
    EXPECT_EQ(svg(false).find("<text "), std::string::npos);
    EXPECT_EQ(svg(false).find("Upright"), std::string::npos);
}

TEST(SvgText, StandsAtItsBaselineWithRaisedLettersAsParts) {
    const std::string file = svg(true);
    EXPECT_NE(file.find(">Upright label</text>"), std::string::npos);
    EXPECT_NE(file.find("Height of m<tspan dy=\"-4.199\" font-size=\"8.4\">2</tspan>"),
              std::string::npos);
    EXPECT_NE(file.find(" &amp; &lt;b&gt;"), std::string::npos);
    EXPECT_NE(file.find("matrix(1 0 0 1 20 "), std::string::npos);
    EXPECT_TRUE(file.ends_with("</svg>\n"));
}

}  // namespace
}  // namespace fumon
