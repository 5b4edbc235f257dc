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

}  // namespace
}  // namespace fumon::test
