#include "sweep/sweep_axis.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/temporary_folder.h"

namespace fumon::test {
namespace {

std::vector<std::string> values(const std::string& text) {
    std::vector<std::string> all;
    for (const Override& value : read_axis(text, "--over 1").values)
        all.push_back(plain_text(value));
    return all;
}

using Texts = std::vector<std::string>;

TEST(SweepAxis, ListsValuesAsTheyAreWritten) {
    EXPECT_EQ(values("k=0.10,1e-3, 5 ,word"), (Texts{"0.10", "1e-3", "5", "word"}));
    EXPECT_EQ(values("k=a.asc,b c.asc"), (Texts{"a.asc", "b c.asc"}));
    EXPECT_EQ(values("k=x=1"), (Texts{"x=1"})) << "the first = ends the key";
}

TEST(SweepAxis, ACommaInQuotesOrBracketsBelongsToItsValue) {
    EXPECT_EQ(values("k=\"a,b\",'c,\"d',e"), (Texts{"a,b", "c,\"d", "e"}));
    EXPECT_EQ(values("k=[1,2],[3, 4]"), (Texts{"[1,2]", "[3, 4]"}));
    EXPECT_EQ(values("k=[\"]\",1],2"), (Texts{"[\"]\",1]", "2"}));
    EXPECT_EQ(values("k=\"a\\\",b\",c"), (Texts{"a\",b", "c"})) << "an escaped quote ends nothing";
    EXPECT_EQ(values("k=it's,a[1]"), (Texts{"it's", "a[1]"})) << "inside a word they are letters";
}

TEST(SweepAxis, ARangeHasBothEndsAndShortNumbers) {
    EXPECT_EQ(values("k=0.1:0.5:5"), (Texts{"0.1", "0.2", "0.3", "0.4", "0.5"}));
    EXPECT_EQ(values("k=0:1:11")[3], "0.3");
    EXPECT_EQ(values("k=16:64:4"), (Texts{"16", "32", "48", "64"}));
    EXPECT_EQ(values("k=1:2:4"), (Texts{"1", "1.3333333333333333", "1.6666666666666667", "2"}));
    EXPECT_EQ(values("k=1:-1:3"), (Texts{"1", "0", "-1"})) << "downward too";
    EXPECT_EQ(values("k=1e-20:3e-20:3").back(), "3e-20");
    EXPECT_EQ(values("k=7:7:1"), (Texts{"7"}));
    for (int k = 0; k < 1000; ++k) {
        EXPECT_EQ(std::stod(values("k=0.001:1:1000")[static_cast<std::size_t>(k)]),
                  static_cast<double>(k + 1) / 1000.0);
        if (HasFailure()) break;
    }
}

TEST(SweepAxis, WhatOnlyLooksLikeARangeIsAWord) {
    EXPECT_EQ(values("k=a:b:c"), (Texts{"a:b:c"}));
    EXPECT_EQ(values("k=\"0:1:2\""), (Texts{"0:1:2"})) << "quoted";
}

TEST(SweepAxis, KeysCanGoTogether) {
    const SweepAxis axis = read_axis("grid.nx+grid.ny=8,16", "--over 1");
    EXPECT_EQ(axis.keys, (Texts{"grid.nx", "grid.ny"}));
    EXPECT_EQ(axis.values.size(), 2U);
    EXPECT_EQ(axis.values[1].path, "grid.nx");
    EXPECT_EQ(axis.values[1].column, 19U) << "where the value 16 starts";
}

TEST(SweepAxis, WrongOnesAreLocated) {
    const auto refusal = [](const std::string& text) {
        return message_of<InputError>([&] { read_axis(text, "--over 2"); });
    };
    const std::string form =
        "; write key=v1,v2 or key=low:high:count, for example model.creep_rate=0.1:0.5:5";
    EXPECT_EQ(refusal("x"), "--over 2:1: \"x\" varies nothing" + form);
    EXPECT_EQ(refusal("=1"), "--over 2:1: \"=1\" varies nothing" + form);
    EXPECT_EQ(refusal("a+=1"), "--over 2:3: a key is missing in \"a+\"" + form);
    EXPECT_EQ(refusal("k="), "--over 2:3: a value of k is missing" + form);
    EXPECT_EQ(refusal("k=1,,2"), "--over 2:5: a value of k is missing" + form);
    EXPECT_EQ(refusal("k=1,"), "--over 2:5: a value of k is missing" + form);
    EXPECT_EQ(refusal("k=1,\"a"), "--over 2:5: a quote is not closed");
    EXPECT_EQ(refusal("k=[1,2"), "--over 2:3: a bracket is not closed");
    const std::string range =
        "is not a range; low:high:count takes a count of 1 … 100000, for example 0:1:11";
    for (const char* text : {"0:1", "0:1:0", "0:1:2.5", "0:1:x", "0:1:100001", "0:1:2:3"})
        EXPECT_EQ(refusal(std::string("k=") + text),
                  "--over 2:3: \"" + std::string(text) + "\" " + range);
    EXPECT_EQ(refusal("k=0:1:1"),
              "--over 2:3: \"0:1:1\" has two ends but one value; both ends belong to a range, so "
              "its count is 2 or more");
    EXPECT_EQ(refusal("seed=1,2"),
              "--over 2:1: seeds have an option of their own; write --seeds 10 or --seeds 1:10");
    EXPECT_EQ(refusal("sweep.seeds=1,2"),
              "--over 2:1: sweep.seeds cannot be varied by a sweep itself");
    EXPECT_EQ(message_of<InputError>([] { read_axis("k=", "scene.toml:3:8", false); }),
              "scene.toml:3:8: a value of k is missing" + form);
}

TEST(Seeds, ByNumberFromTheScenesOnOrByBothEnds) {
    EXPECT_EQ(read_seeds("3", 5).first, 5);
    EXPECT_EQ(read_seeds("3", 5).last, 7);
    EXPECT_EQ(read_seeds("0:9", 5).first, 0);
    EXPECT_EQ(read_seeds("0:9", 5).count(), 10);
    for (const char* text : {"", "0", "-1", "x", "2:1", "1:2:3", "1.5", "-2:3", ":"})
        EXPECT_EQ(message_of<InputError>([&] { read_seeds(text, 1); }),
                  "--seeds is \"" + std::string(text) +
                      "\"; it takes how many (10) or first:last (1:10)");
    EXPECT_NE(message_of<InputError>([] { read_seeds("0:9223372036854775807", 1); }), "");
    EXPECT_NE(message_of<InputError>([] { read_seeds("2", 9223372036854775807); }), "");
}

}  // namespace
}  // namespace fumon::test
