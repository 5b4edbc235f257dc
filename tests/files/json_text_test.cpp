#include "files/json_text.h"

#include <gtest/gtest.h>

#include <string>

namespace fumon {
namespace {

std::string nested(std::size_t depth, const std::string& open, const std::string& close) {
    std::string text;
    for (std::size_t n = 0; n < depth; ++n) text += open;
    text += "1";
    for (std::size_t n = 0; n < depth; ++n) text += close;
    return text;
}

TEST(JsonText, ReadsValues) {
    const auto json = parse_json(R"({"b": [1, 2.5, "\"]"], "a": null})");
    EXPECT_EQ(json.at("b").at(2), "\"]");
    EXPECT_EQ(json.begin().key(), "b");
}

TEST(JsonText, WhatIsNoJsonThrowsWhenItIsAsked) {
    for (const char* text : {"", "{", "[1,]", "nonsense", "\"\\", "{\"a\": 1} 2"}) {
        const auto json = parse_json(text);
        EXPECT_FALSE(json.contains("a")) << text;
        EXPECT_THROW(static_cast<void>(json.at("a")), nlohmann::json::exception) << text;
        EXPECT_THROW(for (const auto& item
                          : json) static_cast<void>(item.at("a")),
                     nlohmann::json::exception)
            << text;
    }
}

TEST(JsonText, WholeNumbersHaveNoFractionAndNoExponent) {
    EXPECT_EQ(whole_number(parse_json("-9223372036854775808")), INT64_MIN);
    EXPECT_EQ(whole_numbers(parse_json("[0, 7]")), (std::vector<std::int64_t>{0, 7}));
    for (const char* text : {"1e300", "1.0", "true", "\"1\"", "null", "[1]"})
        EXPECT_THROW(whole_number(parse_json(text)), nlohmann::json::exception) << text;
    for (const char* text : {"[1e300]", "1", "{\"a\": 1}", "nonsense"})
        EXPECT_THROW(whole_numbers(parse_json(text)), nlohmann::json::exception) << text;
}

TEST(JsonText, DeepNestingIsRefusedBeforeItIsCopiedByRecursion) {
    EXPECT_FALSE(parse_json(nested(deepest_json, "[", "]")).is_discarded());
    EXPECT_TRUE(parse_json(nested(deepest_json + 1, "[", "]")).is_discarded());
    EXPECT_TRUE(parse_json(nested(400000, "{\"a\":", "}")).is_discarded());
    EXPECT_FALSE(parse_json("\"" + nested(1000, "[", "]") + "\\\"[\"").is_discarded());
}

}  // namespace
}  // namespace fumon
