#include "render/colour/palette.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "render/colour/colouring.h"
#include "scene/view/palette_names.h"
#include "support/view_beds.h"

namespace fumon {
namespace {

std::string failure(const std::string& text) {
    try {
        parse_palette(text, "p.txt");
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Palette, AllThatShipAreReadable) {
    const auto names = palette_names();
    for (const char* name : {"sand", "grey", "viridis", "cividis", "magma", "inferno", "plasma",
                             "batlow", "lapaz", "oslo", "vik"}) {
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    }
    for (const std::string& name : names) EXPECT_NO_THROW(read_palette(name)) << name;
}

TEST(Palette, PublishedColoursAreTheirs) {
    using Colour = std::array<std::uint8_t, 3>;
    EXPECT_EQ(read_palette("viridis").front(), (Colour{68, 1, 84}));
    EXPECT_EQ(read_palette("viridis").back(), (Colour{253, 231, 37}));
    EXPECT_EQ(read_palette("batlow").front(), (Colour{1, 25, 89}));
    EXPECT_EQ(read_palette("batlow").back(), (Colour{250, 204, 250}));
    EXPECT_EQ(read_palette("grey")[77], (Colour{77, 77, 77}));
}

TEST(Palette, AnUnknownNameGetsTheNearest) {
    try {
        read_palette("viridsi");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"viridis\"?"), std::string::npos)
            << error.what();
    }
    EXPECT_THROW(read_palette("../palettes/viridis"), InputError);
}

TEST(Palette, BlanksAroundLinesAndTheirEndsDoNotMatter) {
    std::string plain;
    std::string blanks = "# from another system \r\n \r\n";
    for (int i = 0; i < 256; ++i) {
        const std::string colour = fmt::format("{} {} {}", i, 255 - i, i / 2);
        plain += colour + "\n";
        blanks += (i % 2 == 0 ? " " : "") + colour + (i % 3 == 0 ? "  \r\n" : "\r\n");
    }
    EXPECT_EQ(parse_palette(blanks, "blanks"), parse_palette(plain, "plain"));
}

TEST(Palette, MalformedFilesAreLocated) {
    EXPECT_EQ(failure("# x\n1 2\n"),
              "p.txt:2: '1 2' is not a colour; three whole numbers 0 … 255 are expected");
    EXPECT_EQ(failure("1 2 300\n"),
              "p.txt:1: '1 2 300' is not a colour; three whole numbers 0 … 255 are expected");
    EXPECT_EQ(failure("1 2 3 4\n"),
              "p.txt:1: '1 2 3 4' has more than the three numbers of a colour");
    EXPECT_EQ(failure("1 2 3\n"), "p.txt: 1 colours; a palette has 256");
    std::string long_one;
    for (int i = 0; i < 257; ++i) long_one += "1 2 3\r\n";
    EXPECT_EQ(failure(long_one), "p.txt:257: a palette ends after 256 colours");
}

std::pair<double, double> range_of(const LookSettings& look, const Snapshot& snapshot,
                                   const Snapshot& first) {
    return colour_range(look, snapshot, coloured_values(look, snapshot, first));
}

TEST(ColourRange, FollowsWhatIsColoured) {
    const Snapshot first = wavy_bed(80, 60);
    Snapshot later = first;
    for (double& height : later.bed.values()) height += 0.5;
    LookSettings look;
    look.colour_by = Colouring::change;
    const auto [low, high] = range_of(look, later, first);
    EXPECT_NEAR(low, -0.5, 1e-6);
    EXPECT_NEAR(high, 0.5, 1e-6);
    look.colour_by = Colouring::height;
    const auto heights = range_of(look, first, first);
    EXPECT_GT(heights.second, heights.first + 1.0);
    look.low = {"", -3.0};
    look.high = {"", 8.0};
    EXPECT_EQ(range_of(look, first, first), (std::pair{-3.0, 8.0}));
}

// A record that is flat, or dry, says nothing of how wide the colours of several maps are.
TEST(ColourRange, OfSeveralMapsTakesAFlatOneByItsValueAlone) {
    Snapshot flat = wavy_bed(80, 60);
    for (double& height : flat.bed.values()) height = 0.25;
    Snapshot gentle = flat;
    for (std::size_t i = 0; i < gentle.bed.size(); ++i)
        gentle.bed.values()[i] = i % 2 == 0 ? 0.0 : 0.125;
    Snapshot empty = flat;
    empty.nodata = Mask(80, 60);
    for (std::uint8_t& none : empty.nodata.values()) none = 1;
    LookSettings look;
    look.colour_by = Colouring::height;
    const auto range = [&](const std::vector<Snapshot>& snapshots) {
        std::vector<Field<float>> values;
        for (const Snapshot& snapshot : snapshots)
            values.push_back(coloured_values(look, snapshot, flat));
        return joined_colour_range(look, snapshots, values);
    };
    EXPECT_EQ(range({flat, gentle, empty}), (std::pair{0.0, 0.25}));
    EXPECT_EQ(range({flat, flat}), (std::pair{-0.25, 0.75}));
    EXPECT_EQ(range({gentle}), range_of(look, gentle, flat));
}

FrameColourRange colours_of(const LookSettings& look, const Snapshot& snapshot,
                            const FrameColourRange& previous, bool keeps) {
    return frame_colour_range(look, snapshot, coloured_values(look, snapshot, snapshot), previous,
                              keeps);
}

TEST(ColourRange, IsKeptFromTheFirstPictureWhoseValuesDiffer) {
    Snapshot flat = wavy_bed(80, 60);
    for (double& height : flat.bed.values()) height = 2.0;
    const Snapshot first = wavy_bed(80, 60);
    Snapshot higher = first;
    for (double& height : higher.bed.values()) height += 0.5;
    LookSettings look;
    look.colour_by = Colouring::height;
    const FrameColourRange none = colours_of(look, flat, {}, true);
    EXPECT_FALSE(none.kept);
    EXPECT_EQ(none.low, 1.5);
    EXPECT_EQ(none.high, 2.5);
    const FrameColourRange one = colours_of(look, first, none, true);
    EXPECT_TRUE(one.kept);
    EXPECT_FALSE(one.values_below || one.values_above);
    const auto alone = range_of(look, first, first);
    EXPECT_EQ(std::pair(one.low, one.high), alone);
    const FrameColourRange later = colours_of(look, higher, one, true);
    EXPECT_EQ(std::pair(later.low, later.high), alone);
    EXPECT_TRUE(later.values_above);
    EXPECT_FALSE(later.values_below);
    EXPECT_FALSE(colours_of(look, first, {}, false).kept) << "a picture by itself";

    look.range = ColourSpan::frame;
    const FrameColourRange own = colours_of(look, higher, colours_of(look, first, {}, true), true);
    EXPECT_NEAR(own.low, alone.first + 0.5, 1e-6);
    EXPECT_FALSE(own.kept || own.values_above);
}

TEST(ColourRange, SlopesAreInDegrees) {
    Snapshot plane;
    plane.bed = Grid(20, 20);
    plane.scale = {2.0, 2.0, 4.0, true};
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) plane.bed(x, y) = 0.5 * x;  // 2 m up on 2 m
    LookSettings by_slope;
    by_slope.colour_by = Colouring::slope;
    const Field<float> slopes = coloured_values(by_slope, plane, plane);
    for (const float value : slopes.values()) EXPECT_NEAR(value, 45.0, 1e-2);
    LookSettings look;
    look.colour_by = Colouring::slope;
    EXPECT_EQ(range_of(look, plane, plane).first, 0.0);
}

TEST(ColourRange, CellsWithoutDataDoNotCount) {
    const Snapshot bed = masked_bed(60, 50);
    LookSettings look;
    look.colour_by = Colouring::height;
    EXPECT_GT(range_of(look, bed, bed).first, -100.0);
}

}  // namespace
}  // namespace fumon
