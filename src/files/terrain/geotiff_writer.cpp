#include "files/terrain/geotiff_writer.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/error.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/spatial_reference.h"
#include "files/terrain/esri_ascii.h"
#include "files/terrain/geotiff.h"

namespace fumon {

namespace {

/// A file in memory, under a name that is in use while GDAL is locked.
class MemoryFile {
  public:
    explicit MemoryFile(const char* name) : name_(name) {}
    ~MemoryFile() { gdal().VSIUnlink(name_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    [[nodiscard]] const char* name() const { return name_; }
    [[nodiscard]] std::string bytes() const {
        vsi_l_offset length = 0;
        const GByte* begin = gdal().VSIGetMemFileBuffer(name_, &length, 0);
        if (begin == nullptr) return {};
        return {begin, begin + length};
    }

  private:
    const char* name_;
};

void place_at(GDALDatasetH dataset, const GeoReference& place, int rows) {
    const double north = place.south + place.dy * rows;
    std::array<double, 6> transform{place.west, place.dx, 0.0, north, 0.0, -place.dy};
    gdal().GDALSetGeoTransform(dataset, transform.data());
    if (place.crs.empty() && !place.degrees) return;
    const SpatialReference crs(place.crs.empty() ? degrees_of_unknown_datum : place.crs);
    if (crs.understood()) gdal().GDALSetSpatialRef(dataset, crs.get());
}

void place(GDALDatasetH dataset, const TerrainOutput& terrain) {
    const WorldScale& scale = terrain.scale;
    if (!scale.in_metres) return;
    place_at(dataset, scale.place.value_or(GeoReference{0.0, 0.0, scale.dx, scale.dy}),
             terrain.heights.ny());
}

/// What the numbers are, as programs show it beside them.
void describe(GDALRasterBandH band, const TerrainOutput& terrain) {
    if (terrain.description.empty()) {
        if (terrain.scale.in_metres) gdal().GDALSetRasterUnitType(band, "m");
        return;
    }
    gdal().GDALSetDescription(band, terrain.description.c_str());
    gdal().GDALSetRasterUnitType(band, terrain.unit.c_str());
}

void write_rows(GDALRasterBandH band, const TerrainOutput& terrain) {
    const Grid& heights = terrain.heights;
    const Mask& nodata = terrain.nodata;
    const double missing = nodata.empty() ? 0.0 : unused_height(heights);
    if (!nodata.empty()) gdal().GDALSetRasterNoDataValue(band, missing);
    describe(band, terrain);
    std::vector<double> row(static_cast<std::size_t>(heights.nx()));
    for (int y = heights.ny() - 1; y >= 0; --y) {
        for (int x = 0; x < heights.nx(); ++x) {
            const bool hole = !nodata.empty() && nodata(x, y) != 0;
            row[static_cast<std::size_t>(x)] = hole ? missing : heights(x, y);
        }
        const CPLErr status =
            gdal().GDALRasterIO(band, GF_Write, 0, heights.ny() - 1 - y, heights.nx(), 1,
                                row.data(), heights.nx(), 1, GDT_Float64, 0, 0);
        if (status != CE_None) return;  // the session knows why
    }
}

/// The whole terrain as a GeoTIFF in memory.
void write_tiff(const MemoryFile& file, const TerrainOutput& terrain) {
    const std::array<const char*, 4> options{"COMPRESS=DEFLATE", "PREDICTOR=3", "NUM_THREADS=1",
                                             nullptr};
    GdalDataset dataset(gdal().GDALCreate(gdal().GDALGetDriverByName("GTiff"), file.name(),
                                          terrain.heights.nx(), terrain.heights.ny(), 1,
                                          GDT_Float64, options.data()));
    if (dataset.get() == nullptr) return;  // the session knows why
    place(dataset.get(), terrain);
    write_rows(gdal().GDALGetRasterBand(dataset.get(), 1), terrain);
    dataset.close();
}

void refuse_fault(const char* what, const std::string& bytes, const GdalSession& session) {
    if (session.fault().empty() && !bytes.empty()) return;
    throw Error(fmt::format("{} cannot be written as a GeoTIFF: {}", what, session.fault()));
}

/// The channels of a picture's pixels as three bands.
void write_channels(GDALDatasetH dataset, const Image& picture) {
    constexpr int channels = 3;
    std::vector<std::uint8_t> pixels = picture.rgb;  // which GDAL wants to be able to change
    for (int channel = 0; channel < channels; ++channel) {
        const CPLErr status = gdal().GDALRasterIO(
            gdal().GDALGetRasterBand(dataset, channel + 1), GF_Write, 0, 0, picture.width,
            picture.height, pixels.data() + channel, picture.width, picture.height, GDT_Byte,
            channels, channels * picture.width);
        if (status != CE_None) return;  // the session knows why
    }
}

std::vector<TerrainBytes> written(const char* ending, std::string bytes,
                                  const GdalSession& session) {
    refuse_fault("a bed", bytes, session);
    std::vector<TerrainBytes> files;
    files.push_back({ending, std::move(bytes)});
    return files;
}

}  // namespace

std::vector<TerrainBytes> write_geotiff(const TerrainOutput& terrain) {
    const GdalSession session;
    const MemoryFile file("/vsimem/fumon-terrain.tif");
    write_tiff(file, terrain);
    return written(".tif", file.bytes(), session);
}

std::vector<TerrainBytes> write_cloud_geotiff(const TerrainOutput& terrain) {
    const GdalSession session;
    const MemoryFile plain("/vsimem/fumon-terrain.tif");
    const MemoryFile tiled("/vsimem/fumon-terrain.cog.tif");
    write_tiff(plain, terrain);
    constexpr std::array<const char*, 2> drivers{"GTiff", nullptr};
    const std::array<const char*, 6> options{"COMPRESS=DEFLATE", "PREDICTOR=YES",
                                             "BLOCKSIZE=512",    "OVERVIEW_RESAMPLING=AVERAGE",
                                             "NUM_THREADS=1",    nullptr};
    GdalDataset source(gdal().GDALOpenEx(plain.name(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                         drivers.data(), nullptr, nullptr));
    if (source.get() != nullptr) {
        GdalDataset copy(gdal().GDALCreateCopy(gdal().GDALGetDriverByName("COG"), tiled.name(),
                                               source.get(), 0, options.data(), nullptr, nullptr));
        copy.close();
    }
    return written(".cog.tif", tiled.bytes(), session);
}

std::string geotiff_picture(const Image& picture, const GeoReference& place) {
    const GdalSession session;
    const MemoryFile file("/vsimem/fumon-picture.tif");
    constexpr std::array<const char*, 5> options{"COMPRESS=DEFLATE", "PREDICTOR=2",
                                                 "PHOTOMETRIC=RGB", "NUM_THREADS=1", nullptr};
    GdalDataset dataset(gdal().GDALCreate(gdal().GDALGetDriverByName("GTiff"), file.name(),
                                          picture.width, picture.height, 3, GDT_Byte,
                                          options.data()));
    if (dataset.get() != nullptr) {
        place_at(dataset.get(), place, picture.height);
        write_channels(dataset.get(), picture);
        dataset.close();
    }
    std::string bytes = file.bytes();
    refuse_fault("a picture", bytes, session);
    return bytes;
}

std::string esri_projection(const std::string& crs) {
    // WKT 1, as .prj files have it, stays as it is: its words do not end in CRS.
    if (crs.substr(0, crs.find('[')).find("CRS") == std::string::npos || !has_gdal()) return crs;
    const GdalSession session;
    const SpatialReference reference(crs);
    if (!reference.understood()) return crs;
    const std::string projection = reference.esri_wkt();
    return projection.empty() ? crs : projection;
}

}  // namespace fumon
