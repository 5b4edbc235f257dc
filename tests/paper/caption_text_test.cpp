#include "paper/caption/caption_text.h"

#include <gtest/gtest.h>

namespace fumon {
namespace {

constexpr const char* marked_caption =
    "A_b, 50 % & #1 {x} ~ \\ m^2 over L_{0} and N_{xy}: \u22125 × 10^{\u22123} $.\n\n(a): \"grey\" "
    "<i> *.\n";

TEST(CaptionText, IsPlainWithTheNumbersOfUnicode) {
    EXPECT_EQ(
        plain_caption(marked_caption),
        "A_b, 50 % & #1 {x} ~ \\ m² over L₀ and N_xy: \u22125 × 10⁻³ $.\n\n(a): \"grey\" <i> *.\n");
}

TEST(CaptionText, IsOneParagraphOfLatexThatReadsItsCommandsNowhere) {
    EXPECT_EQ(latex_caption(marked_caption),
              "A\\_b, 50 \\% \\& \\#1 \\{x\\} \\textasciitilde{} \\textbackslash{} "
              "m\\textsuperscript{2} over L\\textsubscript{0} and N\\textsubscript{xy}: $-$5 "
              "$\\times$ 10\\textsuperscript{$-$3} \\$.\n(a): ''grey'' "
              "\\textless{}i\\textgreater{} *.\n");
}

TEST(CaptionText, IsMarkdownThatMarksNothingByAccident) {
    EXPECT_EQ(
        markdown_caption(marked_caption),
        "A\\_b, 50 % &amp; #1 {x} ~ \\\\ m<sup>2</sup> over L<sub>0</sub> and "
        "N<sub>xy</sub>: \u22125 × 10<sup>\u22123</sup> $.\n\n(a): \"grey\" &lt;i&gt; \\*.\n");
}

}  // namespace
}  // namespace fumon
