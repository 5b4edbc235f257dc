#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace fumon {
namespace {

TEST(Utf8, TakesEveryLengthOfCharacter) {
    EXPECT_TRUE(is_utf8(""));
    EXPECT_TRUE(is_utf8("plain"));
    EXPECT_TRUE(is_utf8(std::string("\0", 1)));
    EXPECT_TRUE(is_utf8("風紋 é 🏜"));
    for (const char* edge : {"\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                             "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
        EXPECT_TRUE(is_utf8(edge)) << edge;
}

TEST(Utf8, RefusesWhatIsNone) {
    for (const char* wrong :
         {"\x80", "a\xBF", "\xC0\xAF", "\xC1\xBF", "\xC3", "\xC3(", "\xE0\x9F\xBF", "\xE2\x82",
          "\xE2\x28\xA1", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF", "\xF0\x9F\x8F", "\xF4\x90\x80\x80",
          "\xF5\x80\x80\x80", "\xFE", "\xFF", "ok\xFF"})
        EXPECT_FALSE(is_utf8(wrong)) << wrong;
}

/// Every character, encoded by the plain rule, and every one with a byte missing.
TEST(Utf8, AgreesWithTheEncodingOfEveryCharacter) {
    for (unsigned code = 0x80; code <= 0x10FFFF; ++code) {
        std::string text;
        const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
        if (code < 0x800) {
            add(0xC0 | code >> 6);
        } else if (code < 0x10000) {
            add(0xE0 | code >> 12);
            add(0x80 | (code >> 6 & 0x3F));
        } else {
            add(0xF0 | code >> 18);
            add(0x80 | (code >> 12 & 0x3F));
            add(0x80 | (code >> 6 & 0x3F));
        }
        add(0x80 | (code & 0x3F));
        const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
        ASSERT_EQ(is_utf8(text), !surrogate) << code;
        text.pop_back();
        ASSERT_FALSE(is_utf8(text)) << code;
    }
}

TEST(Utf8, TellsTheLengthOfTheCharacterAtTheStart) {
    EXPECT_EQ(utf8_length("a風"), 1U);
    EXPECT_EQ(utf8_length("éa"), 2U);
    EXPECT_EQ(utf8_length("風紋"), 3U);
    EXPECT_EQ(utf8_length("🏜 "), 4U);
    EXPECT_EQ(utf8_length("\xE2\x82"), 0U);
    EXPECT_EQ(utf8_length(""), 0U);
}

}  // namespace
}  // namespace fumon
