// Figures for a journal, and the formats for press.

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "scene/figure/journals.h"
#include "scene/read.h"
#include "support/figure_of_runs.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

using FigureForJournal = FigureTest;

const char* const plain = R"(
[model]
name = "sand"
[grid]
nx = 16
ny = 12
[run]
steps = 2
)";

std::string panels(const std::string& figure) {
    return std::string(plain) + "[figure]\n" + figure +
           "[[figure.panel]]\nkind = \"map\"\nx_label = \"along\"\n";
}

TEST(Journals, SayWhereTheyWereRead) {
    ASSERT_GE(journals().size(), 4U);
    const Journal& any = journals().front();
    EXPECT_EQ(any.least_letters, 6.0);
    EXPECT_EQ(any.least_lines, 0.25);
    for (const Journal& journal : journals()) {
        if (journal.name.empty()) continue;
        EXPECT_FALSE(journal.pages.empty()) << journal.name;
        EXPECT_GE(journal.read, 2026) << journal.name;
    }
    EXPECT_EQ(find_journal("nature")->single, 89.0);
    EXPECT_EQ(find_journal("nowhere"), nullptr);
}

TEST(Journals, SetWhatASceneDoesNot) {
    const auto figure = [](const std::string& keys) {
        return parse_scene(panels(keys), "a.toml", "", {}).figure;
    };
    const FigureSettings nature = figure("journal = \"nature\"\nwidth = \"single\"\n");
    EXPECT_EQ(nature.width.value, 89.0);
    EXPECT_EQ(nature.font_size, 7.0);
    EXPECT_EQ(nature.dots_per_inch, 300.0);
    const FigureSettings elsevier = figure("journal = \"elsevier\"\n");
    EXPECT_EQ(elsevier.width.value, 190.0);
    EXPECT_DOUBLE_EQ(elsevier.font_size, 8.6);  // whose raised letters have 6.02
    EXPECT_EQ(elsevier.dots_per_inch, 500.0);
    const FigureSettings own =
        figure("journal = \"nature\"\nwidth = 100\nfont_size = 9\ndots_per_inch = 72\n");
    EXPECT_EQ(own.width.value, 100.0);
    EXPECT_EQ(own.font_size, 9.0);
    EXPECT_EQ(own.dots_per_inch, 72.0);
    EXPECT_EQ(figure("journal = \"agu\"\n").width.word, "double") << "its page names no width";
    EXPECT_EQ(figure("").font_size, 8.0);
    EXPECT_NE(message_of<InputError>([&] {
                  figure("journal = \"natur\"\n");
              }).find("figure.journal: unknown journal \"natur\"; did you mean \"nature\"?"),
              std::string::npos);
}

TEST_F(FigureForJournal, IsToldWhatWouldBeSentBack) {
    write_text(folder_ / "bad name.toml",
               panels("journal = \"nature\"\nwidth = 200\nheight = 180\nfont_size = 5\n"
                      "dots_per_inch = 200\nformats = [\"tif\"]\n"));
    const Ended bad = fumon({"figure", "bad name.toml", "--check"}, folder_.path());
    EXPECT_EQ(bad.status, 1) << bad.errors;
    for (const char* part :
         {"figure.width: the page is 200 mm wide (Nature: 183 at most)",
          "figure.height: the page is 180 mm high (Nature: 170 at most)",
          "figure.font_size: ticks and legends are of 4.25 points (Nature: 5 or more); 5.9 does it",
          "figure.dots_per_inch: its pixels have 200 dots per inch (Nature: 300 or more)",
          "figure.panel.0.x_label: \"along\" has no unit in brackets (Nature: \"Data (unit)\")",
          "its files are called \"bad name\"", "bad name.toml:11:",
          "6 things to send back by the rules of Nature, read in 2026 at "
          "http://research-figure-guide.nature.com/"})
        EXPECT_NE(bad.output.find(part), std::string::npos) << part << "\n" << bad.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "runs"));
    write_text(folder_ / "good.toml", panels(""));
    const Ended good = fumon({"figure", "good.toml", "--check"}, folder_.path());
    EXPECT_EQ(good.status, 0) << good.output;
    EXPECT_EQ(good.output,
              "good.toml: nothing to send back by what nearly all journals ask "
              "(figure.journal names one)\n");
    EXPECT_EQ(fumon({"figure", "good.toml"}, folder_.path()).status, 2);
    const Ended thin =
        fumon({"figure", "good.toml", "--check", "--set", "figure.line_width=0.3"}, folder_.path());
    EXPECT_NE(thin.output.find(
                  "frames and ticks are 0.15 points wide (journals: 0.25 or more); 0.5 does it"),
              std::string::npos)
        << thin.output;
}

TEST_F(FigureForJournal, IsMadeAgainFromEveryFormat) {
    write_text(folder_ / "a.toml",
               panels("dots_per_inch = 60\npdf_standard = \"a-2b\"\nformats = [\"pdf\", \"tif\", "
                      "\"eps\"]\n"));
    const Ended ended = figure("a.toml");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    for (const char* end : {".pdf", ".tif", ".eps"}) {
        const std::string file = std::string("out/a") + end;
        const Ended again = fumon({"again", file}, folder_.path());
        EXPECT_EQ(again.status, 0) << again.errors;
        EXPECT_NE(again.errors.find("the same bytes as " + file), std::string::npos)
            << again.errors;
        EXPECT_EQ(figure("a.toml").status, 0) << "replaces its own";
    }
    const std::string eps = text("out/a.eps");
    EXPECT_TRUE(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n")) << eps.substr(0, 40);
    EXPECT_EQ(eps.find("CreationDate"), std::string::npos);
    EXPECT_NE(eps.find("%%BoundingBox: 0 0 497 "), std::string::npos) << eps.substr(0, 300);
    const Ended no = figure("a.toml", {"--set", "figure.icc_profile=a.toml"}, "other");
    EXPECT_EQ(no.status, 2);
    EXPECT_NE(no.errors.find("is not an ICC profile"), std::string::npos) << no.errors;
}

}  // namespace
}  // namespace fumon::test
