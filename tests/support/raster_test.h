#pragma once

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/terrain/terrain_file.h"
#include "support/gdal_more.h"
#include "support/temporary_folder.h"

namespace fumon::test {

/// What GDAL is to write.
struct Raster {
    int nx = 3;
    int ny = 2;
    std::vector<double> values{1, 2, 3, 4, 5, 6};  ///< the file's first row first
    std::vector<double> transform{500000, 10, 0, 4000020, 0, -10};
    std::string crs = "EPSG:32613";
    GDALDataType type = GDT_Float64;
    int bands = 1;
    std::vector<const char*> options{};
    const char* driver = "GTiff";
    std::function<void(GDALDatasetH)> more = [](GDALDatasetH) {};
};

inline std::filesystem::path write(const std::filesystem::path& file, const Raster& raster) {
    GDALAllRegister();
    std::vector<const char*> options = raster.options;
    options.push_back(nullptr);
    GDALDatasetH dataset = GDALCreate(GDALGetDriverByName(raster.driver), file.c_str(), raster.nx,
                                      raster.ny, raster.bands, raster.type, options.data());
    std::vector<double> transform = raster.transform;
    if (!transform.empty()) GDALSetGeoTransform(dataset, transform.data());
    if (!raster.crs.empty()) {
        OGRSpatialReferenceH crs = OSRNewSpatialReference(nullptr);
        OSRSetFromUserInput(crs, raster.crs.c_str());
        GDALSetSpatialRef(dataset, crs);
        OSRDestroySpatialReference(crs);
    }
    raster.more(dataset);
    std::vector<double> values = raster.values;
    for (int band = 1; band <= raster.bands && !values.empty(); ++band) {
        EXPECT_EQ(GDALRasterIO(GDALGetRasterBand(dataset, band), GF_Write, 0, 0, raster.nx,
                               raster.ny, values.data(), raster.nx, raster.ny, GDT_Float64, 0, 0),
                  CE_None);
        for (double& value : values) value += 100.0;
    }
    GDALClose(dataset);
    return file;
}

/// Gives a raster of 3 × 2 cells a mask, which lies inside its file or beside it; 0 hides a cell.
inline std::function<void(GDALDatasetH)> with_mask(bool inside, std::array<std::uint8_t, 6> shown) {
    return [inside, shown](GDALDatasetH dataset) mutable {
        CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", inside ? "YES" : "NO");
        GDALCreateDatasetMaskBand(dataset, GMF_PER_DATASET);
        EXPECT_EQ(GDALRasterIO(GDALGetMaskBand(GDALGetRasterBand(dataset, 1)), GF_Write, 0, 0, 3, 2,
                               shown.data(), 3, 2, GDT_Byte, 0, 0),
                  CE_None);
        CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
    };
}

/// Reads what GDAL wrote.
class RasterTest : public ::testing::Test {
  protected:
    [[nodiscard]] Terrain read(const Raster& raster, const TerrainQuery& query = {}) const {
        return read_terrain(write(folder_.path() / "dem.tif", raster), query);
    }
    [[nodiscard]] std::string refusal(const Raster& raster, const TerrainQuery& query = {}) const {
        const std::string name = (folder_.path() / "dem.tif").string();
        const std::string message = message_of<InputError>([&] { (void)read(raster, query); });
        return message.starts_with(name) ? message.substr(name.size() + 2) : message;
    }

    TemporaryFolder folder_;
};

}  // namespace fumon::test
