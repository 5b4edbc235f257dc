#include <gtest/gtest.h>

#include <string>

#include "support/figure_of_runs.h"

namespace fumon::test {
namespace {

/// Figures whose words are in another language.
class FigureLanguageTest : public FigureTest {
  protected:
    /// A map, a profile and a plot of a model in years and metres, its letters as text.
    Ended figure_with(const std::string& keys, const std::string& image = "") {
        write_text(folder_ / "dunes.toml",
                   "[model]\nname = \"dunes\"\n[grid]\nnx = 24\nny = 16\n[run]\nsteps = 4\n" +
                       image + "[figure]\nformats = [\"svg\", \"pdf\"]\nsvg_text = \"text\"\n" +
                       keys +
                       "[[figure.panel]]\nkind = \"map\"\nsteps = [4]\ntitle = \"{time:yr}\"\n"
                       "arrow = \"wind-and-north\"\nscale_bar = true\n"
                       "[[figure.panel]]\nkind = \"profile\"\nsteps = [0, 4]\n"
                       "[[figure.panel]]\nkind = \"plot\"\n[[figure.panel.curve]]\nx = \"time\"\n"
                       "y = \"standard_deviation\"\nspread = \"deviation\"\nseeds = 2\n");
        return figure("dunes.toml");
    }
    [[nodiscard]] bool page_has(const std::string& words) const {
        const std::string page = text("out/dunes.svg");  // which has the scene's text, too
        return page.find(words, page.find("</metadata>")) != std::string::npos;
    }
    [[nodiscard]] std::string caption() const { return text("out/dunes.caption.txt"); }
};

TEST_F(FigureLanguageTest, JapaneseHasEveryWordAndUnitThatFumonWrites) {
    const Ended ended = figure_with("language = \"ja\"\n");
    ASSERT_EQ(ended.status, 0) << ended.errors;
    for (const char* words :
         {"風", "北", " 年", "高さ (m)", "高さ ", "時間 (", "年)", "標準偏差 (m)"})
        EXPECT_TRUE(page_has(words)) << words;
    for (const char* words : {"wind", "heights", " yr", "yr)", "standard", "height ("})
        EXPECT_FALSE(page_has(words)) << words;
    for (const char* words :
         {"ステップ 4", "乱数の種 1–2", "誤差棒は標準偏差, n = 2", "共通：", "色の範囲"})
        EXPECT_NE(caption().find(words), std::string::npos) << words << "\n" << caption();
    const std::string first = text("out/dunes.pdf");
    ASSERT_EQ(fumon({"again", "out/dunes.pdf", "-o", "again.pdf"}, folder_.path()).status, 0);
    EXPECT_EQ(text("again.pdf"), first);
}

TEST_F(FigureLanguageTest, AFileOfOnesOwnTakesThePlaceOfWords) {
    write_text(folder_ / "mine.toml",
               "[words]\n\"wind\" = \"卓越風\"\n[names]\n\"standard deviation\" = \"粗度\"\n");
    ASSERT_EQ(figure_with("language = \"ja\"\nwords = \"mine.toml\"\n").status, 0);
    EXPECT_TRUE(page_has("卓越風") && page_has("粗度 (m)") && page_has("年)"));
    std::filesystem::remove(folder_ / "mine.toml");
    EXPECT_EQ(fumon({"again", "out/dunes.pdf", "-o", "again.pdf"}, folder_.path()).status, 0)
        << "the figure holds the file";
    EXPECT_EQ(text("again.pdf"), text("out/dunes.pdf"));
    write_text(folder_ / "mine.toml", "[words]\n\"wint\" = \"風\"\n");
    const Ended wrong = figure_with("words = \"mine.toml\"\n");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.errors.find("mine.toml:2:10: fumon does not write \"wint\""), std::string::npos)
        << wrong.errors;
}

TEST_F(FigureLanguageTest, IsThatOfPicturesWhereTheFigureSaysNone) {
    ASSERT_EQ(
        figure_with("", "[image]\nlanguage = \"ja\"\nwords = [\"words: wind = 卓越風\"]\n").status,
        0);
    EXPECT_TRUE(page_has("卓越風") && page_has("年)"));
    ASSERT_EQ(figure_with("language = \"en\"\n", "[image]\nlanguage = \"ja\"\n").status, 0);
    EXPECT_TRUE(page_has("wind") && page_has("yr)"));
    const Ended wrong = figure_with("language = \"jp\"\n");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_NE(wrong.errors.find("figure.language: fumon has no translation \"jp\"; it has en, "
                                "ja"),
              std::string::npos)
        << wrong.errors;
}

}  // namespace
}  // namespace fumon::test
