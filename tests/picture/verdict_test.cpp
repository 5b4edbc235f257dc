#include "picture/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "picture/junit.h"
#include "picture/markup.h"
#include "support/pictures.h"

namespace fumon {
namespace {

using test::some_picture;

BaselineRecord record_of(const Image& image) {
    BaselineRecord record;
    record.fumon = "0.1.0";
    record.environment = opengl_environment("osmesa", "llvmpipe (LLVM 15.0.6, 128 bits)",
                                            "4.5 (Core Profile) Mesa 22.3.6", true);
    record.state = "5e0d";
    record.fingerprint = fingerprint_of(image);
    return record;
}

BaselineRecord drawn_elsewhere(BaselineRecord record) {
    record.environment = opengl_environment("osmesa", "llvmpipe (LLVM 16.0.6, 128 bits)",
                                            "4.5 (Core Profile) Mesa 23.1.0", true);
    return record;
}

/// A picture with one level of one pixel changed by one.
Image by_one_level(Image image) {
    image.rgb[3000] ^= 1U;
    return image;
}

/// A picture with a tile's pattern shifted, which the thumbnail hardly sees.
Image by_one_tile(Image image) {
    for (int y = 80; y < 88; ++y) {
        std::uint8_t* row = image.row(y) + std::ptrdiff_t{3 * 160};
        std::rotate(row, row + 12, row + 24);
    }
    return image;
}

const Image expected = some_picture(320, 180);

TEST(Verdict, NothingRecordedIsMissing) {
    const Verdict verdict = judge({}, nullptr, record_of(expected), expected, nullptr);
    EXPECT_EQ(verdict.outcome, Outcome::missing);
}

TEST(Verdict, AKeptPictureThatIsGoneIsMissing) {
    BaselineCase one;
    one.picture = true;
    const BaselineRecord record = record_of(expected);
    EXPECT_EQ(judge(one, &record, record, expected, nullptr).outcome, Outcome::missing);
}

TEST(Verdict, StrictTakesTheSamePixelsAlone) {
    const BaselineRecord record = record_of(expected);
    const Verdict same = judge({}, &record, record, expected, nullptr);
    EXPECT_EQ(same.outcome, Outcome::as_recorded);
    EXPECT_EQ(same.finding, "strict: state and pixels as recorded");

    const Image other = by_one_level(expected);
    const Verdict verdict = judge({}, &record, record_of(other), other, &expected);
    EXPECT_EQ(verdict.outcome, Outcome::differs);
    EXPECT_TRUE(verdict.finding.starts_with("strict: 0.00174 % of its pixels differ, by 1 at most"))
        << verdict.finding;
}

TEST(Verdict, InAKnownEnvironmentItIsStrictWhateverDraws) {
    const BaselineRecord record = record_of(expected);
    const Image other = by_one_level(expected);
    const Verdict differs = judge({}, &record, drawn_elsewhere(record_of(other)), other, &expected,
                                  {"environment card", true});
    EXPECT_EQ(differs.outcome, Outcome::differs);
    EXPECT_TRUE(differs.finding.starts_with("strict, environment card: 0.00174 % of its pixels"))
        << differs.finding;
    EXPECT_TRUE(
        differs.finding.ends_with("; Mesa 22.3.6 there, 23.1.0 here, LLVM 15.0.6 there, "
                                  "16.0.6 here"))
        << differs.finding;
    const Verdict same = judge({}, &record, drawn_elsewhere(record_of(expected)), expected, nullptr,
                               {"environment card", true});
    EXPECT_EQ(same.finding, "strict, environment card: state and pixels as recorded");
}

TEST(Verdict, PortableTakesWhatIsTheSameToTheEyeAndSaysWhy) {
    const BaselineRecord record = record_of(expected);
    const Image other = by_one_level(expected);
    const Verdict verdict = judge({}, &record, drawn_elsewhere(record_of(other)), other, &expected);
    EXPECT_EQ(verdict.outcome, Outcome::as_recorded);
    EXPECT_TRUE(verdict.finding.starts_with(
        "portable (Mesa 22.3.6 there, 23.1.0 here, LLVM 15.0.6 there, 16.0.6 here): "))
        << verdict.finding;
}

TEST(Verdict, PortableSeesATileOnlyInAKeptPicture) {
    const BaselineRecord record = record_of(expected);
    const Image other = by_one_tile(expected);
    const BaselineRecord present = drawn_elsewhere(record_of(other));
    const Verdict with = judge({}, &record, present, other, &expected);
    EXPECT_EQ(with.outcome, Outcome::differs) << with.finding;
    const Verdict without = judge({}, &record, present, other, nullptr);
    EXPECT_EQ(without.outcome, Outcome::as_recorded) << without.finding;
    EXPECT_NE(without.finding.find("no picture is kept for SSIM"), std::string::npos);

    BaselineCase lenient;
    lenient.tile_ssim = -1.0;
    EXPECT_EQ(judge(lenient, &record, present, other, &expected).outcome, Outcome::as_recorded);
}

TEST(Verdict, PortableSeesADimmerPicture) {
    const BaselineRecord record = record_of(expected);
    Image dimmer = expected;
    for (std::uint8_t& level : dimmer.rgb)
        level = static_cast<std::uint8_t>(std::max(level - 1, 0));
    const BaselineRecord present = drawn_elsewhere(record_of(dimmer));
    EXPECT_EQ(judge({}, &record, present, dimmer, nullptr).outcome, Outcome::differs);
    BaselineCase lenient;
    lenient.thumbnail_difference = 1.5;
    EXPECT_EQ(judge(lenient, &record, present, dimmer, nullptr).outcome, Outcome::as_recorded);
}

TEST(Verdict, AnotherStateOrSizeNeverPasses) {
    const BaselineRecord record = record_of(expected);
    BaselineRecord moved = record;
    moved.state = "77aa";
    for (const bool elsewhere : {false, true}) {
        const Verdict verdict =
            judge({}, &record, elsewhere ? drawn_elsewhere(moved) : moved, expected, nullptr);
        EXPECT_EQ(verdict.outcome, Outcome::differs);
        EXPECT_NE(verdict.finding.find("the state differs; pixels as recorded"), std::string::npos);
    }
    const Image near = by_one_level(expected);
    moved.fingerprint = fingerprint_of(near);
    EXPECT_EQ(judge({}, &record, drawn_elsewhere(moved), near, nullptr).outcome, Outcome::differs)
        << "though its pixels are the same to the eye";
    const Image small = some_picture(160, 90);
    const Verdict verdict = judge({}, &record, record_of(small), small, &expected);
    EXPECT_EQ(verdict.outcome, Outcome::differs);
    EXPECT_EQ(verdict.finding, "strict: 320 x 180 pixels were recorded, these are 160 x 90");
}

TEST(Verdict, ChangesAreNamed) {
    const BaselineRecord record = record_of(expected);
    EXPECT_EQ(changes(record, record), "");
    BaselineRecord other = drawn_elsewhere(record_of(by_one_level(expected)));
    other.state = "77aa";
    other.fumon = "0.2.0";
    EXPECT_EQ(changes(record, other),
              "the state changes; the pixels change, their thumbnail by 0.0 at column 0, row 0; "
              "Mesa 22.3.6 there, 23.1.0 here, LLVM 15.0.6 there, 16.0.6 here; fumon 0.1.0 there, "
              "0.2.0 here");
}

/// Whether every tag of an XML text is closed in order, and what its texts hold.
struct Tags {
    bool well_formed = true;
    std::vector<std::string> opened;

    explicit Tags(const std::string& xml) {
        std::vector<std::string> open;
        for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
            const std::size_t end = xml.find('>', at);
            if (end == std::string::npos) well_formed = false;
            if (end == std::string::npos) return;
            const std::string tag = xml.substr(at + 1, end - at - 1);
            if (tag.starts_with("?")) continue;
            if (tag.starts_with("/")) {
                well_formed = well_formed && !open.empty() && open.back() == tag.substr(1);
                if (!open.empty()) open.pop_back();
                continue;
            }
            well_formed = well_formed && std::count(tag.begin(), tag.end(), '"') % 2 == 0;
            open.push_back(tag.substr(0, tag.find(' ')));
            opened.push_back(open.back());
        }
        well_formed = well_formed && open.empty();
    }
};

TEST(Junit, IsWellFormedWhateverIsFound) {
    const std::string nasty = "a < b & \"c\" > 'd' \x01 \xFF 風";
    const std::string xml = junit_xml({{"a.toml", "one", {Outcome::as_recorded, nasty}, 1.5},
                                       {"a.toml", "two", {Outcome::differs, nasty}, 0.5},
                                       {"b.toml", "one", {Outcome::missing, nasty}, 0.25},
                                       {"b.toml", "two", {Outcome::failed, nasty}, 0.25}},
                                      "2026-11-27T10:00:00");
    const Tags tags(xml);
    EXPECT_TRUE(tags.well_formed) << xml;
    const auto count = [&](const char* name) {
        return std::count(tags.opened.begin(), tags.opened.end(), name);
    };
    EXPECT_EQ(count("testsuites"), 1);
    EXPECT_EQ(count("testsuite"), 2);
    EXPECT_EQ(count("testcase"), 4);
    EXPECT_EQ(count("failure"), 2);
    EXPECT_EQ(count("error"), 1);
    EXPECT_NE(xml.find("name=\"fumon verify\" tests=\"4\" failures=\"2\" errors=\"1\" "
                       "time=\"2.500\""),
              std::string::npos)
        << xml;
    EXPECT_NE(xml.find("a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39; ? ? 風"), std::string::npos);
}

TEST(Junit, TellsSuitesApartAndSaysWhatItComparedWhen) {
    const std::string xml =
        junit_xml({{"p.toml", "one", {Outcome::differs, "a"}, 1.0, "0a", "0b"},
                   {"sub/p.toml", "one", {Outcome::missing, "a"}, 1.0, "", "0c"},
                   {"../p.toml", "one", {Outcome::wrong_input, "a"}, 1.0}},
                  "2026-11-27T10:00:00");
    for (const char* wanted :
         {"<testcase classname=\"p\" name=\"one\"", "<testcase classname=\"sub.p\" name=\"one\"",
          "<testcase classname=\"p-2\" name=\"one\"", "<failure type=\"differs\" message=\"a\">",
          "<failure type=\"missing\"", "<error type=\"wrong-input\"",
          "skipped=\"0\" timestamp=\"2026-11-27T10:00:00\"",
          "<property name=\"one.expected-pixels-sha256\" value=\"0a\"/>",
          "<property name=\"one.got-pixels-sha256\" value=\"0b\"/>",
          "<property name=\"one.got-pixels-sha256\" value=\"0c\"/>"})
        EXPECT_NE(xml.find(wanted), std::string::npos) << wanted << "\n" << xml;
    const std::size_t suites = xml.find("<testsuites");
    EXPECT_GT(xml.find("skipped"), xml.find('>', suites))
        << "all suites together have no such count";
}

TEST(Markup, KeepsUtf8AndReplacesTheRest) {
    EXPECT_EQ(markup_text("風紋 é 🏜"), "風紋 é 🏜");
    EXPECT_EQ(markup_text("\xC0\xAF"), "??") << "overlong";
    EXPECT_EQ(markup_text("\xED\xA0\x80"), "???") << "a surrogate";
    EXPECT_EQ(markup_text("\xE9"), "?") << "cut short";
    EXPECT_EQ(markup_text("\xEF\xBF\xBF"), "???") << "no character";
    EXPECT_EQ(markup_text("a\nb\x7F"), "a?b?");
}

}  // namespace
}  // namespace fumon
