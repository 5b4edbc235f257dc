// What a raster says of itself beside its values, and files of unknown origin.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/grid_values.h"
#include "support/raster_test.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A band as one likes, with what only GDAL's calls can add.
class RasterMetadata : public RasterTest {
  protected:
    /// A raster in memory as a file of a driver that only copies.
    static void copy_of(const Raster& raster, const char* driver, const fs::path& file) {
        GDALAllRegister();
        GDALDatasetH source = GDALCreate(GDALGetDriverByName("MEM"), "", raster.nx, raster.ny, 1,
                                         raster.type, nullptr);
        std::vector<double> transform = raster.transform;
        GDALSetGeoTransform(source, transform.data());
        OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
        OSRSetFromUserInput(crs, raster.crs.c_str());
        GDALSetSpatialRef(source, crs);
        OSRDestroySpatialReference(crs);
        std::vector<double> values = raster.values;
        EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(source, 1), GF_Write, 0, 0, raster.nx, raster.ny,
                               values.data(), raster.nx, raster.ny, GDT_Float64, 0, 0),
                  CE_None);
        GDALDatasetH copy = GDALCreateCopy(GDALGetDriverByName(driver), file.c_str(), source, 0,
                                           nullptr, nullptr, nullptr);
        ASSERT_NE(copy, nullptr) << driver;
        GDALClose(copy);
        GDALClose(source);
    }
};

TEST_F(RasterMetadata, AMaskBesideTheFileHidesCells) {
    Raster raster;
    raster.more = with_mask(false, {255, 255, 0, 0, 255, 255});
    const Terrain terrain = read(raster);
    ASSERT_TRUE(fs::exists(folder_.path() / "dem.tif.msk"));
    ASSERT_FALSE(terrain.nodata.empty());
    EXPECT_EQ(std::ranges::count(terrain.nodata.values(), 1), 2);
    EXPECT_EQ(terrain.nodata(0, 0), 1);
    EXPECT_EQ(terrain.nodata(2, 1), 1);
}

TEST_F(RasterMetadata, SignedBytesKeepTheirSign) {
    Raster raster;
    // From GDAL 3.7 on a type of its own, before it bytes with a note.
    raster.type = GDALGetDataTypeByName("Int8");
    raster.values = {-128, -1, 0, 1, 127, -127};
    if (raster.type == GDT_Unknown) {
        raster.type = GDT_Byte;
        raster.options = {"PIXELTYPE=SIGNEDBYTE"};
        raster.values = {128, 255, 0, 1, 127, 129};
    }
    EXPECT_EQ(values_of(read(raster).heights), (std::vector<double>{1, 127, -127, -128, -1, 0}));
}

TEST_F(RasterMetadata, AlphaHidesCells) {
    Raster raster;
    raster.bands = 2;
    raster.type = GDT_UInt16;
    raster.options = {"ALPHA=YES"};
    raster.more = [](GDALDatasetH dataset) {
        GDALSetRasterColorInterpretation(GDALGetRasterBand(dataset, 2), GCI_AlphaBand);
    };
    raster.values = {1, 2, 3, 4, 5, 6};
    const fs::path file = write(folder_.path() / "dem.tif", raster);
    GDALDatasetH dataset = GDALOpenEx(file.c_str(), GDAL_OF_RASTER | 1U, nullptr, nullptr, nullptr);
    std::array<double, 6> alpha{65535, 0, 65535, 65535, 65535, 65535};
    EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, 2), GF_Write, 0, 0, 3, 2, alpha.data(), 3, 2,
                           GDT_Float64, 0, 0),
              CE_None);
    GDALClose(dataset);
    const Terrain terrain = read_terrain(file);
    ASSERT_FALSE(terrain.nodata.empty());
    EXPECT_EQ(terrain.nodata(1, 1), 1);
    EXPECT_EQ(std::ranges::count(terrain.nodata.values(), 1), 1);
}

TEST_F(RasterMetadata, OneOfSeveralPagesIsNamed) {
    Raster raster;
    const fs::path file = write(folder_.path() / "pages.tif", raster);
    Raster second;
    second.values = {7, 8, 9, 10, 11, 12};
    second.options = {"APPEND_SUBDATASET=YES"};
    write(file, second);
    const std::string message = message_of<InputError>([&] { (void)read_terrain(file); });
    EXPECT_EQ(message, file.string() + ": holds 2 grids: 1, 2; choose one by bed.variable");
    EXPECT_EQ(read_terrain(file, {.variable = "2"}).heights(0, 0), 10.0);
    EXPECT_EQ(message_of<InputError>([&] { (void)read_terrain(file, {.variable = "dem"}); }),
              file.string() + ": holds no grid \"dem\"; write bed.variable as one of 1, 2");
}

TEST_F(RasterMetadata, MercatorsLengthsAreTrueAndSaid) {
    Raster raster;
    raster.crs = "EPSG:3857";
    raster.transform = {-11700000, 10, 0, 4800020, 0, -10};
    const Terrain terrain = read(raster);
    EXPECT_EQ(terrain.note,
              "cells of 10 m × 10 m in the projection are 7.72176 m × 7.69093 m on the ground, "
              "which counts");
    EXPECT_EQ(terrain.place->dx, 10.0) << "what is written keeps the file's coordinates";
    Raster far = raster;  // from the middle of zone 13: 1.00159
    far.crs = "EPSG:32613";
    far.transform = {90000, 10, 0, 4000020, 0, -10};
    const Terrain left = read(far);
    EXPECT_EQ(left.dx, 10.0);
    EXPECT_NE(left.note.find("which is left as it is"), std::string::npos) << left.note;
}

TEST_F(RasterMetadata, APrjOfSeveralLinesOrOfWordsCounts) {
    const std::string grid =
        "ncols 2\nnrows 2\nxllcorner 3000000\nyllcorner 1700000\ncellsize 10\n1 2\n3 4\n";
    const auto with_prj = [&](const std::string& prj) {
        folder_.file("dem.prj", prj);
        return read_terrain(folder_.file("dem.asc", grid));
    };
    const Terrain lines = with_prj(
        "PROJCS[\"a\",\r\n    GEOGCS[\"b\",\r\n        DATUM[\"D_North_American_1983\",\n"
        "            SPHEROID[\"GRS_1980\",6378137,298.257222101]],\n        "
        "PRIMEM[\"Greenwich\",0],\n"
        "        UNIT[\"Degree\",0.0174532925199433]],\n    "
        "PROJECTION[\"Lambert_Conformal_Conic\"],\n"
        "    PARAMETER[\"False_Easting\",3000000],\n    PARAMETER[\"False_Northing\",1000000],\n"
        "    PARAMETER[\"Central_Meridian\",-105.5],\n    "
        "PARAMETER[\"Standard_Parallel_1\",39.7],\n"
        "    PARAMETER[\"Standard_Parallel_2\",40.8],\n    "
        "PARAMETER[\"Latitude_Of_Origin\",39.3],\n"
        "    UNIT[\"Foot_US\",0.304800609601219]]\n");
    EXPECT_NEAR(lines.dx, 10 * 1200.0 / 3937.0, 1e-9);
    EXPECT_EQ(lines.note, "cell size converted to metres from Foot_US");
    const Terrain words = with_prj(
        "Projection    UTM\nZone          13\nDatum         WGS84\nUnits         METERS\n"
        "Spheroid      WGS84\nZunits        NO\nParameters\n");
    EXPECT_NE(words.place->crs.find("UTM"), std::string::npos) << words.note;
    const std::string flat =
        "ncols 2\nnrows 2\nxllcorner 7\nyllcorner 53\ncellsize 0.01\n0.001 0.002\n0.003 0.001\n";
    EXPECT_EQ(read_terrain(folder_.file("coast.asc", flat)).dx, 0.01)
        << "as metres it is no needle";
    folder_.file(
        "coast.prj",
        "GEOGCS[\"WGS 84\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137,298.257223563]],"
        "PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",0.0174532925199433]]");
    const Terrain coast = read_terrain(folder_.path() / "coast.asc");
    EXPECT_TRUE(coast.place->degrees);
    EXPECT_NEAR(coast.dx, 671.2171, 1e-3) << "a hundredth of a degree at 53°";
    const Terrain unread = with_prj("nothing that is known");
    EXPECT_EQ(unread.place->crs, "");
    EXPECT_EQ(unread.note, (folder_.path() / "dem.prj").string() +
                               " holds no reference system that can be read, and is passed over");
}

TEST_F(RasterMetadata, APlaceThatIsNoGridIsRefusedWithItsRemedy) {
    Raster raster;
    raster.transform.clear();
    raster.crs = "";
    raster.more = [](GDALDatasetH dataset) {
        const std::string row = "1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0";
        for (const char* name :
             {"LINE_NUM_COEFF", "LINE_DEN_COEFF", "SAMP_NUM_COEFF", "SAMP_DEN_COEFF"})
            GDALSetMetadataItem(dataset, name, row.c_str(), "RPC");
        for (const char* name :
             {"LINE_OFF", "SAMP_OFF", "LAT_OFF", "LONG_OFF", "HEIGHT_OFF", "LINE_SCALE",
              "SAMP_SCALE", "LAT_SCALE", "LONG_SCALE", "HEIGHT_SCALE"})
            GDALSetMetadataItem(dataset, name, "1", "RPC");
    };
    EXPECT_EQ(
        refusal(raster),
        "is georeferenced by rational polynomials (RPC); warp it to a regular grid first (gdalwarp "
        "-rpc)");
}

/// The tiles of whole degrees, whose files have one size.
TEST_F(RasterMetadata, TilesOfADegreeLieWhereTheirFormatsSay) {
    struct Tile {
        const char* driver;
        const char* file;
        int cells;
    };
    for (const Tile& tile : {Tile{"DTED", "w105.dt0", 121}, Tile{"SRTMHGT", "N39W105.hgt", 1201},
                             Tile{"USGSDEM", "u.dem", 1201}}) {
        Raster raster;
        raster.nx = raster.ny = tile.cells;
        raster.type = GDT_Int16;
        raster.crs = "EPSG:4326";
        const double cell = 1.0 / (tile.cells - 1);
        raster.transform = {-105 - cell / 2, cell, 0, 40 + cell / 2, 0, -cell};
        raster.values.assign(
            static_cast<std::size_t>(tile.cells) * static_cast<std::size_t>(tile.cells), 7.0);
        raster.values[static_cast<std::size_t>(tile.cells) *
                      static_cast<std::size_t>(tile.cells - 1)] = 1700;
        const fs::path file = folder_.path() / tile.file;
        copy_of(raster, tile.driver, file);
        const Terrain terrain = read_terrain(file);
        ASSERT_EQ(terrain.heights.nx(), tile.cells) << tile.driver;
        ASSERT_EQ(terrain.heights.ny(), tile.cells);
        EXPECT_EQ(terrain.heights(0, 0), 1700.0) << tile.driver;
        EXPECT_EQ(terrain.heights(1, 0), 7.0);
        EXPECT_EQ(std::ranges::count(terrain.nodata.values(), 1), 0);
        ASSERT_TRUE(terrain.place);
        EXPECT_TRUE(terrain.place->degrees);
        EXPECT_NEAR(terrain.place->west, -105 - cell / 2, 1e-9) << tile.driver;
        EXPECT_NEAR(terrain.place->south, 39 - cell / 2, 1e-9) << tile.driver;
        EXPECT_NEAR(terrain.place->dx, cell, 1e-12);
        EXPECT_NEAR(terrain.dy, 111025.04 * cell, 0.01 * cell) << "at 39.5 degrees";
    }
}

TEST_F(RasterMetadata, EachBandHasItsOwnValueForNoData) {
    write(folder_.path() / "a.tif", {});
    Raster second;
    second.values = {11, 12, 13, 14, 15, 16};
    write(folder_.path() / "b.tif", second);
    const auto band = [](int number, const char* file, int missing) {
        return "<VRTRasterBand dataType=\"Float64\" band=\"" + std::to_string(number) +
               "\"><NoDataValue>" + std::to_string(missing) +
               "</NoDataValue><Offset>100</Offset><Scale>0.5</Scale><SimpleSource><SourceFilename "
               "relativeToVRT=\"1\">" +
               file + "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>";
    };
    const fs::path file = folder_.file(
        "bands.vrt",
        "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\"><GeoTransform>500000, 10, 0, 4000020, 0, "
        "-10</GeoTransform>" +
            band(1, "a.tif", 2) + band(2, "b.tif", 14) + "</VRTDataset>");
    const Terrain one = read_terrain(file, {.band = 1});
    EXPECT_EQ(one.nodata(1, 1), 1);
    EXPECT_EQ(std::ranges::count(one.nodata.values(), 1), 1);
    EXPECT_EQ(one.heights(0, 0), 4 * 0.5 + 100.0);
    const Terrain two = read_terrain(file, {.band = 2});
    EXPECT_EQ(two.nodata(0, 0), 1);
    EXPECT_EQ(std::ranges::count(two.nodata.values(), 1), 1);
    EXPECT_EQ(two.heights(1, 0), 15 * 0.5 + 100.0);
}

/// Lines of GXF, which GDAL reads and does not write.
TEST_F(RasterMetadata, GxfIsRead) {
    const fs::path file = folder_.file(
        "a.gxf",
        "#POINTS\n3\n#ROWS\n2\n#XORIGIN\n500005\n#YORIGIN\n4000005\n#PTSEPARATION\n10\n"
        "#RWSEPARATION\n10\n#ROTATION\n0\n#SENSE\n1\n#DUMMY\n-9999\n#GRID\n1 2 3\n4 -9999 6\n");
    const Terrain terrain = read_terrain(file);
    ASSERT_EQ(terrain.heights.nx(), 3);
    EXPECT_EQ(values_of(terrain.heights), (std::vector<double>{1, 2, 3, 4, 0, 6}));
    EXPECT_EQ(terrain.nodata(1, 1), 1);
    EXPECT_EQ(terrain.place->west, 500000.0);
    EXPECT_EQ(terrain.place->south, 4000000.0);
    EXPECT_EQ(terrain.dx, 10.0);
}

TEST_F(RasterMetadata, OthersFilesNameNoFile) {
    write(folder_.path() / "private.tif", {});
    const auto vrt = [&](const std::string& source) {
        const fs::path file = folder_.path() / "view.vrt";
        std::ofstream(file) << "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\"><VRTRasterBand "
                               "dataType=\"Float64\" band=\"1\"><SimpleSource><SourceFilename>"
                            << source
                            << "</SourceFilename><SourceBand>1</SourceBand></SimpleSource>"
                               "</VRTRasterBand></VRTDataset>";
        return file;
    };
    const fs::path mine = vrt((folder_.path() / "private.tif").string());
    EXPECT_EQ(read_terrain(mine).heights(0, 0), 4.0);
    for (const std::string& source :
         {(folder_.path() / "private.tif").string(), std::string("/vsicurl/http://localhost/a.tif"),
          (folder_.path() / "view.vrt").string()}) {
        const fs::path file = vrt(source);
        EXPECT_NE(message_of<InputError>([&] { (void)read_terrain(file, {.trusted = false}); }), "")
            << source;
    }
    for (const std::string& source :
         {std::string("/vsicurl/http://localhost/a.tif"), (folder_.path() / "view.vrt").string()}) {
        const fs::path file = vrt(source);
        EXPECT_NE(message_of<InputError>([&] { (void)read_terrain(file); }), "") << source;
    }
}

}  // namespace
}  // namespace fumon::test
