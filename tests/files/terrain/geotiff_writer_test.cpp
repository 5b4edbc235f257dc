// GeoTIFFs and ESRI grids that fumon writes, read by GDAL and by fumon.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/geotiff.h"
#include "files/terrain/terrain_file.h"
#include "files/terrain/terrain_format.h"
#include "support/grid_values.h"
#include "support/raster_test.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

using WrittenRaster = RasterTest;

/// A bed that lies somewhere, with a hole.
struct Written {
    Grid heights{3, 2};
    Mask nodata{3, 2};
    WorldScale scale{10.0, 10.0, 1.0, true};

    explicit Written(GeoReference place) {
        for (std::size_t k = 0; k < 6; ++k) heights.values()[k] = 0.1 * static_cast<double>(k);
        nodata(1, 1) = 1;
        scale.place = std::move(place);
    }
    [[nodiscard]] std::vector<TerrainBytes> files(const char* format) const {
        return find_written_format(format)->write({heights, nodata, scale});
    }
};

TEST_F(WrittenRaster, AWrittenBedReadsBackTheSame) {
    const Terrain from = read({});
    const Written written(*from.place);
    const auto files = written.files("geotiff");
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0].ending, ".tif");
    const Terrain back = read_terrain(folder_.file("back.tif", files[0].bytes));
    EXPECT_EQ(back.nodata, written.nodata);
    for (std::size_t k = 0; k < 6; ++k) {
        if (written.nodata.values()[k] == 0) {
            EXPECT_EQ(back.heights.values()[k], written.heights.values()[k]);
        }
    }
    EXPECT_EQ(back.place, from.place);
    EXPECT_EQ(written.files("geotiff")[0].bytes, files[0].bytes) << "the same bytes every time";
}

TEST_F(WrittenRaster, GdalFindsAWrittenBedWhereItLies) {
    const Written written(*read({}).place);
    const std::string file = folder_.file("bed.tif", written.files("geotiff")[0].bytes).string();
    GDALDatasetH dataset =
        GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
    ASSERT_NE(dataset, nullptr);
    std::array<double, 6> transform{};
    EXPECT_EQ(GDALGetGeoTransform(dataset, transform.data()), CE_None);
    EXPECT_EQ(transform, (std::array<double, 6>{500000, 10, 0, 4000020, 0, -10}));
    EXPECT_STREQ(OSRGetAuthorityCode(GDALGetSpatialRef(dataset), nullptr), "32613");
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    EXPECT_EQ(GDALGetRasterDataType(band), GDT_Float64);
    EXPECT_STREQ(GDALGetRasterUnitType(band), "m");
    EXPECT_EQ(GDALGetRasterNoDataValue(band, nullptr), -9999.0);
    double first = 0.0;
    EXPECT_EQ(GDALRasterIO(band, GF_Read, 0, 0, 1, 1, &first, 1, 1, GDT_Float64, 0, 0), CE_None);
    EXPECT_EQ(first, written.heights(0, 1)) << "the northern row first";
    GDALClose(dataset);
}

TEST_F(WrittenRaster, WhatIsNoHeightHasItsUnitAndDescription) {
    const Written written({4000.0, 7000.0, 10.0, 10.0});
    const TerrainOutput slope{written.heights, written.nodata, written.scale, "slope: a < b",
                              "degree"};
    for (const auto* format : {"geotiff", "cloud-optimized-geotiff"}) {
        const std::string file =
            folder_.file("slope.tif", find_written_format(format)->write(slope)[0].bytes).string();
        const GDALDatasetH dataset =
            GDALOpenEx(file.c_str(), GDAL_OF_RASTER, nullptr, nullptr, nullptr);
        ASSERT_NE(dataset, nullptr);
        const GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
        EXPECT_STREQ(GDALGetDescription(band), "slope: a < b") << format;
        EXPECT_STREQ(GDALGetRasterUnitType(band), "degree") << format;
        int has_nodata = 0;
        EXPECT_EQ(GDALGetRasterNoDataValue(band, &has_nodata), -9999.0);
        EXPECT_EQ(has_nodata, 1);
        GDALClose(dataset);
    }
    const auto grid = find_written_format("esri-ascii")->write(slope);
    ASSERT_EQ(grid.size(), 2U);
    EXPECT_EQ(grid[1].ending, ".asc.aux.xml");
    EXPECT_NE(grid[1].bytes.find("<Description>slope: a &lt; b</Description>"), std::string::npos);
}

TEST_F(WrittenRaster, APictureLiesWhereItWasTakenFrom) {
    Image picture(3, 2);
    for (std::size_t k = 0; k < picture.rgb.size(); ++k)
        picture.rgb[k] = static_cast<std::uint8_t>(10 * k);
    GeoReference place = *read({}).place;
    place.dx = 4.0;
    const std::string bytes = geotiff_picture(picture, place);
    EXPECT_EQ(geotiff_picture(picture, place), bytes) << "the same bytes every time";
    GDALDatasetH dataset = GDALOpenEx(folder_.file("picture.tif", bytes).c_str(),
                                      GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
    ASSERT_NE(dataset, nullptr);
    std::array<double, 6> transform{};
    EXPECT_EQ(GDALGetGeoTransform(dataset, transform.data()), CE_None);
    EXPECT_EQ(transform, (std::array<double, 6>{500000, 4, 0, 4000020, 0, -10}));
    EXPECT_STREQ(OSRGetAuthorityCode(GDALGetSpatialRef(dataset), nullptr), "32613");
    ASSERT_EQ(GDALGetRasterCount(dataset), 3);
    EXPECT_EQ(GDALGetRasterColorInterpretation(GDALGetRasterBand(dataset, 3)), GCI_BlueBand);
    std::array<std::uint8_t, 6> green{};
    EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, 2), GF_Read, 0, 0, 3, 2, green.data(), 3, 2,
                           GDT_Byte, 0, 0),
              CE_None);
    EXPECT_EQ(green, (std::array<std::uint8_t, 6>{10, 40, 70, 100, 130, 160})) << "top row first";
    GDALClose(dataset);
}

TEST_F(WrittenRaster, AnEsriGridKeepsThePlaceTooAndItsPrjBesideIt) {
    const Written written(*read({}).place);
    const auto files = written.files("esri-ascii");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_NE(files[0].bytes.find("xllcorner 500000\nyllcorner 4000000\ncellsize 10\n"),
              std::string::npos)
        << files[0].bytes;
    EXPECT_EQ(files[1].ending, ".prj");
    EXPECT_TRUE(files[1].bytes.starts_with("PROJCS[\"WGS_1984_UTM_Zone_13N\"")) << files[1].bytes;
    const fs::path grid = folder_.file("bed.asc", files[0].bytes);
    folder_.file("bed.prj", files[1].bytes);
    const Terrain back = read_terrain(grid);
    ASSERT_TRUE(back.place);
    EXPECT_EQ(back.place->west, 500000.0);
    EXPECT_EQ(back.place->crs + "\n", files[1].bytes);
    const auto again = Written(*back.place).files("geotiff");
    const Terrain tiff = read_terrain(folder_.file("again.tif", again[0].bytes));
    EXPECT_NE(tiff.place->crs.find("UTM zone 13N"), std::string::npos) << tiff.place->crs;
}

TEST_F(WrittenRaster, WithoutMetresABedIsWrittenNowhere) {
    const Grid heights(4, 3, 1.0);
    const auto files = find_written_format("geotiff")->write({heights, {}, {}});
    const Terrain back = read_terrain(folder_.file("sites.tif", files[0].bytes));
    EXPECT_EQ(back.dx, 0.0);
    EXPECT_EQ(back.heights, heights);
}

TEST_F(WrittenRaster, ACloudOptimizedOneHasTilesAndOverviewsAndTheSameHeights) {
    Raster raster;
    raster.nx = 700;
    raster.ny = 600;
    raster.values.resize(700U * 600U);
    for (std::size_t i = 0; i < raster.values.size(); ++i)
        raster.values[i] = std::sin(0.01 * static_cast<double>(i));
    const Terrain terrain = read(raster);
    const WorldScale scale{terrain.dx, terrain.dy, 1.0, true, terrain.place};
    const TerrainFormat* format = find_written_format("cloud-optimized-geotiff");
    ASSERT_NE(format, nullptr);
    const auto files = format->write({terrain.heights, terrain.nodata, scale});
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0].ending, ".cog.tif");
    EXPECT_EQ(format->write({terrain.heights, terrain.nodata, scale})[0].bytes, files[0].bytes);
    const fs::path file = folder_.path() / "bed.cog.tif";
    std::ofstream(file, std::ios::binary) << files[0].bytes;
    EXPECT_EQ(values_of(read_terrain(file).heights), values_of(terrain.heights));
    EXPECT_EQ(read_terrain(file).place, terrain.place);
    GDALDatasetH dataset =
        GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
    ASSERT_NE(dataset, nullptr);
    EXPECT_STREQ(GDALGetMetadataItem(dataset, "LAYOUT", "IMAGE_STRUCTURE"), "COG");
    EXPECT_EQ(GDALGetOverviewCount(GDALGetRasterBand(dataset, 1)), 1);
    int width = 0;
    int height = 0;
    GDALGetBlockSize(GDALGetRasterBand(dataset, 1), &width, &height);
    EXPECT_EQ(width, 512);
    GDALClose(dataset);
}

/// Where a bed lies that is written, and what it is in the end.
struct PlaceCase {
    const char* name;
    const char* crs;
    double west;
    double south;
    double cell;
};

class WrittenPlace : public RasterTest, public ::testing::WithParamInterface<PlaceCase> {
  protected:
    /// What GDAL finds in a file.
    static void expect_place(const fs::path& file, const PlaceCase& one) {
        CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "NO");
        GDALDatasetH dataset =
            GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
        CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", nullptr);
        ASSERT_NE(dataset, nullptr) << file;
        std::array<double, 6> transform{};
        EXPECT_EQ(GDALGetGeoTransform(dataset, transform.data()), CE_None);
        const double near = 1e-9 * std::abs(one.west) + 1e-12;
        EXPECT_NEAR(transform[0], one.west, near);
        EXPECT_NEAR(transform[3], one.south + 2 * one.cell, near);
        EXPECT_NEAR(transform[1], one.cell, 1e-12 * one.cell);
        EXPECT_NEAR(transform[5], -one.cell, 1e-12 * one.cell);
        OGRSpatialReferenceH found = GDALGetSpatialRef(dataset);
        EXPECT_EQ(found != nullptr, *one.crs != '\0');
        if (found != nullptr && *one.crs != '\0') {
            OGRSpatialReferenceH wanted = OSRNewSpatialReference(nullptr);
            EXPECT_EQ(OSRSetFromUserInput(wanted, one.crs), OGRERR_NONE);
            EXPECT_EQ(OSRIsProjected(found), OSRIsProjected(wanted));
            EXPECT_EQ(OSRIsGeographic(found), OSRIsGeographic(wanted));
            if (OSRIsProjected(wanted) != 0) {
                EXPECT_NEAR(OSRGetLinearUnits(found, nullptr), OSRGetLinearUnits(wanted, nullptr),
                            1e-12);
            }
            EXPECT_EQ(OSRGetSemiMajor(found, nullptr), OSRGetSemiMajor(wanted, nullptr));
            OSRDestroySpatialReference(wanted);
        }
        GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
        int has = 0;
        const double missing = GDALGetRasterNoDataValue(band, &has);
        EXPECT_EQ(has, 1);
        std::array<double, 6> rows{};
        EXPECT_EQ(GDALRasterIO(band, GF_Read, 0, 0, 3, 2, rows.data(), 3, 2, GDT_Float64, 0, 0),
                  CE_None);
        EXPECT_EQ(rows[1], missing);
        EXPECT_NEAR(rows[0], 0.1 * 3.0, 1e-7);
        EXPECT_NEAR(rows[5], 0.1 * 2.0, 1e-7) << "the southern row last";
        GDALClose(dataset);
    }
};

TEST_P(WrittenPlace, IsWhereGdalAndFumonFindIt) {
    GDALAllRegister();
    const PlaceCase& one = GetParam();
    Raster raster;
    raster.crs = one.crs;
    raster.transform = {one.west, one.cell, 0, one.south + 2 * one.cell, 0, -one.cell};
    const Terrain from = read(raster);
    Written written(*from.place);
    written.scale.dx = from.dx;
    written.scale.dy = from.dy;
    for (const char* format : {"geotiff", "cloud-optimized-geotiff", "esri-ascii"}) {
        SCOPED_TRACE(format);
        fs::path file;
        for (const TerrainBytes& part : written.files(format)) {
            const fs::path made = folder_.file(std::string(format) + part.ending, part.bytes);
            if (file.empty()) file = made;
        }
        expect_place(file, one);
        const Terrain back = read_terrain(file);
        ASSERT_TRUE(back.place);
        EXPECT_NEAR(back.place->west, one.west, 1e-9 * std::abs(one.west) + 1e-12);
        EXPECT_NEAR(back.place->south, one.south, 1e-9 * std::abs(one.south) + 1e-12);
        EXPECT_NEAR(back.dx, from.dx, 1e-8 * from.dx);
        EXPECT_NEAR(back.dy, from.dy, 1e-8 * from.dy);
        EXPECT_EQ(back.nodata, written.nodata);
        EXPECT_EQ(back.heights(2, 0), written.heights(2, 0));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Systems, WrittenPlace,
    ::testing::Values(PlaceCase{"Utm", "EPSG:32613", 500000, 4000000, 10},
                      PlaceCase{"Lambert93", "EPSG:2154", 700000, 6600000, 5},
                      PlaceCase{"EqualArea", "EPSG:3035", 4321000, 3210000, 25},
                      PlaceCase{"UsFeet", "EPSG:2231", 3000000, 1700000, 10},
                      PlaceCase{"InternationalFeet", "EPSG:2222", 700000, 1000000, 10},
                      PlaceCase{"WebMercator", "EPSG:3857", -11700000, 4800000, 10},
                      PlaceCase{"Degrees", "EPSG:4326", -105.55, 40.05, 0.001},
                      PlaceCase{"Nad83Degrees", "EPSG:4269", -105.55, 40.05, 0.001},
                      PlaceCase{"Krovak", "EPSG:5514", -750000, -1040000, 10},
                      PlaceCase{"Polar", "EPSG:3031", 1000000, 1000000, 100},
                      PlaceCase{"None", "", 500000, 4000000, 10}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace fumon::test
