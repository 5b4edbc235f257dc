#include "files/terrain/raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/limits.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/raster_choice.h"
#include "files/gdal/raster_georeference.h"
#include "files/gdal/raster_kinds.h"
#include "files/input_file.h"
#include "files/open_files.h"
#include "files/terrain/geographic.h"
#include "files/terrain/text_grid.h"
#include "files/terrain/wanted_unit.h"

namespace fumon {

namespace {

/// A VRT reads files of this machine, as its user does, and no others.
void refuse_network(const std::string& path) {
    const std::string text = read_input_file(path);
    for (const char* far : {"/vsi", "://"}) {
        if (text.find(far) == std::string::npos) continue;
        throw InputError(fmt::format(
            "{}: refers to a file by \"{}…\"; fumon reads a VRT only if it refers to files by path",
            path, far));
    }
}

/// One raster that is read.
class RasterReader {
  public:
    RasterReader(const std::filesystem::path& file, const TerrainQuery& query)
        : name_(file.string()),
          path_(std::filesystem::absolute(file).string()),
          query_(query),
          session_(query.trusted ? GdalSession::Siblings::by_name : GdalSession::Siblings::none),
          dataset_(open(path_)) {
        if (dataset_.get() == nullptr) refuse_damage();
        choose_grid();
        nx_ = gdal().GDALGetRasterXSize(dataset_.get());
        ny_ = gdal().GDALGetRasterYSize(dataset_.get());
    }

    Terrain read() {
        const GDALRasterBandH band = choose_band();
        const RasterGeoReference place = raster_georeference(
            dataset_.get(), nx_, ny_,
            [this](std::string_view what, std::string_view remedy) { refuse(what, remedy); });
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
    [[nodiscard]] GDALDatasetH open(const std::string& path) const {
        const bool folder = std::filesystem::is_directory(path_);
        const std::string start =
            folder ? "" : start_of_input_file(path_, TerrainFormat::signature_length);
        if (is_vrt(path_, start) && query_.trusted) refuse_network(path_);
        return gdal().GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                 raster_drivers(query_.trusted).data(), nullptr, nullptr);
    }

    /// Opens the grid that is asked for of those in a container.
    void choose_grid() {
        const std::vector<ContainedGrid> grids = contained_grids(dataset_.get());
        if (grids.empty()) {
            if (!query_.variable.empty())
                refuse("holds one grid, which has no name", "leave bed.variable out");
            return;
        }
        std::string names;
        for (const ContainedGrid& grid : grids) {
            names += (names.empty() ? "" : ", ") + grid.name;
            if (grid.name != query_.variable) continue;
            dataset_ = GdalDataset(open(grid.path));
            if (dataset_.get() == nullptr) refuse_damage();
            return;
        }
        if (!query_.variable.empty())
            refuse(fmt::format("holds no grid \"{}\"", query_.variable),
                   fmt::format("write bed.variable as one of {}", names));
        if (grids.size() > 1)
            refuse(fmt::format("holds {} grids: {}", grids.size(), names),
                   "choose one by bed.variable");
        if (gdal().GDALGetRasterCount(dataset_.get()) == 0) {
            dataset_ = GdalDataset(open(grids.front().path));
            if (dataset_.get() == nullptr) refuse_damage();
        }
    }

    [[noreturn]] void refuse(std::string_view what, std::string_view remedy) const {
        throw InputError(fmt::format("{}: {}; {}", name_, what, remedy));
    }

    [[noreturn]] void refuse_damage() const {
        if (dataset_.get() == nullptr) refuse_shortage_of_open_files(path_);
        constexpr std::size_t looked_at = 4096;  // bytes
        if (!std::filesystem::is_directory(path_)) {
            const auto text = other_text_grid(start_of_input_file(path_, looked_at));
            if (text && text->is_list)
                refuse("is a list of points (XYZ) that do not form a regular grid",
                       "give one point for each cell, or interpolate scattered points (gdal_grid)");
        }
        std::string fault = session_.fault();
        for (const std::string& part : {path_ + ": ", path_}) {  // which the line begins with
            for (std::size_t at = 0; (at = fault.find(part, at)) != std::string::npos;)
                fault.erase(at, part.size());
        }
        refuse(fmt::format("cannot be read as {}{}{}",
                           is_geotiff(path_, "") ? "a GeoTIFF" : "a raster",
                           fault.empty() ? "" : ": ", fault),
               "it may be cut short, damaged or wrongly named: copy it again");
    }

    void check(CPLErr status) const {
        if (status != CE_None || !session_.fault().empty()) refuse_damage();
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
                   "choose a file with heights, or name their band with bed.band");
        if (gdal().GDALDataTypeIsComplex(gdal().GDALGetRasterDataType(band)) != 0)
            refuse("holds complex numbers", "heights are real numbers");
        if (query_.band == 0 && bands > 1)
            add_note(terrain_,
                     fmt::format("band 1 of {} is read (bed.band chooses another)", bands));
        return band;
    }

    void check_size(const CellBlock& block) const {
        const long long cells = static_cast<long long>(block.nx) * block.ny;
        if (cells > largest_grid_cells)
            refuse(fmt::format("{} × {} = {} cells", block.nx, block.ny, cells),
                   fmt::format("at most {} are read; choose a part of the file with bed.window",
                               largest_grid_cells));
    }

    /// In the file's unit of length, or degrees in metres.
    void set_cell_sizes(const RasterGeoReference& place) {
        if (!terrain_.place) return;
        GeoReference& grid = *terrain_.place;
        if (!place.units_known) {
            grid.degrees = is_geographic({grid.west, grid.south, grid.dx * terrain_.heights.nx(),
                                          grid.dy * terrain_.heights.ny(), grid.dx, grid.dy,
                                          relief(terrain_.heights, terrain_.nodata)});
        }
        terrain_.dx = grid.dx;
        terrain_.dy = grid.dy;
    }

    // ---- its heights ----

    /// A block in the raster's own order of rows and columns, turned so that row 0 is the
    /// southernmost and column 0 the westernmost.
    template <class Number>
    Field<Number> read_block(GDALRasterBandH band, const CellBlock& block,
                             const RasterGeoReference& place, GDALDataType type) const {
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

    /// Older files say beside their bytes that these have a sign.
    [[nodiscard]] bool has_signed_bytes(GDALRasterBandH band) const {
        const char* kind = gdal().GDALGetMetadataItem(band, "PIXELTYPE", "IMAGE_STRUCTURE");
        return gdal().GDALGetRasterDataType(band) == GDT_Byte && kind != nullptr &&
               std::string_view(kind) == "SIGNEDBYTE";
    }

    /// The value that stands for no data; none where the file has none.
    [[nodiscard]] std::optional<double> nodata_value(GDALRasterBandH band) const {
        int has = 0;
        double value = 0.0;
        switch (gdal().GDALGetRasterDataType(band)) {
            case GDT_Int64:
                value = static_cast<double>(gdal().GDALGetRasterNoDataValueAsInt64(band, &has));
                break;
            case GDT_UInt64:
                value = static_cast<double>(gdal().GDALGetRasterNoDataValueAsUInt64(band, &has));
                break;
            case GDT_Float32:
                value = gdal().GDALGetRasterNoDataValue(band, &has);
                if (std::isfinite(static_cast<float>(value)))
                    value = static_cast<double>(static_cast<float>(value));
                break;
            default:
                value = gdal().GDALGetRasterNoDataValue(band, &has);
        }
        return has != 0 ? std::optional(value) : std::nullopt;
    }

    void read_heights(GDALRasterBandH band, const CellBlock& block,
                      const RasterGeoReference& place) {
        const UnitConversion conversion = conversion_of(band, place);
        terrain_.heights = read_block<double>(band, block, place, GDT_Float64);
        Mask shown;  // 0 where the file's own mask hides a cell
        const int flags = gdal().GDALGetMaskFlags(band);
        if ((flags & (GMF_ALL_VALID | GMF_NODATA)) == 0)
            shown = read_block<std::uint8_t>(gdal().GDALGetMaskBand(band), block, place, GDT_Byte);
        const std::optional<double> nodata = nodata_value(band);
        const double scale = gdal().GDALGetRasterScale(band, nullptr);
        const double offset = gdal().GDALGetRasterOffset(band, nullptr);
        const bool signed_bytes = has_signed_bytes(band);
        check(CE_None);

        std::size_t holes = 0;
        Grid& heights = terrain_.heights;
        for (std::size_t cell = 0; cell < heights.size(); ++cell) {
            double& height = heights.values()[cell];
            if (signed_bytes && height > 127.0) height -= 256.0;
            const bool hidden = !shown.empty() && shown.values()[cell] == 0;
            if (hidden || std::isnan(height) || height == nodata) {
                if (terrain_.nodata.empty()) terrain_.nodata = Mask(heights.nx(), heights.ny());
                terrain_.nodata.values()[cell] = 1;
                height = 0.0;
                ++holes;
                continue;
            }
            height = conversion(height * scale + offset);
            if (!std::isfinite(height)) refuse_infinite(cell);
        }
        if (holes == heights.size())
            refuse(query_.window ? "no cell in bed.window holds data" : "no cell holds data",
                   "at least one height must differ from the no-data value");
    }

    /// From the band's numbers to metres of height, or to the unit that a query wants.
    UnitConversion conversion_of(GDALRasterBandH band, const RasterGeoReference& place) {
        constexpr std::array<std::string_view, 3> none{"", "unspecified", "unknown"};
        std::string unit = gdal().GDALGetRasterUnitType(band);
        if (std::ranges::find(none, unit) != none.end())
            unit = query_.any_unit ? "" : place.height_unit;
        std::optional<UnitConversion> conversion = conversion_for(query_, unit);
        if (!conversion && !query_.any_unit && unit == place.height_unit)
            conversion = UnitConversion{place.metres_per_height, 0.0};
        if (!conversion)
            refuse(
                fmt::format("its {} are in \"{}\"", query_.any_unit ? "numbers" : "heights", unit),
                wanted_units(query_, "another band may hold them (bed.band)"));
        add_note(terrain_, conversion_note(query_, unit, *conversion));
        if (query_.any_unit) return *conversion;
        if (place.heights_point_down && query_.height_sign == HeightSign::automatic) {
            add_note(terrain_,
                     "depths are read as negative heights, since the file's vertical axis points "
                     "down");
            conversion->factor = -conversion->factor;
            conversion->offset = -conversion->offset;
        }
        terrain_.metres_per_number = conversion->factor;
        return *conversion;
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

}  // namespace

Terrain read_raster(const std::filesystem::path& file, const TerrainQuery& query) {
    if (const std::string missing = missing_gdal(); !missing.empty())
        throw InputError(fmt::format("{}: {}", file.string(), missing));
    return RasterReader(file, query).read();
}

TerrainFormat other_raster_format() {
    return {.name = "raster",
            .title = "another raster that GDAL reads",
            .is_one = is_other_raster,
            .read = read_raster,
            .has_units = true,
            .has_variables = true,
            .has_bands = true};
}

}  // namespace fumon
