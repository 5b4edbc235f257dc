#include "figure/canvas/marked_text.h"

#include <gtest/gtest.h>

#include "figure/canvas/canvas.h"

namespace fumon {
namespace {

TEST(MarkedText, TakesTheMarksOutAndSaysWhatStandsWhere) {
    const MarkedText marked = read_marked_text("y = 2·10^{4} x^{−1.5} A_{s}");
    EXPECT_EQ(marked.letters, "y = 2·104 x−1.5 As");
    ASSERT_EQ(marked.parts.size(), 3U);
    const auto letters_of = [&](std::size_t n) {
        const RaisedPart& part = marked.parts[n];
        return marked.letters.substr(part.begin, part.end - part.begin);
    };
    EXPECT_EQ(letters_of(0), "4");
    EXPECT_EQ(letters_of(1), "−1.5");
    EXPECT_EQ(letters_of(2), "s");
    EXPECT_TRUE(marked.parts[1].raised);
    EXPECT_FALSE(marked.parts[2].raised);
}

TEST(MarkedText, WhatIsNoMarkStaysAsItIs) {
    for (const char* text :
         {"", "^", "a_b", "x^{2", "{x}", "^}_", "x^n", "^2", "x ^2", "L_0", "x^-"}) {
        EXPECT_EQ(read_marked_text(text).letters, text);
        EXPECT_TRUE(read_marked_text(text).parts.empty()) << text;
    }
}

TEST(MarkedText, RaisesASimplePower) {
    const MarkedText marked = read_marked_text("m^2 s^-1, (x)^10 m^−3");
    EXPECT_EQ(marked.letters, "m2 s−1, (x)10 m−3");
    ASSERT_EQ(marked.parts.size(), 4U);
    for (const RaisedPart& part : marked.parts) EXPECT_TRUE(part.raised);
    EXPECT_EQ(marked.letters.substr(marked.parts[1].begin, 4), "−1");
}

TEST(MarkedText, RaisedLettersAreSmallerAndTheirLineIsHigher) {
    const Canvas canvas(200, 100, 20.0);
    const auto plain = canvas.text_size("x2");
    for (const char* text : {"x^{2}", "x_{2}"}) {
        const auto size = canvas.text_size(text);
        EXPECT_LT(size[0], plain[0]) << text;
        EXPECT_GE(size[1], plain[1]) << text;
    }
    EXPECT_GT(canvas.text_size("x^{2}_{3}")[1], plain[1]);
}

TEST(MarkedText, IsReadFromThePageWithoutItsMarks) {
    Canvas canvas(200, 100, 20.0);
    canvas.write("A_{s}", {10.0, 10.0}, {0.0, 0.0}, black_ink);
    ASSERT_EQ(canvas.texts().size(), 1U);
    EXPECT_EQ(canvas.texts().front().text, "As");
}

}  // namespace
}  // namespace fumon
