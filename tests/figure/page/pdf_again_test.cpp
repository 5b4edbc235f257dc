// What a PDF says of its figure, after other programs have written it anew.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "figure/canvas/canvas.h"
#include "figure/canvas/figure_metadata.h"
#include "figure/canvas/pdf_strings.h"
#include "support/command.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;

/// With brackets, backslashes and Japanese.
const FigureMetadata& pdf_texts() {
    static const FigureMetadata made{{"Title", "風紋 (ripples) \\ <1 mm>"},
                                     {"Software", "fumon 1"},
                                     {"fumon:scene", "title = \"a \\\" b\" # é\r\n[model]\n"}};
    return made;
}

std::string pdf_page(const FigureMetadata& metadata) {
    Canvas canvas(PageFormat::pdf, 100.0, 50.0, 72.0, 8.0);
    canvas.write("a page", {50.0, 25.0}, {0.5, 0.5}, black_ink);
    canvas.set_metadata(metadata);
    return canvas.bytes();
}

FigureMetadata read_pdf(const std::string& bytes) {
    return read_figure_metadata(bytes, "a.pdf");
}

TEST(PdfStrings, AreReadInAllTheirForms) {
    EXPECT_EQ(pdf_string("(a (b) c) d)"), "a (b) c");
    EXPECT_EQ(pdf_string(R"((\(\)\\\n\101\0532\q))"), "()\\\nA+2q");
    EXPECT_EQ(pdf_string("(a\\\r\nb\r\nc)"), "ab\nc");
    EXPECT_EQ(pdf_string("<41 4\n2 4>"), "AB@");
    EXPECT_EQ(pdf_string("<feff98A87d0b d83DDE00>"), "風紋😀");
    EXPECT_EQ(pdf_string(R"((\376\377\0a\0\)))"), "a)");
    EXPECT_EQ(pdf_string("(\xEF\xBB\xBF\xC3\xA9)"), "é");
    for (const char* none : {"", "(a", "(a\\", "<41", "<4G>", "/Name", "(\\)"})
        EXPECT_EQ(pdf_string(none), "") << none;
}

TEST(PdfMetadata, IsFoundInStringsAndXmpOfOthers) {
    const std::string info = "[[\"Software\",\"fumon 1\"]]";
    const FigureMetadata own{{"Software", "fumon 1"}};
    EXPECT_EQ(read_pdf("%PDF-1.4\n1 0 obj\n<</Keywords(" + info + ")>>\nendobj"), own);
    EXPECT_EQ(read_pdf("%PDF-1.4\n7 0 obj\n(" + info + ")\nendobj\n1 0 obj\n<</Keywords 7 0 R>>"),
              own);
    EXPECT_EQ(read_pdf("%PDF-1.4\n1 0 obj\n<</Keywords(" + info + ")>>\n2 0 obj <</Keywords(x)>>"),
              own);
    EXPECT_EQ(
        read_pdf("%PDF-1.4\n3 0 obj\n<</Type/Metadata/Subtype/XML/Length 9>>\nstream\r\n"
                 "<rdf:Description pdf:Keywords='[[&quot;Software&quot;,&#34;fumon 1&#x22;]]'/>\n"
                 "endstream"),
        own);
    EXPECT_TRUE(read_pdf("%PDF-1.4\n1 0 obj\n<</Keywords(sand, wind)>>").empty());
    EXPECT_TRUE(
        read_pdf("%PDF-1.5\n3 0 obj\n<</Type/ObjStm/Filter/FlateDecode>>\nstream\nno").empty());
    EXPECT_EQ(message_of<InputError>([] { read_pdf("%PDF-1.4\ntrailer <</Encrypt 9 0 R>>"); }),
              "a.pdf: is encrypted; take a copy that is not (qpdf --decrypt)");
    EXPECT_EQ(message_of<InputError>([] { read_pdf("%PDF-1.4\n<</Keywords([[\"a)>>"); }),
              "a.pdf: its metadata are damaged");
}

/// Longer than a string of PDF/A may be.
FigureMetadata long_texts() {
    FigureMetadata metadata = pdf_texts();
    std::string numbers;
    for (int i = 0; i < 20'000; ++i) numbers += fmt::format("({})\n", i % 97);
    metadata.emplace_back("fumon:figure", numbers);
    return metadata;
}

TEST(PdfMetadata, IsShortWhereItWouldBeTooLongForReaders) {
    const std::string bytes = pdf_page(long_texts());
    EXPECT_EQ(read_pdf(bytes), long_texts());
    const std::size_t at = bytes.rfind("/Keywords (");
    ASSERT_NE(at, std::string::npos);
    EXPECT_LT(pdf_string(bytes.substr(at + 10)).size(), 32'768U);
    EXPECT_TRUE(read_pdf("%PDF-1.4\n<</Keywords(deflate:AAAA)>>").empty());
}

class PdfAfterOthers : public testing::TestWithParam<bool> {};

TEST_P(PdfAfterOthers, HasItsMetadata) {
    const FigureMetadata texts = GetParam() ? long_texts() : pdf_texts();
    const test::TemporaryFolder folder;
    const std::string from = folder.file("a.pdf", pdf_page(texts)).string();
    const std::string to = (folder.path() / "b.pdf").string();
    bool tried = false;
    const auto is_there = [&](const char* program) {
        const bool there = test::run_command(fmt::format("command -v {}", program)).status == 0;
        tried = tried || there;
        return there;
    };
    std::vector<std::string> commands;
    if (is_there("qpdf")) {
        for (const char* how : {"--linearize", "--object-streams=generate", "--qdf",
                                "--stream-data=uncompress --object-streams=generate"})
            commands.push_back(fmt::format("qpdf {} {} {}", how, from, to));
    }
    if (is_there("gs"))
        commands.push_back(
            fmt::format("gs -q -dNOPAUSE -dBATCH -sDEVICE=pdfwrite -sOutputFile={} {}", to, from));
    for (const std::string& command : commands) {
        const test::Spoken spoken = test::run_command(command);
        ASSERT_EQ(spoken.status, 0) << command << spoken.words;
        EXPECT_EQ(read_figure_metadata(test::bytes_of(to), to), texts) << command;
    }
    if (!tried) GTEST_SKIP() << "neither qpdf nor gs is here";
}

INSTANTIATE_TEST_SUITE_P(ShortAndLong, PdfAfterOthers, testing::Bool());

}  // namespace
}  // namespace fumon
