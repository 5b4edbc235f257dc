#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "figure/canvas/figure_metadata.h"
#include "figure/canvas/svg_ids.h"
#include "figure/page/page.h"
#include "picture/png.h"
#include "support/command.h"
#include "support/figure_panels.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::panel_of;
using test::series_of;

constexpr std::array<PageFormat, 5> formats{PageFormat::pdf, PageFormat::svg, PageFormat::png,
                                            PageFormat::tiff, PageFormat::eps};

/// What a program that reads figures says; a failure where it is missing or refuses.
std::string said_by(const std::string& command) {
    const test::Spoken spoken = test::run_command(command);
    EXPECT_EQ(spoken.status, 0) << command << ": " << spoken.words
                                << "(poppler-utils and librsvg2-bin are installed by .ci/install)";
    return spoken.words;
}

Image chequered() {
    Image image(6, 4);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            std::uint8_t* at = image.row(y) + std::ptrdiff_t{3} * x;
            at[0] = static_cast<std::uint8_t>(40 * x);
            at[1] = static_cast<std::uint8_t>(60 * y);
            at[2] = (x + y) % 2 == 0 ? 250 : 20;
        }
    }
    return image;
}

/// A panel that shows an image.
class ImagePanel : public PanelContent {
  public:
    [[nodiscard]] double aspect() const override { return 1.5; }
    [[nodiscard]] PanelMargins margins(const Canvas& /*canvas*/, double /*width*/,
                                       double /*height*/) const override {
        return {};
    }
    void draw(Canvas& canvas, const CanvasBox& frame) const override {
        canvas.draw(chequered(), frame);
    }
};

Page sample_page() {
    Page page;
    page.columns = 2;
    page.width = 400.0;
    Plot plot;
    plot.x = {.label = "波長 (m)", .logarithmic = true};
    plot.y = {.label = "Profile of fifty ripples (mm)"};
    plot.series = {series_of("flights", 30, [](double x) { return 1.0 + x; }),
                   series_of("fit", 30, [](double x) { return 1.5 - x; })};
    plot.series[1].kind = SeriesKind::line_and_points;
    page.panels.push_back(panel_of(plot, "Wavelength"));
    PagePanel image;
    image.content = std::make_unique<ImagePanel>();
    page.panels.push_back(std::move(image));
    return page;
}

const FigureMetadata& sample_metadata() {
    static const FigureMetadata metadata{
        {"Title", "風紋 & (ripples) <1 mm>"},
        {"Software", "fumon 1"},
        {"fumon:scene", "title = \"a \\\" b\" # é\r\n\t[model]\nname = 'sand' ]]> &amp; (\\)\n"},
        {"fumon:empty", ""}};
    return metadata;
}

TEST(FigureFile, IsTheSameBytesAgain) {
    for (const PageFormat format : formats) {
        const std::string first = draw_page(sample_page(), format, 150.0, sample_metadata()).bytes;
        Canvas between(PageFormat::svg, 50.0, 50.0, 72.0, 8.0);
        between.draw(chequered(), {0, 0, 50, 50});
        between.bytes();
        EXPECT_TRUE(draw_page(sample_page(), format, 150.0, sample_metadata()).bytes == first);
    }
}

TEST(FigureFile, CarriesItsMetadata) {
    for (const PageFormat format : formats) {
        const std::string bytes = draw_page(sample_page(), format, 50.0, sample_metadata()).bytes;
        EXPECT_EQ(read_figure_metadata(bytes, "figure"), sample_metadata());
        const FigureMetadata plain{{"Software", "fumon 1"}};
        EXPECT_EQ(read_figure_metadata(draw_page(sample_page(), format, 50.0, plain).bytes, ""),
                  plain);
        EXPECT_TRUE(
            read_figure_metadata(draw_page(sample_page(), format, 50.0, {}).bytes, "").empty());
    }
}

TEST(FigureFile, RefusesMetadataThatItCannotCarryOrRead) {
    Canvas canvas(PageFormat::svg, 50.0, 50.0, 72.0, 8.0);
    canvas.set_metadata({{"fumon:scene", std::string("a\1b")}});
    EXPECT_NE(message_of<Error>([&] { canvas.bytes(); }).find("control character"),
              std::string::npos);
    Canvas page(PageFormat::pdf, 50.0, 50.0, 72.0, 8.0);
    page.set_metadata({{"fumon:scene", "a\xff"}});
    EXPECT_NE(message_of<Error>([&] { page.bytes(); }).find("not UTF-8"), std::string::npos);
    EXPECT_EQ(message_of<InputError>([] { read_figure_metadata("GIF89a", "a.gif"); }),
              "a.gif: is neither a PDF, an SVG, a PNG, a TIFF nor an EPS file");
    std::string damaged = draw_page(sample_page(), PageFormat::svg, 72.0, sample_metadata()).bytes;
    damaged.resize(damaged.find("</text>"));
    EXPECT_EQ(message_of<InputError>([&] { read_figure_metadata(damaged, "a.svg"); }),
              "a.svg: its metadata are damaged");
}

TEST(FigureFile, AsPdfIsReadByPoppler) {
    const test::TemporaryFolder folder;
    const DrawnPage page = draw_page(sample_page(), PageFormat::pdf, 72.0, sample_metadata());
    const std::string file = folder.file("figure.pdf", page.bytes).string();
    const std::string info = said_by("pdfinfo " + file);
    EXPECT_NE(info.find("Title:           風紋 & (ripples) <1 mm>"), std::string::npos) << info;
    EXPECT_NE(info.find("Creator:         fumon 1"), std::string::npos);
    EXPECT_NE(info.find("Pages:           1"), std::string::npos);
    EXPECT_NE(page.bytes.find("/CreationDate (20000101000000Z)"), std::string::npos) << info;
    EXPECT_NE(info.find("Page size:       400 x "), std::string::npos);
    std::string text = said_by("pdftotext -raw " + file + " -");
    std::replace(text.begin(), text.end(), '\n', ' ');  // as which upright words end
    for (const char* word : {"(a) Wavelength", "(b)", "波長 (m)", "Profile of fifty ripples (mm)",
                             "flights", "10⁻¹", "1.5"})
        EXPECT_NE(text.find(word), std::string::npos) << word << " is not in " << text;
    const std::string images = said_by("pdfimages -list " + file);
    EXPECT_NE(images.find("rgb"), std::string::npos) << images;
}

TEST(FigureFile, HoldsImagesWithTheirOwnPixelsUnlessTheyAreCoarse) {
    const test::TemporaryFolder folder;
    for (const auto& [size, dots_per_inch, copies] : {std::tuple{72.0 * 6 / 400, 300.0, 1},
                                                      {72.0 * 6 / 50, 300.0, 6},
                                                      {72.0 * 6 / 50, 600.0, 12}}) {
        Canvas canvas(PageFormat::pdf, 100.0, 100.0, dots_per_inch, 8.0);
        canvas.draw(chequered(), {10.0, 10.0, size, size / 1.5});
        const std::string file = folder.file("figure.pdf", canvas.bytes()).string();
        said_by("pdfimages -png " + file + " " + (folder / "image").string());
        const Image image = read_png(folder / "image-000.png");
        ASSERT_EQ(image.width, 6 * copies);
        ASSERT_EQ(image.height, 4 * copies);
        const Image original = chequered();
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x)
                EXPECT_TRUE(std::equal(image.row(y) + 3 * x, image.row(y) + 3 * x + 3,
                                       original.row(y / copies) + 3 * (x / copies)));
        }
    }
}

/// The largest difference of the mean colour of patches of 10 by 10 pixels.
double largest_difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    if (a.rgb.size() != b.rgb.size()) return 255.0;
    constexpr int patch = 10;
    double largest = 0.0;
    for (int y = 0; y + patch <= a.height; y += patch) {
        for (int x = 0; x + patch <= a.width; x += patch) {
            double sum = 0.0;
            for (int i = 0; i < patch; ++i) {
                for (int j = 3 * x; j < 3 * (x + patch); ++j)
                    sum += a.row(y + i)[j] - b.row(y + i)[j];
            }
            largest = std::max(largest, std::abs(sum) / (3.0 * patch * patch));
        }
    }
    return largest;
}

TEST(FigureFile, ShowsTheSameInEveryFormat) {
    const test::TemporaryFolder folder;
    Page page = sample_page();
    page.height = 180.0;
    const auto file = [&](PageFormat format, const std::string& name) {
        return folder.file(name, draw_page(page, format, 144.0, {}).bytes).string();
    };
    const Image png = read_png(file(PageFormat::png, "a.png"));
    EXPECT_EQ(png.width, 800);
    EXPECT_EQ(png.height, 360);
    const std::string out = (folder / "from").string();
    said_by("rsvg-convert -w 800 -h 360 -o " + out + "-svg.png " + file(PageFormat::svg, "a.svg"));
    said_by("pdftoppm -r 144 -png -singlefile " + file(PageFormat::pdf, "a.pdf") + " " + out +
            "-pdf");
    constexpr double smoothing = 25.0;  // of letters' and lines' edges, of 255
    EXPECT_LT(largest_difference(png, read_png(out + "-svg.png")), smoothing);
    EXPECT_LT(largest_difference(png, read_png(out + "-pdf.png")), smoothing);
}

TEST(FigureFile, NamesATextThatNoFontCanWrite) {
    Canvas canvas(PageFormat::pdf, 200.0, 50.0, 72.0, 8.0);
    canvas.write("height (m)", {10, 10}, {0, 0}, {});
    EXPECT_EQ(canvas.missing_letters(), "");
    canvas.write("never \U0010FFFD", {10, 30}, {0, 0}, {});
    EXPECT_NE(canvas.missing_letters().find("\"never \U0010FFFD\""), std::string::npos);
    EXPECT_NE(canvas.missing_letters().find("package fonts-"), std::string::npos);
}

TEST(FigureFile, RefusesASizeThatCairoCannotHold) {
    EXPECT_THROW(Canvas(PageFormat::png, 1e7, 1e7, 300.0, 8.0), Error);
}

TEST(SvgIds, CountFromOneWhereverTheyAreUsed) {
    EXPECT_EQ(with_counted_ids("<g id=\"surface12\"/><image id=\"image14\"/>"
                               "<use xlink:href=\"#image14\"/><use fill=\"url(#surface12)\"/>"
                               "<symbol id=\"glyph0-3\"/><use xlink:href=\"#glyph0-3\"/>"
                               "<g id=\"surface9\" fill=\"#123456\"/>"),
              "<g id=\"surface1\"/><image id=\"image1\"/>"
              "<use xlink:href=\"#image1\"/><use fill=\"url(#surface1)\"/>"
              "<symbol id=\"glyph0-3\"/><use xlink:href=\"#glyph0-3\"/>"
              "<g id=\"surface2\" fill=\"#123456\"/>");
    // As Cairo writes them since 1.17.
    EXPECT_EQ(with_counted_ids(
                  "<g id=\"source-5\"/><use xlink:href=\"#source-5\"/><g id=\"glyph-0-1\"/>"),
              "<g id=\"source-1\"/><use xlink:href=\"#source-1\"/><g id=\"glyph-0-1\"/>");
}

}  // namespace
}  // namespace fumon
