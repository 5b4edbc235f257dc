#include <gtest/gtest.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/temporary_folder.h"

namespace fumon {
namespace {

using test::message_of;
using test::TemporaryFolder;

struct BrokenFile {
    std::string name;
    std::string bytes;
    std::string expected;  ///< behind the file's name
};

void PrintTo(const BrokenFile& broken, std::ostream* out) {
    *out << broken.name;
}

class BrokenTerrain : public ::testing::TestWithParam<BrokenFile> {};

TEST_P(BrokenTerrain, IsRefusedInOneLine) {
    const TemporaryFolder folder;
    const auto file = folder.file(GetParam().name + ".asc", GetParam().bytes);
    EXPECT_EQ(message_of<InputError>([&] { read_terrain(file, {}); }),
              file.string() + GetParam().expected);
}

const std::string sizes = "ncols 2\nnrows 2\n";
const std::string origin = "xllcorner 0\nyllcorner 0\n";
const std::string grid_head = sizes + origin + "cellsize 1\n";
const std::string all_words =
    "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy), "
    "NODATA_value";
const std::string use_instead =
    "; terrain is a NetCDF file, a GeoTIFF, a PNG image, another raster that GDAL reads or an ESRI "
    "ASCII grid (gdal_translate -of "
    "AAIGrid makes one)";

const std::vector<BrokenFile> broken_files{
    {"Empty", "", ":1: the file is empty; an ESRI ASCII grid starts with its ncols line"},
    {"Blank", "\n \r\n\t", ":1: the file is empty; an ESRI ASCII grid starts with its ncols line"},
    {"Binary", std::string("II,\0\x08\0\0\0", 8), ":1: this is a binary file" + use_instead},
    {"Utf16", std::string("\xFF\xFEn\0c\0", 6), ":1: this is a binary file" + use_instead},
    {"Prose", "Dear reader,\nthis is no grid\n",
     ":1: 'Dear' does not start an ESRI ASCII grid; its header has " + all_words},
    {"NoHeader", "1 2\n3 4\n",
     ":1: no ncols line before the heights; add 'ncols NUMBER' to the header"},
    {"NoColumns", "nrows 2\n" + origin + "cellsize 1\n1 2\n3 4\n",
     ":5: no ncols line before the heights; add 'ncols NUMBER' to the header"},
    {"NoRows", "ncols 2\n" + origin + "cellsize 1\n1 2\n3 4\n",
     ":5: no nrows line before the heights; add 'nrows NUMBER' to the header"},
    {"NoCellSize", sizes + origin + "1 2\n3 4\n",
     ":5: no cellsize line before the heights; add 'cellsize NUMBER' to the header"},
    {"OnlyOneOfTwoSizes", sizes + "dx 2\n1 2\n3 4\n",
     ":4: no dy line before the heights; add 'dy NUMBER' to the header"},
    {"HeaderOnly", sizes,
     ":3: no cellsize line before the heights; add 'cellsize NUMBER' to the header"},
    {"UnknownWord", sizes + "cellsise 2\n1 2\n3 4\n",
     ":3: unknown header word 'cellsise'; known are " + all_words},
    {"Twice", sizes + "NCOLS 2\n1 2\n3 4\n",
     ":3: NCOLS occurs again (first on line 1); keep one of the two lines"},
    {"BothOrigins", grid_head + "xllcenter 0\n1 2\n3 4\n",
     ":6: xllcorner and xllcenter exclude each other; keep one of the two lines"},
    {"BothCellSizes", grid_head + "dx 1\ndy 1\n1 2\n3 4\n",
     ":6: cellsize and dx exclude each other; keep one of the two lines"},
    {"NoValue", "ncols\nnrows 2\n", ":1: ncols has no value; write one number after ncols"},
    {"WordForNumber", "ncols two\n",
     ":1: ncols is 'two', which is not a number; write one number after ncols"},
    {"InfiniteCorner", sizes + "xllcorner 1e999\n",
     ":3: xllcorner is '1e999', which is infinite; write a finite number"},
    {"NanCellSize", sizes + "cellsize nan\n",
     ":3: cellsize is not a number; write one number after cellsize"},
    {"TwoValues", "ncols 2 3\n",
     ":1: ncols has more than one value: '3'; write one number after ncols, and nothing else on "
     "its line"},
    {"ZeroColumns", "ncols 0\nnrows 2\ncellsize 1\n",
     ":1: ncols is '0'; write a whole number from 1 to 134217728"},
    {"NegativeRows", "ncols 2\nnrows -2\ncellsize 1\n",
     ":2: nrows is '-2'; write a whole number from 1 to 134217728"},
    {"BrokenColumns", "ncols 2.5\nnrows 2\ncellsize 1\n",
     ":1: ncols is '2.5'; write a whole number from 1 to 134217728"},
    {"HugeColumns", "ncols 1e18\nnrows 2\ncellsize 1\n",
     ":1: ncols is '1e18'; write a whole number from 1 to 134217728"},
    {"TooManyCells", "ncols 100000\nnrows 100000\ncellsize 1\n1 2 3\n",
     ":2: ncols × nrows = 100000 × 100000 = 10000000000 cells; at most 134217728 are read; cut out "
     "or "
     "coarsen the part you need"},
    {"ShortFileForItsHeader", "ncols 10000\nnrows 10000\ncellsize 1\n1 2 3\n4\n",
     ":5: 4 heights where ncols × nrows = 10000 × 10000 = 100000000 are needed; correct the header "
     "or "
     "the rows"},
    {"ZeroCellSize", sizes + "cellsize 0\n1 2\n3 4\n",
     ":3: cellsize is '0'; write a cell size greater than 0"},
    {"NegativeCellSize", sizes + "dx 1\ndy -30\n1 2\n3 4\n",
     ":4: dy is '-30'; write a cell size greater than 0"},
    {"WordForHeight", grid_head + "1 2\n3 abc\n",
     ":7: height 'abc' (row 2, column 2) is not a number; write a number or the NODATA_value"},
    {"MisspeltFirstHeight", grid_head + "1x 2\n3 4\n",
     ":6: height '1x' (row 1, column 1) is not a number; write a number or the NODATA_value"},
    {"DecimalComma", grid_head + "1 2\n3,5 4\n",
     ":7: height '3,5' (row 2, column 1) is not a number; write a decimal point, and spaces "
     "between "
     "numbers"},
    {"LongWord", grid_head + "1 2 3 " + std::string(100, 'z'),
     ":6: height '" + std::string(40, 'z') +
         "…' (row 2, column 2) is not a number; write a number or the NODATA_value"},
    {"CarriageReturns", "ncols 2\rnrows 2\r\ncellsize 1\r1 2\r3 abc\r",
     ":5: height 'abc' (row 2, column 2) is not a number; write a number or the NODATA_value"},
    {"InfiniteHeight", grid_head + "1 2\ninf 4\n",
     ":7: height 'inf' (row 2, column 1) is infinite; write a finite number or the NODATA_value"},
    {"OverflowingHeight", grid_head + "1 -1e400\n3 4\n",
     ":6: height '-1e400' (row 1, column 2) is infinite; write a finite number or the "
     "NODATA_value"},
    {"TooFew", grid_head + "1 2.000\n3\n\n",
     ":7: 3 heights where ncols × nrows = 2 × 2 = 4 are needed; correct the header or the rows"},
    {"TooMany", grid_head + "1 2\n3 4\n5 6 7\n",
     ":8: 7 heights where ncols × nrows = 2 × 2 = 4 are needed; correct the header or the rows"},
    {"AllNoData", grid_head + "NODATA_value -1\n-1 -1\n-1 nan\n",
     ":7: every cell is no-data; at least one height must differ from the NODATA_value -1"},
};

INSTANTIATE_TEST_SUITE_P(EsriAscii, BrokenTerrain, ::testing::ValuesIn(broken_files),
                         [](const auto& broken) { return broken.param.name; });

TEST(TerrainFile, RefusesAFolder) {
    const TemporaryFolder folder;
    EXPECT_EQ(message_of<InputError>([&] { read_terrain(folder.path(), {}); }),
              folder.path().string() + ": is a folder; name a file in it");
}

TEST(TerrainFile, RefusesADevice) {
    EXPECT_EQ(message_of<InputError>([&] { read_terrain("/dev/zero", {}); }),
              "/dev/zero: is not a regular file; name a file on disk");
}

TEST(TerrainFile, RefusesAnUnreadableFile) {
    if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
    const TemporaryFolder folder;
    const auto file = folder.file("a.asc", "ncols 2");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    EXPECT_EQ(
        message_of<InputError>([&] { read_terrain(file, {}); }),
        file.string() +
            ": cannot be read: Permission denied; name a file that exists and that you may read");
}

TEST(TerrainFile, RefusesAFileBeyondTheLimitWithoutReadingIt) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.asc", "ncols 2");
    std::filesystem::resize_file(file, 100'000'000'000);  // sparse
    EXPECT_EQ(message_of<InputError>([&] { read_terrain(file, {}); }),
              file.string() +
                  ": has 100000000000 bytes; at most 4294967296 are read; cut out or "
                  "coarsen the part you need");
}

TEST(TerrainFile, RefusesAHeightRangeForAnEsriGrid) {
    const TemporaryFolder folder;
    const auto file = folder.file("a.asc", grid_head + "1 2 3 4");
    EXPECT_EQ(message_of<InputError>([&] {
                  read_terrain(file, {{0.0, 1.0}});
              }),
              file.string() +
                  ": a height range was given for an ESRI ASCII grid, which holds its own "
                  "heights; leave bed.heights or --heights out");
}

}  // namespace
}  // namespace fumon
