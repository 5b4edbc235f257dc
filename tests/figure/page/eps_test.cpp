#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/image.h"
#include "figure/canvas/canvas.h"
#include "figure/canvas/figure_metadata.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

std::size_t times_in(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(EpsFile, HasNoPixelsButThoseOfItsPictures) {
    Canvas canvas(PageFormat::eps, 100.0, 50.0, 300.0, 8.0);
    canvas.fill(CanvasBox{0, 0, 60, 50}, {0.2, 0.4, 0.6, 0.5});
    canvas.stroke(std::vector<CanvasPoint>{{0, 0}, {100, 50}}, 2.0, {0.9, 0.1, 0.1, 0.3});
    canvas.write("seen through", {50, 25}, {0.5, 0.5}, {0.0, 0.0, 0.0, 0.7});
    const std::string without = canvas.bytes();
    EXPECT_EQ(times_in(without, "/ImageType"), 0U) << "nothing is seen through in PostScript";

    Canvas pictured(PageFormat::eps, 100.0, 50.0, 72.0, 8.0);
    pictured.fill(CanvasBox{0, 0, 60, 50}, black_ink);
    std::vector<std::uint8_t> opacity(16, 255);
    opacity[0] = 0;
    opacity[1] = 100;
    pictured.draw(Image(4, 4), {10, 10, 20, 20}, opacity);
    const FigureMetadata texts{{"Title", "(a) 風"}, {"fumon:scene", std::string(3000, 'x')}};
    pictured.set_metadata(texts);
    const std::string with = pictured.bytes();
    EXPECT_LE(times_in(with, "/Width "), 2U) << "the picture, and perhaps its mask";
    EXPECT_EQ(times_in(with, "/Width 100"), 0U);
    EXPECT_NE(with.find("%%BoundingBox: 0 0 100 50\n"), std::string::npos) << with.substr(0, 300);
    EXPECT_NE(with.find("%%Title: (a) \n"), std::string::npos);
    EXPECT_EQ(read_figure_metadata(with, "a.eps"), texts);
    for (std::size_t at = 0; at < with.size();) {
        const std::size_t end = std::min(with.find('\n', at), with.size());
        if (with[at] == '%') {
            EXPECT_LE(end - at, 255U) << "as long as comments may be";
        }
        at = end + 1;
    }
}

}  // namespace
}  // namespace fumon
