#include "files/terrain/esri_ascii.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "files/terrain/ground_lengths.h"

namespace fumon {
namespace {

const std::string header = "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 4000000\ncellsize 2.5\n";

Terrain parse(std::string_view text) {
    return parse_esri_ascii({"bed.asc", text});
}

std::vector<double> heights(std::string_view text) {
    const Terrain terrain = parse(text);
    const auto values = terrain.heights.values();
    return {values.begin(), values.end()};
}

const std::vector<double> six{4, 5, 6, 1, 2, 3};  // southern row first

TEST(EsriAscii, PutsTheFirstRowNorth) {
    const Terrain terrain = parse(header + "1 2 3\n4 5 6\n");
    EXPECT_EQ(terrain.heights.nx(), 3);
    EXPECT_EQ(terrain.heights.ny(), 2);
    EXPECT_EQ(terrain.heights(0, 1), 1.0);
    EXPECT_EQ(terrain.heights(2, 0), 6.0);
    EXPECT_EQ(terrain.dx, 2.5);
    EXPECT_EQ(terrain.dy, 2.5);
    EXPECT_TRUE(terrain.nodata.empty());
    EXPECT_EQ(terrain.note, "");
}

TEST(EsriAscii, ReadsEveryLineEndAndBreak) {
    std::string crlf;
    std::string cr;
    for (const char c : header + "1 2 3\n4 5 6\n") {
        crlf += c == '\n' ? "\r\n" : std::string(1, c);
        cr += c == '\n' ? '\r' : c;
    }
    EXPECT_EQ(heights(crlf), six);
    EXPECT_EQ(heights(cr), six);
    EXPECT_EQ(heights(header + "1\n2 3 4\n5\n6"), six);
    EXPECT_EQ(heights(header + "1 2 3 4 5 6"), six);
    EXPECT_EQ(heights(header + "\t1\t2  3 \n\n   4\t5 6   \n\n\n"), six);
    EXPECT_EQ(heights("\xEF\xBB\xBF\n  " + header + "1 2 3\n4 5 6\n\x1A"), six);
}

TEST(EsriAscii, ReadsHeadersInAnyCaseAndOrder) {
    const Terrain terrain = parse(
        "NODATA_VALUE 2\nCellSize 1e1\nYLLCENTER +7.5\nnRows\t2.0\nXLLCENTER -3\nNCOLS    3\n"
        "1 2 3\n4 5 6\n");
    EXPECT_EQ(terrain.dx, 10.0);
    EXPECT_EQ(terrain.nodata(1, 1), 1);
    EXPECT_EQ(terrain.nodata(0, 0), 0);
    EXPECT_EQ(terrain.heights(1, 1), 0.0);
}

TEST(EsriAscii, ReadsTwoCellSizes) {
    const Terrain terrain = parse("ncols 1\nnrows 1\ndx 2\ndy 3\n7\n");
    EXPECT_EQ(terrain.dx, 2.0);
    EXPECT_EQ(terrain.dy, 3.0);
}

TEST(EsriAscii, ReadsNumbersAsProgramsPrintThem) {
    EXPECT_EQ(heights(header + "1e3 -2.5E-01 +3\n.5 4. 1e-400\n"),
              (std::vector<double>{0.5, 4.0, 0.0, 1000.0, -0.25, 3.0}));
}

TEST(EsriAscii, KnowsNoDataCells) {
    const Terrain usual = parse(header + "1 -9999 nan\n-9999.0 1.#QNAN 6\n");
    EXPECT_EQ(usual.nodata, [] {
        Mask mask(3, 2);
        mask(1, 1) = mask(2, 1) = mask(0, 0) = mask(1, 0) = 1;
        return mask;
    }());
    EXPECT_EQ(usual.heights(1, 1), 0.0);
    const Terrain named = parse(header + "nodata 0\n1 -9999 0\n3 4 0.0\n");
    EXPECT_EQ(named.heights(1, 1), -9999.0);
    EXPECT_EQ(named.nodata(2, 1), 1);
    EXPECT_EQ(named.nodata(2, 0), 1);
    const Terrain not_a_number = parse(header + "NODATA_value nan\n1 NaN -9999\n3 4 5\n");
    EXPECT_EQ(not_a_number.nodata(1, 1), 1);
    EXPECT_EQ(not_a_number.heights(2, 1), -9999.0);
}

TEST(EsriAscii, KnowsTheLargestFloatAsNoDataHoweverItIsRounded) {
    const Terrain terrain = parse(header +
                                  "NODATA_value -3.4028234663852886e+38\n"
                                  "1 -3.40282346638529e+38 3\n4 -3.402823e+38 -3.3e38\n");
    EXPECT_EQ(terrain.nodata(1, 1), 1);
    EXPECT_EQ(terrain.nodata(1, 0), 1);
    EXPECT_EQ(terrain.nodata(2, 0), 0);
}

TEST(EsriAscii, TakesNearbyValuesForHeights) {
    EXPECT_TRUE(parse(header + "1 -9999.001 3\n4 5 6\n").nodata.empty());
}

TEST(EsriAscii, WritesWhatItReads) {
    Grid grid(2, 2);
    grid(0, 1) = 1.0;
    grid(1, 1) = 100000.0;
    grid(0, 0) = 0.1;
    Mask mask(2, 2);
    mask(1, 0) = 1;
    EXPECT_EQ(esri_ascii(grid, mask, 0.5, 0.5),
              "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\nNODATA_value -9999\n"
              "1 1e+05\n0.1 -9999\n");
    EXPECT_EQ(esri_ascii(grid, mask, 0.5, 0.25).substr(0, 65),
              "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ndx 0.5\ndy 0.25\nNODATA_val");
}

TEST(EsriAscii, WritesWholeCounts) {
    EXPECT_EQ(esri_ascii(Grid(100000, 1), {}, 1.0, 1.0).substr(0, 13), "ncols 100000\n");
}

TEST(EsriAscii, RoundTripKeepsEveryBit) {
    Grid grid(40, 30);
    std::uint64_t state = 1;
    for (double& value : grid.values()) {
        do {  // an arbitrary bit pattern (a linear congruential generator, Knuth's constants)
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            value = std::bit_cast<double>(state);
        } while (!std::isfinite(value));
    }
    grid(0, 0) = -9999.0;
    grid(1, 0) = -99999.0;
    grid(2, 0) = -0.0;
    grid(3, 0) = std::numeric_limits<double>::denorm_min();
    grid(4, 0) = std::numeric_limits<double>::max();
    Mask mask(40, 30);
    mask(7, 7) = 1;
    const Terrain back = parse(esri_ascii(grid, mask, 0.1, 0.3));
    EXPECT_EQ(back.dx, 0.1);
    EXPECT_EQ(back.dy, 0.3);
    EXPECT_EQ(back.nodata, mask);
    grid(7, 7) = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(back.heights.values()[i]),
                  std::bit_cast<std::uint64_t>(grid.values()[i]))
            << "cell " << i;
}

TEST(EsriAscii, ConvertsDegreesAtTheMiddleLatitude) {
    Terrain terrain = parse(
        "ncols 2\nnrows 2\nxllcorner -105.5\nyllcorner 44.9\ncellsize 0.1\n2000 2100\n2200 2300\n");
    make_true_lengths(terrain, true, "grid.asc");
    // WGS84 at 45°: a degree of latitude is 111,131.777 m, of longitude 78,846.835 m.
    EXPECT_NEAR(terrain.dx, 7884.6835, 0.0005);
    EXPECT_NEAR(terrain.dy, 11113.1777, 0.0005);
    EXPECT_EQ(terrain.note,
              "cell size 0.1° read as degrees and converted to metres at the middle latitude "
              "45.0000°: dx = 7884.68 m, dy = 11113.18 m");
}

TEST(EsriAscii, KeepsSmallMetricGridsMetric) {
    for (const std::string origin : {"xllcorner 0\nyllcorner 0\n", "xllcorner 3\nyllcorner -0.5\n",
                                     "xllcenter 0.005\nyllcenter 0.005\n", ""}) {
        const Terrain terrain =
            parse("ncols 3\nnrows 1\n" + origin + "cellsize 0.01\n0.001 0.02 0.004\n");
        EXPECT_EQ(terrain.dx, 0.01) << origin;
        EXPECT_EQ(terrain.note, "") << origin;
    }
}

}  // namespace
}  // namespace fumon
