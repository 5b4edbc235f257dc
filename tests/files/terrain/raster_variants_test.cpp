// Rasters as people have them: one row a variant, written by GDAL and read by fumon.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "files/gdal/gdal_notes.h"
#include "files/terrain/grid_hash.h"
#include "files/terrain/raster.h"
#include "files/terrain/terrain_file.h"
#include "support/grid_values.h"
#include "support/raster_test.h"

namespace fumon::test {
namespace {

namespace fs = std::filesystem;

/// A raster of 4 × 3 cells, north first, whose south-western cell holds 9.
struct RasterCase {
    const char* name;
    const char* driver;
    const char* file;
    GDALDataType type = GDT_Float32;
    const char* crs = "EPSG:32613";
    std::vector<double> transform{500000, 10, 0, 4000030, 0, -10};
    std::vector<const char*> options{};
    double hole = std::nan("");  ///< the no-data value, which the north-eastern cell then holds
    // as read
    double dx = 10.0;  ///< metres
    double dy = 10.0;
    double corner = 9.0;  ///< the south-western height
    double tolerance = 1e-9;
    bool point = false;          ///< AREA_OR_POINT
    bool place_is_lost = false;  ///< the format has none
    double second = 2.0;         ///< the second height from the west in the northern row
};

std::ostream& operator<<(std::ostream& out, const RasterCase& variant) {
    return out << variant.name;
}

std::vector<double> values_north_first() {
    return {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
}

/// In memory, as GDAL's copying drivers want it.
GDALDatasetH memory_raster(const RasterCase& variant) {
    GDALDatasetH dataset =
        GDALCreate(GDALGetDriverByName("MEM"), "", 4, 3, 1, variant.type, nullptr);
    std::vector<double> transform = variant.transform;
    if (!transform.empty()) GDALSetGeoTransform(dataset, transform.data());
    if (*variant.crs != '\0') {
        OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
        EXPECT_EQ(OSRSetFromUserInput(crs, variant.crs), OGRERR_NONE);
        GDALSetSpatialRef(dataset, crs);
        OSRDestroySpatialReference(crs);
    }
    if (variant.point) GDALSetMetadataItem(dataset, "AREA_OR_POINT", "Point", nullptr);
    std::vector<double> values = values_north_first();
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    if (!std::isnan(variant.hole)) {
        values[3] = variant.hole;
        GDALSetRasterNoDataValue(band, variant.hole);
    }
    EXPECT_EQ(GDALRasterIO(band, GF_Write, 0, 0, 4, 3, values.data(), 4, 3, GDT_Float64, 0, 0),
              CE_None);
    return dataset;
}

/// Whether a file is none that says how cells are drawn, counted or found faster.
bool says_anything(const fs::path& file) {
    if (file.extension() == ".clr" || file.extension() == ".stx" || file.extension() == ".smp")
        return false;
    return !file.string().ends_with(".aux.xml") || !without_statistics(bytes_of(file)).empty();
}

class RasterVariant : public ::testing::TestWithParam<RasterCase> {
  protected:
    fs::path written() const {
        GDALAllRegister();
        CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "NO");
        const RasterCase& variant = GetParam();
        std::vector<const char*> options = variant.options;
        options.push_back(nullptr);
        const fs::path file = folder_.path() / variant.file;
        GDALDatasetH source = memory_raster(variant);
        GDALDriverH driver = GDALGetDriverByName(variant.driver);
        if (driver != nullptr) {
            GDALDatasetH copy =
                GDALCreateCopy(driver, file.c_str(), source, 0, options.data(), nullptr, nullptr);
            EXPECT_NE(copy, nullptr);
            if (copy != nullptr) GDALClose(copy);
        }
        GDALClose(source);
        CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", nullptr);
        return file;
    }

    TemporaryFolder folder_;
};

TEST_P(RasterVariant, IsReadWhereItLiesWithItsValuesAndHoles) {
    const RasterCase& variant = GetParam();
    GDALAllRegister();
    if (GDALGetDriverByName(variant.driver) == nullptr)
        GTEST_SKIP() << "this GDAL has no driver " << variant.driver;
    const fs::path file = written();
    const Terrain terrain = read_terrain(file);
    ASSERT_EQ(terrain.heights.nx(), 4);
    ASSERT_EQ(terrain.heights.ny(), 3);
    EXPECT_NEAR(terrain.heights(0, 0), variant.corner, variant.tolerance);
    EXPECT_NEAR(terrain.heights(1, 2), variant.second * variant.corner / 9.0, variant.tolerance);
    if (!variant.place_is_lost) {
        ASSERT_TRUE(terrain.place);
        EXPECT_NEAR(terrain.place->west, variant.transform[0], 1e-6);
        EXPECT_NEAR(terrain.place->south,
                    std::min(variant.transform[3], variant.transform[3] + 3 * variant.transform[5]),
                    1e-6);
        EXPECT_NEAR(terrain.dx, variant.dx, 1e-5 * variant.dx) << terrain.note;
        EXPECT_NEAR(terrain.dy, variant.dy, 1e-5 * variant.dy);
    }
    EXPECT_EQ(std::ranges::count(terrain.nodata.values(), 1), std::isnan(variant.hole) ? 0 : 1);
    if (!std::isnan(variant.hole)) {
        EXPECT_EQ(terrain.nodata(3, 2), 1);
    }
}

/// What GDAL reads a grid from counts in its hash.
TEST_P(RasterVariant, AllItsFilesCountInItsHash) {
    GDALAllRegister();
    if (GDALGetDriverByName(GetParam().driver) == nullptr) GTEST_SKIP();
    const fs::path file = written();
    if (fs::is_directory(file)) return;  // its files are those in the folder
    CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "NO");
    GDALDatasetH dataset =
        GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr);
    CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", nullptr);
    ASSERT_NE(dataset, nullptr);
    char** names = GDALGetFileList(dataset);
    GDALClose(dataset);
    const std::vector<GridPart> parts = grid_parts(file);
    for (char** name = names; name != nullptr && *name != nullptr; ++name) {
        if (*name == file || !says_anything(*name)) continue;
        EXPECT_EQ(std::ranges::count(parts, fs::path(*name), &GridPart::file), 1) << *name;
    }
    CSLDestroy(names);
}

constexpr double international_foot = 0.3048;
constexpr double survey_foot = 1200.0 / 3937.0;

const std::vector<double> flat_degrees{-105.55, 0.001, 0, 40.051, 0, -0.001};
// at 40.0495° on WGS 84 (Snyder 1987, eqs. 4-18 to 4-21), metres a degree
constexpr double east_degree = 85332.16425;
constexpr double north_degree = 111035.58398;
// At y = 4 800 015, φ = atan(sinh(y/a)) = 39.5448°: N cos φ / a eastward, M cos φ / a northward.
const std::vector<double> web_mercator{-11700000, 10, 0, 4800030, 0, -10};

// clang-format off
INSTANTIATE_TEST_SUITE_P(
    Kinds, RasterVariant,
    ::testing::Values(
        RasterCase{.name = "GeoTIFF", .driver = "GTiff", .file = "a.tif"},
        RasterCase{ .name = "BigTIFF", .driver = "GTiff", .file = "a.tif", .options = {"BIGTIFF=YES"}},
        RasterCase{.name = "TiledDeflate", .driver = "GTiff", .file = "a.tif", .options = {"TILED=YES", "COMPRESS=DEFLATE", "PREDICTOR=3"}},
        RasterCase{ .name = "Zstd", .driver = "GTiff", .file = "a.tif", .options = {"COMPRESS=ZSTD"}},
        RasterCase{ .name = "Lerc", .driver = "GTiff", .file = "a.tif", .options = {"COMPRESS=LERC"}},
        RasterCase{ .name = "BigEndian", .driver = "GTiff", .file = "a.tif", .options = {"ENDIANNESS=BIG"}},
        RasterCase{ .name = "HalfFloats", .driver = "GTiff", .file = "a.tif", .options = {"NBITS=16"}},
        RasterCase{.name = "TwelveBits", .driver = "GTiff", .file = "a.tif", .type = GDT_UInt16, .options = {"NBITS=12"}},
        RasterCase{ .name = "Bytes", .driver = "GTiff", .file = "a.tif", .type = GDT_Byte, .hole = 255},
        RasterCase{.name = "Int16Hole", .driver = "GTiff", .file = "a.tif", .type = GDT_Int16, .hole = -32768},
        RasterCase{.name = "UInt16Hole", .driver = "GTiff", .file = "a.tif", .type = GDT_UInt16, .hole = 65535},
        RasterCase{.name = "Int32Hole", .driver = "GTiff", .file = "a.tif", .type = GDT_Int32, .hole = -2147483648.0},
        RasterCase{.name = "UInt32Hole", .driver = "GTiff", .file = "a.tif", .type = GDT_UInt32, .hole = 4294967295.0},
        RasterCase{.name = "FloatLowestHole", .driver = "GTiff", .file = "a.tif", .type = GDT_Float32, .hole = -3.4028234663852886e38},
        RasterCase{.name = "DoubleHole", .driver = "GTiff", .file = "a.tif", .type = GDT_Float64, .hole = -1.7976931348623157e308},
        RasterCase{.name = "Cog", .driver = "COG", .file = "a.tif"},
        RasterCase{.name = "Erdas", .driver = "HFA", .file = "a.img", .hole = -9999},
        RasterCase{.name = "ErdasCompressed", .driver = "HFA", .file = "a.img", .options = {"COMPRESSED=YES"}},
        RasterCase{.name = "Envi", .driver = "ENVI", .file = "a.bsq", .hole = -9999},
        RasterCase{.name = "EnviDoubles", .driver = "ENVI", .file = "a.bil", .type = GDT_Float64, .options = {"INTERLEAVE=BIL"}},
        RasterCase{.name = "EsriFloats", .driver = "EHdr", .file = "a.flt", .hole = -9999},
        RasterCase{ .name = "EsriBil", .driver = "EHdr", .file = "a.bil", .type = GDT_Int16, .hole = -9999},
        RasterCase{.name = "Surfer6Ascii", .driver = "GSAG", .file = "a.grd", .crs = "", .tolerance = 1e-6},
        RasterCase{.name = "Surfer6Binary", .driver = "GSBG", .file = "a.grd", .crs = ""},
        RasterCase{ .name = "Surfer7", .driver = "GS7BG", .file = "a.grd", .type = GDT_Float64, .crs = ""},
        RasterCase{.name = "Xyz", .driver = "XYZ", .file = "a.xyz", .crs = ""},
        RasterCase{.name = "XyzCommas", .driver = "XYZ", .file = "a.xyz", .crs = "", .options = {"COLUMN_SEPARATOR=,"}},
        RasterCase{.name = "XyzNamed", .driver = "XYZ", .file = "a.xyz", .crs = "", .options = {"ADD_HEADER_LINE=YES"}},
        RasterCase{.name = "Jpeg2000", .driver = "JP2OpenJPEG", .file = "a.jp2", .type = GDT_UInt16, .options = {"REVERSIBLE=YES", "QUALITY=100"}},
        RasterCase{.name = "GeoPackage", .driver = "GPKG", .file = "a.gpkg", .type = GDT_Int16},
        RasterCase{ .name = "GeoPackageFloats", .driver = "GPKG", .file = "a.gpkg", .type = GDT_Float32},
        RasterCase{.name = "Saga", .driver = "SAGA", .file = "a.sdat", .hole = -99999},
        RasterCase{.name = "Idrisi", .driver = "RST", .file = "a.rst"},
        RasterCase{.name = "PcRaster", .driver = "PCRaster", .file = "a.map", .crs = "", .options = {"PCRASTER_VALUESCALE=VS_SCALAR"}},
        RasterCase{.name = "ErMapper", .driver = "ERS", .file = "a.ers"},
        RasterCase{.name = "Zarr", .driver = "Zarr", .file = "a.zarr"},
        RasterCase{.name = "EsriAsciiWithPrj", .driver = "AAIGrid", .file = "a.asc", .hole = -9999},
        RasterCase{.name = "EsriAsciiUsFeet", .driver = "AAIGrid", .file = "a.asc", .crs = "EPSG:2231", .transform = {3000000, 10, 0, 1700030, 0, -10}, .dx = 10 * survey_foot, .dy = 10 * survey_foot},
        RasterCase{.name = "EsriAsciiFlatDegrees", .driver = "AAIGrid", .file = "a.asc", .crs = "EPSG:4326", .transform = flat_degrees, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "UsFeet", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:2231", .transform = {3000000, 10, 0, 1700030, 0, -10}, .dx = 10 * survey_foot, .dy = 10 * survey_foot},
        RasterCase{.name = "InternationalFeet", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:2222", .transform = {700000, 10, 0, 1000030, 0, -10}, .dx = 10 * international_foot, .dy = 10 * international_foot},
        RasterCase{.name = "FlatDegrees", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4326", .transform = flat_degrees, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "Nad83Degrees", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4269", .transform = flat_degrees, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "CompoundUsFeet", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:2231+6360", .transform = {3000000, 10, 0, 1700030, 0, -10}, .dx = 10 * survey_foot, .dy = 10 * survey_foot, .corner = 9 * survey_foot, .tolerance = 1e-6},
        RasterCase{ .name = "CompoundMetres", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:32613+5703"},
        RasterCase{.name = "CompoundDepth", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:32613+5715", .corner = -9.0},
        RasterCase{.name = "WebMercator", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:3857", .transform = web_mercator, .dx = 7.7217524, .dy = 7.6909306},
        RasterCase{.name = "WebMercatorErdas", .driver = "HFA", .file = "a.img", .crs = "EPSG:3857", .transform = web_mercator, .dx = 7.7217524, .dy = 7.6909306},
        RasterCase{.name = "WebMercatorAscii", .driver = "AAIGrid", .file = "a.asc", .crs = "EPSG:3857", .transform = web_mercator, .dx = 7.7217524, .dy = 7.6909306},
        RasterCase{.name = "ZMapPlus", .driver = "ZMap", .file = "a.dat", .crs = "", .tolerance = 1e-6},
        RasterCase{.name = "OfR", .driver = "RRASTER", .file = "a.grd", .hole = -9999},
        RasterCase{.name = "Sigdem", .driver = "SIGDEM", .file = "a.sigdem", .tolerance = 1e-3},
        RasterCase{.name = "Hf2", .driver = "HF2", .file = "a.hf2", .tolerance = 1e-2},
        RasterCase{.name = "Ilwis", .driver = "ILWIS", .file = "a.mpr", .tolerance = 1e-3},
        RasterCase{.name = "BinaryTerrain", .driver = "BT", .file = "a.bt", .tolerance = 1e-3},
        RasterCase{.name = "Pds4", .driver = "PDS4", .file = "a.xml", .crs = "", .place_is_lost = true},
        RasterCase{.name = "Vicar", .driver = "VICAR", .file = "a.vic", .crs = "", .place_is_lost = true},
        RasterCase{.name = "Isis3", .driver = "ISIS3", .file = "a.cub", .crs = "+proj=eqc +R=3396190 +units=m", .transform = {50000, 10, 0, 40030, 0, -10}},
        RasterCase{.name = "Gtx", .driver = "GTX", .file = "a.gtx", .crs = "EPSG:4326", .transform = flat_degrees, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "NetcdfClassic", .driver = "netCDF", .file = "a.nc", .options = {"FORMAT=NC"}, .hole = -9999},
        RasterCase{.name = "Netcdf4", .driver = "netCDF", .file = "a.nc", .options = {"FORMAT=NC4"}},
        RasterCase{.name = "NetcdfDegrees", .driver = "netCDF", .file = "a.nc", .crs = "EPSG:4326", .transform = flat_degrees, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "NetcdfUsFeet", .driver = "netCDF", .file = "a.nc", .crs = "EPSG:2231", .transform = {3000000, 10, 0, 1700030, 0, -10}, .dx = 10 * survey_foot, .dy = 10 * survey_foot},
        RasterCase{.name = "BigTiffTiled", .driver = "GTiff", .file = "a.tif", .type = GDT_Float64, .options = {"BIGTIFF=YES", "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16", "COMPRESS=LZW"}},
        RasterCase{.name = "HoleBetweenFloats", .driver = "GTiff", .file = "a.tif", .type = GDT_Float32, .hole = 0.1},
        RasterCase{.name = "HoleOfDigits", .driver = "GTiff", .file = "a.tif", .type = GDT_Float64, .hole = -9999.0000000000018},
        RasterCase{.name = "SouthUp", .driver = "GTiff", .file = "a.tif", .transform = {500000, 10, 0, 4000000, 0, 10}, .corner = 1.0, .second = 90.0},
        RasterCase{.name = "PixelIsPoint", .driver = "GTiff", .file = "a.tif", .point = true},
        RasterCase{.name = "EastOfGreenwichTo360", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4326", .transform = {254.45, 0.001, 0, 40.051, 0, -0.001}, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "AcrossGreenwich", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4326", .transform = {-0.002, 0.001, 0, 40.051, 0, -0.001}, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "AcrossGreenwichAt360", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4326", .transform = {359.998, 0.001, 0, 40.051, 0, -0.001}, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "AcrossTheDateLine", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4326", .transform = {179.998, 0.001, 0, 40.051, 0, -0.001}, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "AcrossTheDateLineWest", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:4326", .transform = {-180.002, 0.001, 0, 40.051, 0, -0.001}, .dx = 0.001 * east_degree, .dy = 0.001 * north_degree},
        RasterCase{.name = "EuropeanEqualArea", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:3035", .transform = {4321000, 10, 0, 3210030, 0, -10}},
        RasterCase{.name = "Krovak", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:5514", .transform = {-750000, 10, 0, -1040000, 0, -10}},
        RasterCase{.name = "KrovakErdas", .driver = "HFA", .file = "a.img", .crs = "EPSG:5514", .transform = {-750000, 10, 0, -1040000, 0, -10}},
        RasterCase{.name = "BritishGrid", .driver = "AAIGrid", .file = "a.asc", .crs = "EPSG:27700", .transform = {400000, 10, 0, 300030, 0, -10}},
        RasterCase{.name = "NoSystem", .driver = "GTiff", .file = "a.tif", .crs = ""},
        RasterCase{.name = "Lambert93", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:2154", .transform = {700000, 10, 0, 6600030, 0, -10}},
        RasterCase{.name = "PolarStereographic", .driver = "GTiff", .file = "a.tif", .crs = "EPSG:3031", .transform = {1000000, 100, 0, 1000300, 0, -100}, .dx = 101.489263, .dy = 101.489263, .tolerance = 1e-9}),
    [](const auto& info) { return info.param.name; });
// clang-format on

}  // namespace
}  // namespace fumon::test
