#include "picture/pixels/ignored_pixels.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "files/atomic_file.h"
#include "picture/compare.h"
#include "picture/pixels/ignore_rules.h"
#include "picture/png.h"
#include "picture/verdict.h"
#include "support/pictures.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::flat_picture;
using test::message_of;
using test::some_picture;

IgnoredPixels box_of(const Image& image, const PixelBox& box) {
    IgnoredPixels ignored(image.width, image.height);
    ignored.add(box);
    return ignored;
}

void invert(Image& image, const PixelBox& box) {
    for (std::int64_t y = box.y; y < box.y + box.height; ++y) {
        for (std::int64_t i = 3 * box.x; i < 3 * (box.x + box.width); ++i)
            image.row(static_cast<int>(y))[i] ^= 255U;
    }
}

TEST(IgnoredPixels, AreNoneOfAComparison) {
    const Image image = some_picture(101, 67);
    const PixelBox box{13, 20, 30, 11};  // across the edges of tiles
    Image other = image;
    invert(other, box);
    EXPECT_EQ(likeness(compare(image, other)), Likeness::different);
    const Comparison without = compare(image, other, box_of(image, box));
    EXPECT_EQ(without.changed, 0);
    EXPECT_EQ(without.ignored, 330);
    EXPECT_DOUBLE_EQ(without.ignored_share, 330.0 / (101 * 67));
    EXPECT_EQ(likeness(without), Likeness::identical);
    other.row(20)[3 * 12] ^= 255U;  // a pixel beside it
    const Comparison beside = compare(image, other, box_of(image, box));
    EXPECT_EQ(beside.changed, 1);
    EXPECT_DOUBLE_EQ(beside.changed_share, 1.0 / (101 * 67 - 330));
    EXPECT_EQ(beside.tiles.x, 8);
    EXPECT_EQ(beside.tiles.y, 16);
}

/// A tile's similarity is that of its pixels that count, not thinned out by those that do not.
TEST(IgnoredPixels, LeaveATilesSimilarityToTheOthers) {
    Image first(8, 8);
    Image second(8, 8);
    for (std::size_t i = 0; i < first.rgb.size(); ++i) {
        first.rgb[i] = (i / 3) % 2 == 0 ? 50 : 200;
        second.rgb[i] = (i / 3) % 2 == 0 ? 200 : 50;
    }
    const double upside_down = compare(first, second).tiles.smallest;
    const double half = compare(first, second, box_of(first, {0, 0, 8, 4})).tiles.smallest;
    EXPECT_LT(upside_down, -0.9);
    EXPECT_NEAR(half, upside_down, 0.01);
    EXPECT_EQ(compare(first, second, box_of(first, {0, 0, 8, 8})).changed, 0);
}

TEST(IgnoredPixels, AreHatchedInTheDifferenceAndOpaque) {
    Image image = flat_picture(64, 32, 100);
    Image other = image;
    const PixelBox box{0, 0, 32, 32};
    invert(other, {8, 8, 40, 4});
    const Image picture = difference_picture(image, other, box_of(image, box));
    int stripes = 0;
    for (int x = 0; x < 32; ++x) {
        const std::uint8_t* pixel = picture.row(10) + std::ptrdiff_t{3} * x;
        EXPECT_GT(pixel[2], pixel[0]) << "blue: no mark of a difference, at " << x;
        stripes += pixel[2] > 150 ? 1 : 0;
    }
    EXPECT_EQ(stripes, 12) << "three of eight pixels";
    EXPECT_GT(picture.row(10)[3 * 40], 200) << "a difference beside it";
    EXPECT_EQ(picture.row(20)[3 * 40], 25) << "and what is the same, dim";

    image.alpha.assign(64 * 32, 0);
    EXPECT_EQ(blanked(image, box_of(image, box)).alpha[5], 255);
    EXPECT_EQ(blanked(image, box_of(image, box)).alpha[40], 0);
    EXPECT_EQ(blanked(image, IgnoredPixels(64, 32)), image);
}

TEST(IgnoredPixels, RulesAreBoxesAndMasks) {
    const test::TemporaryFolder folder;
    const Image picture = some_picture(40, 20);
    Image mask = flat_picture(40, 20, 0);
    for (int i = 0; i < 3 * 10; ++i) mask.row(19)[i] = 255;
    write_file(folder.path() / "mask.png", encode_png(mask, 96.0, {}));
    write_file(folder.path() / "small.png", encode_png(some_picture(40, 19), 96.0, {}));
    IgnoreRules rules;
    EXPECT_FALSE(ignored_pixels(rules, picture, folder.path()).any());
    rules.boxes = {read_box("0,0,10,4"), read_box("35,16,10,10")};
    rules.mask = "mask.png";
    EXPECT_EQ(ignored_pixels(rules, picture, folder.path()).count(), 40 + 20 + 10);
    EXPECT_EQ(ignored_pixels(rules, picture, folder.path(), {{0, 0, 10, 5}}).count(), 80);
    const auto said = [&] {
        return message_of<InputError>([&] { ignored_pixels(rules, picture, folder.path()); });
    };
    rules.mask = "small.png";
    EXPECT_TRUE(said().ends_with(
        "small.png: is a mask of 40 x 19 pixels for a picture of 40 x 20; make it the same size"))
        << said();
    rules.mask = "";
    rules.boxes = {{0, 0, 40, 6}};
    EXPECT_EQ(ignored_pixels(rules, picture, folder.path()).count(), 240) << "30 % are taken";
    rules.boxes.push_back({0, 6, 1, 1});
    EXPECT_EQ(said(), "30.1 % of the picture would be ignored, more than 30 %; ignore less");
    rules.boxes = {{40, 0, 1, 1}};
    EXPECT_EQ(said(),
              "ignore: the box [40, 0, 1, 1] lies outside of the picture of 40 x 20 pixels");
    for (const char* text : {"", "1,2,3", "1,2,3,0", "-1,2,3,4", "1,2,3,4,5", "1, 2,3,4", "a,b,c,d",
                             "1,2,3,65536", "99999999999999999999,1,1,1"})
        EXPECT_THROW(read_box(text), InputError) << text;
}

/// Large pictures are compared by several threads, with the numbers of one.
TEST(Compare, TheNumbersAreTheSameOnAllThreads) {
    const Image image = some_picture(1001, 407);
    Image other = image;
    for (std::size_t i = 0; i < other.rgb.size(); i += 1009) other.rgb[i] ^= 7U;
    const Comparison comparison = compare(image, other);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < other.rgb.size(); ++i) sum += std::abs(image.rgb[i] - other.rgb[i]);
    EXPECT_DOUBLE_EQ(comparison.mean, static_cast<double>(sum) / (3.0 * 1001 * 407));
    EXPECT_EQ(comparison.changed, (static_cast<std::int64_t>(other.rgb.size()) + 1008) / 1009);
    const TileSimilarity tiles = tile_similarity(image, other);
    EXPECT_EQ(comparison.tiles.smallest, tiles.smallest);
    EXPECT_EQ(comparison.tiles.x, tiles.x);
    EXPECT_EQ(comparison.tiles.y, tiles.y);
    // Of tiles that are equally far apart the first one is told of.
    Image twice = flat_picture(1024, 512, 90);
    for (const int y : {100, 400}) twice.row(y)[3 * 700] = 200;
    const Comparison found = compare(flat_picture(1024, 512, 90), twice);
    EXPECT_EQ(found.tiles.x, 696);
    EXPECT_EQ(found.tiles.y, 96);
}

TEST(Compare, OpacitiesOfAnOpaquePictureSayNothing) {
    const Image image = some_picture(40, 30);
    Image other = image;
    other.rgb[100] ^= 16U;
    const Comparison plain = compare(image, other);
    other.alpha.assign(40 * 30, 255);
    const Comparison with = compare(image, other);
    EXPECT_EQ(with.mean, plain.mean);
    EXPECT_EQ(with.tiles.smallest, plain.tiles.smallest);
    EXPECT_EQ(with.thumbnail.largest, plain.thumbnail.largest);
    other.alpha[5] = 0;
    EXPECT_NE(compare(image, other).mean, plain.mean);
}

TEST(Verdict, IgnoredPixelsMustBeThoseOfTheRecord) {
    const Image image = some_picture(96, 54);
    const IgnoredPixels ignored = box_of(image, {0, 0, 20, 20});
    BaselineCase one;
    BaselineRecord record;
    record.fingerprint = fingerprint_of(blanked(image, ignored));
    record.ignored = ignored.hash();
    BaselineRecord present = record;
    const Verdict good = judge(one, &record, present, image, nullptr, {}, ignored);
    EXPECT_EQ(good.outcome, Outcome::as_recorded);
    EXPECT_TRUE(good.finding.ends_with("7.72 % of the picture ignored")) << good.finding;
    present.ignored = "";
    present.fingerprint = fingerprint_of(image);
    const Verdict other = judge(one, &record, present, image, nullptr);
    EXPECT_EQ(other.outcome, Outcome::differs);
    EXPECT_NE(other.finding.find("what is ignored is not what it was"), std::string::npos);
    EXPECT_NE(changes(record, present).find("what is ignored changes"), std::string::npos);
}

}  // namespace
}  // namespace fumon
