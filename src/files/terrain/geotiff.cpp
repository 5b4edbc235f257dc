#include "files/terrain/geotiff.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "base/limits.h"
#include "files/input_file.h"
#include "files/length_unit.h"
#include "files/open_files.h"
#include "files/terrain/gdal_dataset.h"
#include "files/terrain/gdal_functions.h"
#include "files/terrain/geographic.h"
#include "files/terrain/geotiff_signature.h"
#include "files/terrain/geotiff_writer.h"

namespace fumon {

namespace {

/// Where a raster lies as its file tells it, and what a length in it is.
struct RasterPlace {
    std::optional<GeoReference> grid;  ///< of the whole raster; none where the file does not say
    bool north_first = true;           ///< the first row is the northernmost
    bool west_first = true;            ///< the first column is the westernmost
    double metres = 1.0;               ///< per unit of a projected system
    std::string unit{};                ///< of a projected system
    bool says_unit = false;            ///< whether a system tells degrees from lengths
};

/// One GeoTIFF that is read.
class GeotiffReader {
  public:
    GeotiffReader(const std::filesystem::path& file, const TerrainQuery& query)
        : name_(file.string()),
          path_(std::filesystem::absolute(file).string()),
          query_(query),
          dataset_(open(path_)) {
        if (dataset_.get() == nullptr) refuse_damage();
        nx_ = gdal().GDALGetRasterXSize(dataset_.get());
        ny_ = gdal().GDALGetRasterYSize(dataset_.get());
    }

    Terrain read() {
        const GDALRasterBandH band = choose_band();
        const RasterPlace place = read_place();
        const CellBlock block = query_.window
                                    ? cells_in(*query_.window, place.grid, nx_, ny_, name_)
                                    : CellBlock{0, 0, nx_, ny_};
        check_size(block);
        if (place.grid) terrain_.place = place_of(block, *place.grid);
        read_heights(band, block, place);
        set_cell_sizes(place);
        return std::move(terrain_);
    }

  private:
    static GDALDatasetH open(const std::string& path) {
        std::array<const char*, 3> drivers{"GTiff", nullptr, nullptr};
        if (is_vrt(path, start_of_input_file(path, TerrainFormat::signature_length))) {
            refuse_network(path);
            drivers[1] = "VRT";
        }
        return gdal().GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data(),
                                 nullptr, nullptr);
    }

    /// A VRT reads files of this machine, as its user does.
    static void refuse_network(const std::string& path) {
        const std::string text = read_input_file(path);
        for (const char* far : {"/vsi", "://"}) {
            if (text.find(far) == std::string::npos) continue;
            throw InputError(fmt::format(
                "{}: names a file by \"{}…\"; a VRT that fumon reads names files by their paths",
                path, far));
        }
    }

    [[noreturn]] void refuse(std::string_view what, std::string_view remedy) const {
        throw InputError(fmt::format("{}: {}; {}", name_, what, remedy));
    }

    [[noreturn]] void refuse_damage() const {
        if (dataset_.get() == nullptr) refuse_shortage_of_open_files(path_);
        std::string fault = session_.fault();
        for (const std::string& part : {path_ + ": ", path_}) {  // which the line begins with
            for (std::size_t at = 0; (at = fault.find(part, at)) != std::string::npos;)
                fault.erase(at, part.size());
        }
        refuse("cannot be read as a GeoTIFF" + (fault.empty() ? "" : ": " + fault),
               "it may be cut short, damaged, or bear a wrong name: copy it again");
    }

    void check(CPLErr status) const {
        if (status != CE_None || !session_.fault().empty()) refuse_damage();
    }

    void note(const std::string& text) {
        if (!terrain_.note.empty()) terrain_.note += "; ";
        terrain_.note += text;
    }

    // ---- which band ----

    [[nodiscard]] GDALRasterBandH choose_band() {
        const int bands = gdal().GDALGetRasterCount(dataset_.get());
        if (bands == 0) refuse("holds no band of numbers", "choose a file with heights");
        if (query_.band > bands)
            refuse(fmt::format("has {} band{}, not {}", bands, bands == 1 ? "" : "s", query_.band),
                   fmt::format("write a bed.band from 1 to {}", bands));
        const int number = std::max(1, static_cast<int>(query_.band));
        GDALRasterBandH band = gdal().GDALGetRasterBand(dataset_.get(), number);
        const GDALColorInterp colour = gdal().GDALGetRasterColorInterpretation(band);
        if (query_.band == 0 && (colour == GCI_RedBand || colour == GCI_PaletteIndex))
            refuse("is a colour picture",
                   "choose a file with heights, or say with bed.band which band holds them");
        if (gdal().GDALDataTypeIsComplex(gdal().GDALGetRasterDataType(band)) != 0)
            refuse("holds complex numbers", "heights are real numbers");
        if (query_.band == 0 && bands > 1)
            note(fmt::format("band 1 of {} is read (bed.band chooses another)", bands));
        return band;
    }

    // ---- where it lies ----

    [[nodiscard]] RasterPlace read_place() const {
        RasterPlace place;
        std::array<double, 6> transform{};
        if (gdal().GDALGetGeoTransform(dataset_.get(), transform.data()) != CE_None) {
            if (gdal().GDALGetGCPCount(dataset_.get()) > 0)
                refuse("is placed by ground control points",
                       "make an even grid of it first (gdalwarp)");
            return place;
        }
        if (transform[2] != 0.0 || transform[4] != 0.0)
            refuse("has rotated or skewed cells", "turn it to north first (gdalwarp)");
        const double dx = transform[1];
        const double dy = -transform[5];
        if (!std::isfinite(dx * dy * transform[0] * transform[3]) || dx == 0.0 || dy == 0.0)
            refuse(fmt::format("has cells of {} x {}", dx, dy),
                   "write a cell size (gdal_edit.py -tr)");
        place.west_first = dx > 0.0;
        place.north_first = dy > 0.0;
        place.grid = {std::min(transform[0], transform[0] + dx * nx_),
                      std::min(transform[3], transform[3] - dy * ny_), std::abs(dx), std::abs(dy)};
        read_crs(place);
        return place;
    }

    void read_crs(RasterPlace& place) const {
        const OGRSpatialReferenceH crs = gdal().GDALGetSpatialRef(dataset_.get());
        if (crs == nullptr) return;
        constexpr std::array<const char*, 3> form{"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
        char* text = nullptr;
        if (gdal().OSRExportToWktEx(crs, &text, form.data()) == OGRERR_NONE) place.grid->crs = text;
        gdal().VSIFree(text);
        place.grid->degrees = gdal().OSRIsGeographic(crs) != 0;
        place.says_unit =
            place.grid->degrees || gdal().OSRIsProjected(crs) != 0 || gdal().OSRIsLocal(crs) != 0;
        if (place.grid->degrees) {
            constexpr double radians_per_degree = 0.017453292519943295;
            if (std::abs(gdal().OSRGetAngularUnits(crs, nullptr) / radians_per_degree - 1.0) > 1e-9)
                refuse("has angles that are no degrees", "make a grid in degrees of it (gdalwarp)");
        } else if (place.says_unit) {
            char* unit = nullptr;
            place.metres = gdal().OSRGetLinearUnits(crs, &unit);  // the reference keeps the name
            if (unit != nullptr) place.unit = unit;
        }
    }

    void check_size(const CellBlock& block) const {
        const long long cells = static_cast<long long>(block.nx) * block.ny;
        if (cells > largest_grid_cells)
            refuse(fmt::format("{} × {} = {} cells", block.nx, block.ny, cells),
                   fmt::format("at most {} are read; choose a part of it with bed.window",
                               largest_grid_cells));
    }

    void set_cell_sizes(const RasterPlace& place) {
        if (!terrain_.place) return;
        GeoReference& grid = *terrain_.place;
        const int ny = terrain_.heights.ny();
        if (!place.says_unit) {
            grid.degrees =
                is_geographic({grid.west, grid.south, grid.dx * terrain_.heights.nx(), grid.dy * ny,
                               grid.dx, grid.dy, relief(terrain_.heights, terrain_.nodata)});
        }
        terrain_.dx = grid.dx * place.metres;
        terrain_.dy = grid.dy * place.metres;
        if (place.metres != 1.0)
            note(fmt::format("cell size converted to metres from {}", place.unit));
        if (!grid.degrees) return;
        const double middle = grid.south + 0.5 * grid.dy * ny;
        if (std::abs(middle) >= 90.0)
            refuse(fmt::format("the middle latitude is {:.6g}°", middle),
                   "latitudes lie between -90 and 90");
        const MetricCells cells = cells_from_degrees(grid.dx, grid.dy, middle);
        terrain_.dx = cells.dx;
        terrain_.dy = cells.dy;
        note(cells.note);
    }

    // ---- its heights ----

    /// A block in the raster's own order of rows and columns, turned so that row 0 is the
    /// southernmost and column 0 the westernmost.
    template <class Number>
    Field<Number> read_block(GDALRasterBandH band, const CellBlock& block, const RasterPlace& place,
                             GDALDataType type) const {
        Field<Number> values(block.nx, block.ny);
        const int column = place.west_first ? block.x : nx_ - block.x - block.nx;
        const int row = place.north_first ? ny_ - block.y - block.ny : block.y;
        check(gdal().GDALRasterIO(band, GF_Read, column, row, block.nx, block.ny, values.data(),
                                  block.nx, block.ny, type, 0, 0));
        for (int y = 0; place.north_first && y < block.ny / 2; ++y)
            std::ranges::swap_ranges(values.row(y), values.row(block.ny - 1 - y));
        for (int y = 0; !place.west_first && y < block.ny; ++y) std::ranges::reverse(values.row(y));
        return values;
    }

    void read_heights(GDALRasterBandH band, const CellBlock& block, const RasterPlace& place) {
        const double metres = height_factor(band);
        terrain_.heights = read_block<double>(band, block, place, GDT_Float64);
        Mask shown;  // 0 where the file's own mask hides a cell
        const int flags = gdal().GDALGetMaskFlags(band);
        if ((flags & (GMF_ALL_VALID | GMF_NODATA)) == 0)
            shown = read_block<std::uint8_t>(gdal().GDALGetMaskBand(band), block, place, GDT_Byte);
        int has_nodata = 0;
        double nodata = gdal().GDALGetRasterNoDataValue(band, &has_nodata);
        if (gdal().GDALGetRasterDataType(band) == GDT_Float32)
            nodata = static_cast<double>(static_cast<float>(nodata));
        const double scale = gdal().GDALGetRasterScale(band, nullptr);
        const double offset = gdal().GDALGetRasterOffset(band, nullptr);
        check(CE_None);

        std::size_t holes = 0;
        Grid& heights = terrain_.heights;
        for (std::size_t cell = 0; cell < heights.size(); ++cell) {
            double& height = heights.values()[cell];
            const bool hidden = !shown.empty() && shown.values()[cell] == 0;
            if (hidden || std::isnan(height) || (has_nodata != 0 && height == nodata)) {
                if (terrain_.nodata.empty()) terrain_.nodata = Mask(heights.nx(), heights.ny());
                terrain_.nodata.values()[cell] = 1;
                height = 0.0;
                ++holes;
                continue;
            }
            height = (height * scale + offset) * metres;
            if (!std::isfinite(height)) refuse_infinite(cell);
        }
        if (holes == heights.size())
            refuse(query_.window ? "no cell in bed.window holds data" : "no cell holds data",
                   "at least one height must differ from the no-data value");
        if (metres != 1.0)
            note(fmt::format("heights converted to metres from {}",
                             gdal().GDALGetRasterUnitType(band)));
    }

    /// Metres per unit of the band.
    [[nodiscard]] double height_factor(GDALRasterBandH band) const {
        const std::string unit = gdal().GDALGetRasterUnitType(band);
        if (unit.empty() || query_.any_unit) return 1.0;
        if (const auto metres = metres_per_unit(unit)) return *metres;
        refuse(fmt::format("its heights are in \"{}\"", unit),
               "heights are in a unit of length (\"m\"); another band may hold them (bed.band)");
    }

    [[noreturn]] void refuse_infinite(std::size_t cell) const {
        const auto nx = static_cast<std::size_t>(terrain_.heights.nx());
        refuse(fmt::format("the height at row {}, column {} from the south-west is infinite",
                           cell / nx + 1, cell % nx + 1),
               "write a finite number or the no-data value");
    }

    std::string name_;  ///< as the user wrote it
    std::string path_;  ///< which GDAL takes for no other thing
    const TerrainQuery& query_;
    GdalSession session_;
    GdalDataset dataset_;
    int nx_ = 0;
    int ny_ = 0;
    Terrain terrain_;
};

Terrain read_geotiff(const std::filesystem::path& file, const TerrainQuery& query) {
    return GeotiffReader(file, query).read();
}

}  // namespace

TerrainFormat geotiff_format() {
    return {.name = "geotiff",
            .title = "a GeoTIFF",
            .is_one = is_geotiff,
            .read = read_geotiff,
            .write = write_geotiff,
            .endings = {".tif"},
            .has_bands = true};
}

TerrainFormat cloud_geotiff_format() {
    return {.name = cloud_geotiff_name,
            .title = "a Cloud Optimized GeoTIFF",
            .is_one = [](const std::filesystem::path&, std::string_view) { return false; },
            .read = read_geotiff,
            .write = write_cloud_geotiff,
            .endings = {".cog.tif"},
            .has_bands = true};
}

}  // namespace fumon
