#include "figure/words/words.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "base/error.h"
#include "figure/words/chosen_words.h"

namespace fumon {
namespace {

std::string refusal_of(std::string_view text) {
    try {
        parse_word_table(text, "my.toml");
    } catch (const InputError& fault) {
        return fault.what();
    }
    return {};
}

TEST(Words, EveryLanguageHasEveryWordAndUnit) {
    for (const std::string& language : word_languages()) {
        if (language == "en") continue;
        const WordTable table = words_of_language(language);
        for (const std::string_view english : english_words)
            EXPECT_FALSE(table.words.contains(english) ? table.words.find(english)->second.empty()
                                                       : true)
                << language << " lacks the word " << english;
        for (const std::string_view unit : english_units)
            EXPECT_TRUE(table.units.contains(unit)) << language << " lacks the unit " << unit;
    }
}

TEST(Words, AreThoseOfTheThreadsLanguageWhileItSpeaksIt) {
    EXPECT_EQ(word("wind"), "wind");
    {
        const LanguageScope speaking(std::make_shared<const WordTable>(words_of_language("ja")));
        EXPECT_EQ(word("wind"), "風");
        EXPECT_EQ(phrase("heights × {}", "20"), "高さ 20 倍");
        EXPECT_EQ(unit_word("yr"), "年");
        EXPECT_EQ(unit_word("m"), "m");
        EXPECT_EQ(labelled("height", "m"), "高さ (m)");
        EXPECT_EQ(quantity_in_words("standard_deviation", "m"), "標準偏差 (m)");
        EXPECT_EQ(quantity_in_words("mill_discharge_m3s", "m3/s"), "mill discharge (m3/s)");
        {
            const LanguageScope english(nullptr);
            EXPECT_EQ(word("wind"), "wind");
        }
        EXPECT_EQ(quantity_in_words("dune_count", ""), "砂丘の数");
    }
    EXPECT_EQ(quantity_in_words("standard_deviation", "m"), "standard deviation (m)");
}

TEST(Words, OfOnesOwnTakeThePlaceOfSingleOnes) {
    const WordTable own =
        parse_word_table("[words]\n\"wind\" = \"卓越風\"\n[units]\nyr = \"ヶ年\"\n", "my.toml");
    const WordTable table = with_words(words_of_language("ja"), own);
    EXPECT_EQ(table.words.at("wind"), "卓越風");
    EXPECT_EQ(table.units.at("yr"), "ヶ年");
    EXPECT_EQ(table.words.at("flow"), "流れ");
}

TEST(Words, ThatFumonDoesNotWriteAreRefusedWithTheirPlace) {
    EXPECT_EQ(refusal_of("[words]\n\"wint\" = \"風\"\n"),
              "my.toml:2:10: fumon does not write \"wint\"; did you mean \"wind\"?");
    EXPECT_NE(refusal_of("[words]\n\"heights × {}\" = \"高さ倍\"\n")
                  .find("must have the placeholders of \"heights × {}\": {}"),
              std::string::npos);
    EXPECT_NE(refusal_of("[word]\n").find("has [words], [units] and [names]"), std::string::npos);
    EXPECT_NE(refusal_of("[words]\n\"wind\" = 3\n").find("my.toml:2:10: a word is a text"),
              std::string::npos);
    EXPECT_NE(refusal_of("[words\n").find("my.toml:1"), std::string::npos);
    EXPECT_THROW(words_of_language("xx"), InputError);
}

TEST(Words, OfPicturesAreEntriesThatTheSceneHolds) {
    ImageSettings image;
    EXPECT_EQ(picture_words(image), nullptr);
    image.language = "ja";
    image.words = {"words: wind = 卓越風", "units: yr = ヶ年", "names: dune height = 比高"};
    const auto table = picture_words(image);
    EXPECT_EQ(table->words.at("wind"), "卓越風");
    EXPECT_EQ(table->units.at("yr"), "ヶ年");
    EXPECT_EQ(table->names.at("dune height"), "比高");
    EXPECT_EQ(table->words.at("flow"), "流れ");
    image.words = {"words: heights × {} = {:999999999}"};
    EXPECT_THROW(picture_words(image), KeyError);
    image.words = {"words: wint = 風"};
    EXPECT_THROW(picture_words(image), KeyError);
    image.words = {"wind = 風"};
    EXPECT_THROW(picture_words(image), KeyError);
    image.words.clear();
    image.language = "xx";
    EXPECT_THROW(picture_words(image), KeyError);
}

}  // namespace
}  // namespace fumon
