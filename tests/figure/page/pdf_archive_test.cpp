// PDF/A-2b: what ISO 19005-2 asks of a file, as far as it can be read off one.

#include "figure/canvas/pdf_archive.h"

#include <gtest/gtest.h>

#include <array>

#include "base/error.h"
#include "base/image.h"
#include "figure/canvas/canvas.h"
#include "figure/canvas/figure_metadata.h"
#include "figure/canvas/pdf_strings.h"
#include "picture/pixels/srgb_profile.h"
#include "picture/stills/xmp.h"
#include "support/command.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

const FigureMetadata archived_texts{
    {"Title", "風紋 & (ripples)"}, {"Software", "fumon 1"}, {"fumon:scene", "title = \"a\"\n"}};

std::string archived_page() {
    Canvas canvas(PageFormat::pdf, 100.0, 50.0, 72.0, 8.0);
    canvas.keep_for_archives();
    canvas.write("Latin, 風紋 − ×", {50.0, 25.0}, {0.5, 0.5}, black_ink);
    canvas.fill(CanvasBox{10, 10, 20, 20}, {0.2, 0.4, 0.6, 0.5});
    canvas.draw(Image(4, 4), {60, 10, 20, 20});
    canvas.set_metadata(archived_texts);
    return canvas.bytes();
}

bool holds(const std::string& bytes, std::string_view part) {
    return bytes.find(part) != std::string::npos;
}

TEST(PdfArchive, HasWhatTheStandardAsksFor) {
    const std::string pdf = archived_page();
    EXPECT_EQ(pdf, archived_page());
    EXPECT_EQ(read_figure_metadata(pdf, "a.pdf"), archived_texts);
    const std::string xmp = pdf_streams(pdf).xmp;
    EXPECT_EQ(xmp_value(xmp, "pdfaid:part"), "2");
    EXPECT_EQ(xmp_value(xmp, "pdfaid:conformance"), "B");
    EXPECT_EQ(xmp_value(xmp, "xmp:CreatorTool"), "fumon 1");
    EXPECT_EQ(xmp_value(xmp, "rdf:li"), "");
    EXPECT_TRUE(holds(xmp, ">風紋 &amp; (ripples)</rdf:li>"));
    const std::string keywords = xmp_value(xmp, "pdf:Keywords");
    EXPECT_EQ(keywords, pdf_metadata(archived_texts).keywords);
    EXPECT_EQ(keywords, pdf_string(pdf.substr(pdf.find("/Keywords ") + 10)))
        << "the document information says the same";
    for (const char* part :
         {"/S /GTS_PDFA1", "/OutputConditionIdentifier (sRGB IEC61966-2.1)", "/ID [ <",
          "/CreationDate (D:20000101000000Z)", "/CIDToGIDMap /Identity", "/FontFile2"})
        EXPECT_TRUE(holds(pdf, part)) << part;
    for (const char* part : {"/Encrypt", "/Interpolate true", "/JavaScript", "/DeviceCMYK",
                             "/LZWDecode", "/EmbeddedFile", "/AA", "/CIDSet"})
        EXPECT_FALSE(holds(pdf, part)) << part;
    EXPECT_EQ(pdf.substr(0, 7), "%PDF-1.");
    EXPECT_EQ(static_cast<unsigned char>(pdf[pdf.find('\n') + 2]) >> 7U, 1U)
        << "is marked as binary";
}

TEST(PdfArchive, IsAFileThatQpdfFindsWhole) {
    if (test::run_command("command -v qpdf").status != 0) GTEST_SKIP() << "qpdf is not here";
    const test::TemporaryFolder folder;
    const std::string file = folder.file("a.pdf", archived_page()).string();
    const test::Spoken checked = test::run_command("qpdf --check " + file);
    EXPECT_EQ(checked.status, 0) << checked.words;
}

TEST(PdfArchive, RefusesWhatCairoDoesNotWrite) {
    EXPECT_EQ(test::message_of<Error>([] { pdf_archive("%PDF-1.4\nstartxref\n9\n", {}); }),
              "cannot make a PDF/A file: the PDF of this version of Cairo is not supported");
    EXPECT_THROW(pdf_archive("", {}), Error);
    EXPECT_THROW(pdf_archive("xref\n0 9\nstartxref\n0\n", {}), Error);
}

TEST(SrgbProfile, AddsUpToWhite) {
    const std::string profile = srgb_profile();
    EXPECT_EQ(profile.size(), 2524U);
    EXPECT_EQ(profile.substr(12, 12), "mntrRGB XYZ ");
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8U | static_cast<unsigned char>(profile[i]);
    EXPECT_EQ(size, profile.size());
    const std::size_t curve = profile.find("curv");
    const auto value = [&](std::size_t i) {
        return static_cast<unsigned char>(profile[curve + 12 + 2 * i]) * 256 +
               static_cast<unsigned char>(profile[curve + 13 + 2 * i]);
    };
    EXPECT_EQ(value(0), 0);
    EXPECT_EQ(value(1023), 65535);
    EXPECT_NEAR(value(512) / 65535.0, 0.2145, 1e-4);  // of 512 / 1023
}

}  // namespace
}  // namespace fumon
