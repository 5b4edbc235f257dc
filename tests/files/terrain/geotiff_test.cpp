// GeoTIFFs that GDAL itself writes here, read by fumon.

#include "files/terrain/geotiff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/grid_values.h"
#include "support/raster_test.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

using Geotiff = RasterTest;

TEST_F(Geotiff, KeepsHeightsOriginAndReferenceSystem) {
    const Terrain terrain = read({});
    EXPECT_EQ(values_of(terrain.heights), (std::vector<double>{4, 5, 6, 1, 2, 3}))
        << "the file's first row is the northernmost";
    EXPECT_TRUE(terrain.nodata.empty());
    EXPECT_EQ(terrain.dx, 10.0);
    EXPECT_EQ(terrain.dy, 10.0);
    EXPECT_EQ(terrain.note, "");
    ASSERT_TRUE(terrain.place);
    EXPECT_EQ(terrain.place->west, 500000.0);
    EXPECT_EQ(terrain.place->south, 4000000.0);
    EXPECT_FALSE(terrain.place->degrees);
    EXPECT_NE(terrain.place->crs.find("ID[\"EPSG\",32613]"), std::string::npos)
        << terrain.place->crs;
}

TEST_F(Geotiff, TurnsRowsAndColumnsThatRunTheOtherWay) {
    Raster south_first;
    south_first.transform = {500000, 10, 0, 4000000, 0, 10};
    EXPECT_EQ(values_of(read(south_first).heights), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(read(south_first).place->south, 4000000.0);
    Raster east_first;
    east_first.transform = {500030, -10, 0, 4000020, 0, -10};
    EXPECT_EQ(values_of(read(east_first).heights), (std::vector<double>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(read(east_first).place->west, 500000.0);
    const TerrainQuery corner{.window = TerrainWindow{500000, 4000000, 500010, 4000010}};
    EXPECT_EQ(values_of(read(south_first, corner).heights), (std::vector<double>{1}));
    EXPECT_EQ(values_of(read(east_first, corner).heights), (std::vector<double>{6}));
}

TEST_F(Geotiff, ReadsEveryRealType) {
    for (const GDALDataType type :
         {GDT_Byte, GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Float32, GDT_Float64}) {
        Raster raster;
        raster.type = type;
        EXPECT_EQ(values_of(read(raster).heights), (std::vector<double>{4, 5, 6, 1, 2, 3}))
            << GDALGetDataTypeName(type);
    }
    Raster complex;
    complex.type = GDT_CFloat32;
    EXPECT_EQ(refusal(complex), "holds complex numbers; heights are real numbers");
}

TEST_F(Geotiff, ScaledHeightsInFeetBecomeMetres) {
    Raster raster;
    raster.type = GDT_Int16;
    raster.more = [](GDALDatasetH dataset) {
        GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
        GDALSetRasterScale(band, 0.5);
        GDALSetRasterOffset(band, 100.0);
        GDALSetRasterUnitType(band, "ft");
    };
    const Terrain terrain = read(raster);
    EXPECT_NEAR(terrain.heights(0, 0), (4 * 0.5 + 100.0) * 0.3048, 1e-12);
    EXPECT_EQ(terrain.note, "heights converted to metres from ft");
    raster.more = [](GDALDatasetH dataset) {
        GDALSetRasterUnitType(GDALGetRasterBand(dataset, 1), "K");
    };
    EXPECT_EQ(refusal(raster),
              "its heights are in \"K\"; heights are in a unit of length (\"m\"); another band may "
              "hold them (bed.band)");
}

TEST_F(Geotiff, CellsWithoutDataAreMasked) {
    const double lowest = -static_cast<double>(std::numeric_limits<float>::max());
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const double missing : {-32768.0, lowest, none}) {
        Raster raster;
        raster.type = GDT_Float32;
        raster.values[4] = missing;
        raster.more = [missing](GDALDatasetH dataset) {
            GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, 1), missing);
        };
        const Terrain terrain = read(raster);
        ASSERT_FALSE(terrain.nodata.empty()) << missing;
        EXPECT_EQ(terrain.nodata(1, 0), 1) << missing;
        EXPECT_EQ(terrain.heights(1, 0), 0.0);
        EXPECT_EQ(std::ranges::count(terrain.nodata.values(), 1), 1);
    }
    Raster raster;
    raster.more = [](GDALDatasetH dataset) {
        GDALSetRasterNoDataValue(GDALGetRasterBand(dataset, 1), 7.0);
    };
    raster.values = {7, 7, 7, 7, 7, 7};
    EXPECT_EQ(refusal(raster),
              "no cell holds data; at least one height must differ from the no-data value");
    raster.values[0] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(raster),
              "the height at row 2, column 1 from the south-west is infinite; write a finite "
              "number or the no-data value");
}

TEST_F(Geotiff, TheFilesOwnMaskHidesCells) {
    Raster raster;
    raster.more = with_mask(true, {255, 255, 0, 255, 255, 255});
    const Terrain terrain = read(raster);
    ASSERT_FALSE(terrain.nodata.empty());
    EXPECT_EQ(terrain.nodata(2, 1), 1);
    EXPECT_EQ(std::ranges::count(terrain.nodata.values(), 1), 1);
}

TEST_F(Geotiff, OneOfSeveralBandsIsRead) {
    Raster raster;
    raster.bands = 3;
    raster.options = {"PHOTOMETRIC=MINISBLACK"};
    EXPECT_EQ(read(raster).heights(0, 0), 4.0);
    EXPECT_EQ(read(raster).note, "band 1 of 3 is read (bed.band chooses another)");
    EXPECT_EQ(read(raster, {.band = 3}).heights(0, 0), 204.0);
    EXPECT_EQ(read(raster, {.band = 3}).note, "");
    EXPECT_EQ(refusal(raster, {.band = 4}), "has 3 bands, not 4; write a bed.band from 1 to 3");
    raster.type = GDT_Byte;
    raster.options = {"PHOTOMETRIC=RGB"};
    EXPECT_EQ(refusal(raster),
              "is a colour picture; choose a file with heights, or name their band with bed.band");
    EXPECT_EQ(read(raster, {.band = 1}).heights(0, 0), 4.0);
}

TEST_F(Geotiff, DegreesBecomeMetresAtTheMiddleOfWhatIsRead) {
    Raster raster;
    raster.nx = 1;
    raster.ny = 4;
    raster.values = {4, 3, 2, 1};
    raster.transform = {10, 1, 0, 62, 0, -1};
    raster.crs = "EPSG:4326";
    const Terrain whole = read(raster);
    EXPECT_NEAR(whole.dx, 55800.0, 1.0) << "a degree of longitude at 60 degrees (WGS84)";
    EXPECT_NEAR(whole.dy, 111412.0, 1.0);
    EXPECT_TRUE(whole.place->degrees);
    EXPECT_EQ(whole.place->dx, 1.0);
    EXPECT_TRUE(whole.note.starts_with(
        "cell size 1° read as degrees and converted to metres at the middle latitude 60.0000°"))
        << whole.note;
    const Terrain part = read(raster, {.window = TerrainWindow{10, 58, 11, 59}});
    EXPECT_EQ(values_of(part.heights), (std::vector<double>{1}));
    EXPECT_NE(part.note.find("58.5000°"), std::string::npos) << part.note;
    raster.crs = "";
    EXPECT_EQ(read(raster).dx, 1.0) << "nothing says degrees, and the ground is flat as metres";
    raster.values = {4000, 3, 2, 1};
    EXPECT_TRUE(read(raster).place->degrees) << "as metres it would be a needle";
}

TEST_F(Geotiff, FeetOfAProjectionBecomeMetres) {
    Raster raster;
    raster.crs = "EPSG:2229";  // California zone 5, US survey feet
    raster.transform = {6500000, 10, 0, 1800020, 0, -10};
    const Terrain terrain = read(raster);
    EXPECT_NEAR(terrain.dx, 10 * 1200.0 / 3937.0, 1e-9);
    EXPECT_EQ(terrain.place->dx, 10.0);
    EXPECT_EQ(terrain.note, "cell size converted to metres from US survey foot");
}

TEST_F(Geotiff, WithoutAPlaceThereIsNoCellSize) {
    Raster raster;
    raster.transform.clear();
    raster.crs = "";
    const Terrain terrain = read(raster, {.window = TerrainWindow{1, 0, 3, 1}});
    EXPECT_EQ(terrain.dx, 0.0);
    EXPECT_FALSE(terrain.place);
    EXPECT_EQ(values_of(terrain.heights), (std::vector<double>{5, 6}));
}

TEST_F(Geotiff, WhatIsNoEvenGridIsRefused) {
    Raster rotated;
    rotated.transform = {500000, 10, 1, 4000020, 1, -10};
    EXPECT_EQ(refusal(rotated),
              "has rotated or skewed cells; warp it to a north-up grid first (gdalwarp)");
    Raster tied;
    tied.transform.clear();
    tied.crs = "";
    tied.more = [](GDALDatasetH dataset) {
        struct Point {  // GDAL_GCP
            const char* id = "";
            const char* info = "";
            double dfGCPPixel = 0.0, dfGCPLine = 0.0, dfGCPX = 0.0, dfGCPY = 0.0, dfGCPZ = 0.0;
        };
        std::array<Point, 4> points{};
        for (std::size_t k = 0; k < 4; ++k) {
            points[k].dfGCPPixel = static_cast<double>(k % 2) * 3.0;
            points[k].dfGCPLine = static_cast<double>(k / 2) * 2.0;
            points[k].dfGCPX = static_cast<double>(k * k);
            points[k].dfGCPY = static_cast<double>(k);
        }
        EXPECT_EQ(GDALSetGCPs(dataset, 4, points.data(), ""), CE_None);
    };
    EXPECT_EQ(
        refusal(tied),
        "is georeferenced by ground control points; warp it to a regular grid first (gdalwarp)");
}

TEST_F(Geotiff, AHugeRasterIsReadThroughAWindow) {
    Raster raster;
    raster.nx = 20000;
    raster.ny = 10000;
    raster.values.clear();
    raster.type = GDT_Byte;
    raster.transform = {0, 1, 0, 10000, 0, -1};
    raster.options = {"SPARSE_OK=TRUE", "TILED=YES"};
    raster.more = [](GDALDatasetH dataset) {
        std::array<double, 2> two{8, 9};
        EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, 1), GF_Write, 15000, 2000, 2, 1,
                               two.data(), 2, 1, GDT_Float64, 0, 0),
                  CE_None);
    };
    EXPECT_EQ(refusal(raster),
              "20000 × 10000 = 200000000 cells; at most 134217728 are read; choose a part of the "
              "file with bed.window");
    const Terrain part = read(raster, {.window = TerrainWindow{15000, 7998, 15002, 8000}});
    EXPECT_EQ(values_of(part.heights), (std::vector<double>{0, 0, 8, 9}));
    EXPECT_EQ(part.place->west, 15000.0);
    EXPECT_EQ(part.place->south, 7998.0);
}

TEST_F(Geotiff, DamagedFilesGiveOneLine) {
    Raster raster;
    raster.nx = raster.ny = 64;
    raster.values.assign(64 * 64, 3.25);
    for (std::size_t k = 0; k < raster.values.size(); ++k)
        raster.values[k] += static_cast<double>(k * k % 97);
    raster.options = {"COMPRESS=DEFLATE"};
    const fs::path file = write(folder_.path() / "dem.tif", raster);
    const std::string whole = test::bytes_of(file);
    ::testing::internal::CaptureStderr();
    for (const std::size_t length :
         {std::size_t{8}, std::size_t{20}, whole.size() / 2, whole.size() - 40}) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << whole.substr(0, length);
        const std::string message = message_of<InputError>([&] { (void)read_terrain(file); });
        EXPECT_TRUE(message.starts_with(file.string() + ": cannot be read as a GeoTIFF: "))
            << length << ": " << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
        EXPECT_EQ(message.find(file.string(), 1), std::string::npos) << message;
    }
    std::ofstream(file, std::ios::binary | std::ios::trunc) << "not one at all";
    EXPECT_EQ(message_of<InputError>([&] { (void)read_terrain(file); }),
              file.string() +
                  ": cannot be read as a GeoTIFF; it may be cut short, damaged or wrongly named: "
                  "copy it again");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "GDAL says nothing itself";
}

TEST_F(Geotiff, NoSingleWrongByteBreaksTheReader) {
    Raster raster;
    raster.options = {"COMPRESS=DEFLATE"};
    const fs::path file = write(folder_.path() / "dem.tif", raster);
    const std::string whole = test::bytes_of(file);
    int read = 0;
    int refused = 0;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        for (const char flip : {'\x01', '\x80'}) {
            std::string damaged = whole;
            damaged[k] = static_cast<char>(damaged[k] ^ flip);
            std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
            try {
                (void)read_terrain(file);
                ++read;
            } catch (const InputError& fault) {
                EXPECT_TRUE(std::string(fault.what()).starts_with(file.string() + ":"));
                ++refused;
            }
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 20);
}

TEST_F(Geotiff, AWorldFileBesideItPlacesItWhereItsUserNamedIt) {
    Raster raster;
    raster.transform.clear();
    raster.crs = "";
    std::ofstream(folder_.path() / "dem.tfw") << "5\n0\n0\n-5\n100\n200\n";
    EXPECT_EQ(read(raster).dx, 5.0);
    EXPECT_EQ(read(raster, {.trusted = false}).dx, 0.0) << "nothing beside it is read of others'";
}

TEST_F(Geotiff, ReadsAVirtualRasterOfTwoFiles) {
    Raster west;
    Raster east;
    east.transform[0] = 500030;
    east.values = {7, 8, 9, 10, 11, 12};
    write(folder_.path() / "west.tif", west);
    write(folder_.path() / "east.tif", east);
    const auto vrt = [&](const std::string& west_name) {
        const auto source = [](const std::string& name, int x) {
            return "<SimpleSource><SourceFilename relativeToVRT=\"1\">" + name +
                   "</SourceFilename><SourceBand>1</SourceBand><SrcRect xOff=\"0\" yOff=\"0\" "
                   "xSize=\"3\" ySize=\"2\"/><DstRect xOff=\"" +
                   std::to_string(x) + "\" yOff=\"0\" xSize=\"3\" ySize=\"2\"/></SimpleSource>";
        };
        const fs::path file = folder_.path() / "both.vrt";
        std::ofstream(file) << "<VRTDataset rasterXSize=\"6\" rasterYSize=\"2\"><SRS>EPSG:32613"
                               "</SRS><GeoTransform>500000, 10, 0, 4000020, 0, -10</GeoTransform>"
                               "<VRTRasterBand dataType=\"Float64\" band=\"1\">"
                            << source(west_name, 0) << source("east.tif", 3)
                            << "</VRTRasterBand></VRTDataset>";
        return file;
    };
    const Terrain terrain = read_terrain(vrt("west.tif"));
    EXPECT_EQ(values_of(terrain.heights),
              (std::vector<double>{4, 5, 6, 10, 11, 12, 1, 2, 3, 7, 8, 9}));
    ASSERT_TRUE(terrain.place);
    EXPECT_EQ(terrain.place->west, 500000.0);
    EXPECT_THROW((void)read_terrain(vrt("/vsicurl/http://127.0.0.1/west.tif")), InputError);
}

}  // namespace
}  // namespace fumon::test
