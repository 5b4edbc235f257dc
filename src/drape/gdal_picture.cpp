#include "drape/gdal_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/image.h"
#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/raster_kinds.h"
#include "files/input_file.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// GDAL's drivers of pictures in files; of unknown origin those whose formats name no other file.
std::span<const char* const> picture_drivers(bool trusted) {
    static constexpr std::array<const char*, 6> alone{"GTiff", "JP2OpenJPEG", "BMP",
                                                      "GIF",   "WEBP",        nullptr};
    static constexpr std::array<const char*, 14> all{
        "GTiff", "VRT", "GPKG", "HFA",     "JP2OpenJPEG", "ENVI", "EHdr",
        "BMP",   "GIF", "WEBP", "MBTiles", "ERS",         "RST",  nullptr};
    if (trusted) return all;
    return alone;
}

/// Which bands of a picture hold what; 0: none.
struct Bands {
    std::array<int, 3> colours{1, 1, 1};
    int opacity = 0;
    bool palette = false;
    bool wide = false;  ///< 16 bits
};

/// One that is open; see GdalSession.
class OpenPicture {
  public:
    OpenPicture(const fs::path& file, bool trusted)
        : name_(file.string()),
          session_(trusted ? GdalSession::Siblings::by_name : GdalSession::Siblings::none),
          dataset_(gdal().GDALOpenEx(fs::absolute(file).c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                     picture_drivers(trusted).data(), nullptr, nullptr)) {
        if (dataset_.get() == nullptr || !session_.fault().empty()) refuse_damage();
        find_bands();
    }

    [[nodiscard]] int width() const { return gdal().GDALGetRasterXSize(dataset_.get()); }
    [[nodiscard]] int height() const { return gdal().GDALGetRasterYSize(dataset_.get()); }

    [[nodiscard]] std::optional<PicturePlace> place() const {
        PicturePlace place;
        std::array<double, 6>& t = place.transform;
        if (gdal().GDALGetGeoTransform(dataset_.get(), t.data()) != CE_None) {
            if (gdal().GDALGetGCPCount(dataset_.get()) > 0 ||
                gdal().GDALGetMetadata(dataset_.get(), "RPC") != nullptr)
                refuse("is placed by ground control points or rational polynomials",
                       "warp it to a regular grid first (gdalwarp)");
            return std::nullopt;
        }
        const double area = t[1] * t[5] - t[2] * t[4];
        if (!std::isfinite(area * t[0] * t[3]) || area == 0.0)
            refuse("has pixels of no size", "write a pixel size (gdal_edit.py -tr)");
        const OGRSpatialReferenceH reference = gdal().GDALGetSpatialRef(dataset_.get());
        if (reference == nullptr) return place;
        constexpr std::array<const char*, 3> form{"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
        char* text = nullptr;
        if (gdal().OSRExportToWktEx(reference, &text, form.data()) == OGRERR_NONE &&
            text != nullptr)
            place.crs = text;
        gdal().VSIFree(text);
        return place;
    }

    [[nodiscard]] PixelBlock reduced(const PixelWindow& window, int reduction) {
        PixelSums sums(window.width, reduction);
        PixelBlock block{sums.width(), 0, {}};
        std::vector<std::uint8_t> row(4 * static_cast<std::size_t>(window.width));
        for (int y = 0; y < window.height; ++y) {
            read_row(window, window.top + y, row);
            sums.add_row(row.data());
            if ((y + 1) % reduction != 0 && y + 1 != window.height) continue;
            sums.finish(block.rgba);
            ++block.height;
        }
        return block;
    }

  private:
    [[noreturn]] void refuse(std::string_view what, std::string_view remedy) const {
        throw InputError(fmt::format("{}: {}; {}", name_, what, remedy));
    }

    [[noreturn]] void refuse_damage() const {
        const std::string& fault = session_.fault();
        refuse(fmt::format("cannot be read as a picture{}{}", fault.empty() ? "" : ": ", fault),
               "name a PNG, JPEG, WebP or GeoTIFF, or a picture in another format of GDAL's");
    }

    [[nodiscard]] GDALRasterBandH band(int number) const {
        return gdal().GDALGetRasterBand(dataset_.get(), number);
    }

    void find_bands() {
        const int count = gdal().GDALGetRasterCount(dataset_.get());
        if (count == 0) refuse("holds no band of colours", "name a picture");
        const GDALColorInterp last = gdal().GDALGetRasterColorInterpretation(band(count));
        if (last == GCI_AlphaBand && count > 1) bands_.opacity = count;
        const int colours = bands_.opacity != 0 ? count - 1 : count;
        if (colours >= 3) bands_.colours = {1, 2, 3};
        bands_.palette =
            colours < 3 && gdal().GDALGetRasterColorInterpretation(band(1)) == GCI_PaletteIndex;
        const GDALDataType type = gdal().GDALGetRasterDataType(band(1));
        bands_.wide = type == GDT_UInt16;
        if (type != GDT_Byte && type != GDT_UInt16) {
            refuse("holds numbers and no colours of 8 or 16 bits",
                   "name a picture, or colour it first (gdaldem color-relief)");
        }
        if (bands_.palette) read_palette();
    }

    void read_palette() {
        const GDALColorTableH table = gdal().GDALGetRasterColorTable(band(1));
        const int count = table == nullptr ? 0 : gdal().GDALGetColorEntryCount(table);
        for (int i = 0; i < std::min(count, 256); ++i) {
            GDALColorEntry entry{};
            if (gdal().GDALGetColorEntryAsRGB(table, i, &entry) == 0) continue;
            const auto byte = [](short value) {
                return static_cast<std::uint8_t>(std::clamp<int>(value, 0, 255));
            };
            palette_[static_cast<std::size_t>(i)] = {byte(entry.c1), byte(entry.c2), byte(entry.c3),
                                                     byte(entry.c4)};
        }
    }

    /// A row of one band, 8 bits each; a wide one to the nearest.
    void read_band(GDALRasterBandH from, bool wide, const PixelWindow& window, int y,
                   std::vector<std::uint8_t>& values) {
        values.resize(static_cast<std::size_t>(window.width));
        CPLErr status = CE_None;
        if (!wide) {
            status = gdal().GDALRasterIO(from, GF_Read, window.left, y, window.width, 1,
                                         values.data(), window.width, 1, GDT_Byte, 0, 0);
        } else {
            std::vector<std::uint16_t> levels(values.size());
            status = gdal().GDALRasterIO(from, GF_Read, window.left, y, window.width, 1,
                                         levels.data(), window.width, 1, GDT_UInt16, 0, 0);
            std::ranges::transform(levels, values.begin(), rounded_to_8);
        }
        if (status != CE_None || !session_.fault().empty()) refuse_damage();
    }

    void read_row(const PixelWindow& window, int y, std::vector<std::uint8_t>& rgba) {
        std::vector<std::uint8_t> values;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            if (channel == 0 || bands_.colours[channel] != bands_.colours[0])
                read_band(band(bands_.colours[channel]), bands_.wide, window, y, values);
            for (std::size_t x = 0; x < values.size(); ++x) rgba[4 * x + channel] = values[x];
        }
        for (std::size_t x = 0; x < values.size(); ++x) rgba[4 * x + 3] = 255;
        if (bands_.palette) {
            for (std::size_t x = 0; x < values.size(); ++x)
                std::ranges::copy(palette_[values[x]], rgba.begin() + static_cast<long>(4 * x));
        }
        hide_what_is_masked(window, y, rgba);
    }

    /// A pixel whose colours all have the no-data value, or that a mask hides, is seen through.
    void hide_what_is_masked(const PixelWindow& window, int y, std::vector<std::uint8_t>& rgba) {
        std::vector<std::uint8_t> values;
        if (bands_.opacity != 0) {
            read_band(band(bands_.opacity), bands_.wide, window, y, values);
            for (std::size_t x = 0; x < values.size(); ++x) rgba[4 * x + 3] = values[x];
            return;
        }
        std::vector<std::uint8_t> shown;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const GDALRasterBandH from = band(bands_.colours[channel]);
            const int flags = gdal().GDALGetMaskFlags(from);
            if ((flags & GMF_ALL_VALID) != 0) return;
            if (channel > 0 && ((flags & GMF_NODATA) == 0 || bands_.colours[2] == 1)) break;
            read_band(gdal().GDALGetMaskBand(from), false, window, y, values);
            if (shown.empty()) shown.resize(values.size());
            for (std::size_t x = 0; x < values.size(); ++x)
                shown[x] = std::max(shown[x], values[x]);
        }
        for (std::size_t x = 0; x < shown.size(); ++x)
            rgba[4 * x + 3] = std::min(rgba[4 * x + 3], shown[x]);
    }

    std::string name_;
    GdalSession session_;
    GdalDataset dataset_;
    Bands bands_;
    std::array<std::array<std::uint8_t, 4>, 256> palette_{};
};

/// Opened anew each time, since nothing else may use GDAL meanwhile.
class GdalPicture : public PictureSource {
  public:
    GdalPicture(fs::path file, bool trusted) : file_(std::move(file)), trusted_(trusted) {
        const OpenPicture picture(file_, trusted_);
        width_ = picture.width();
        height_ = picture.height();
        place_ = picture.place();
    }

    [[nodiscard]] PixelBlock reduced(const PixelWindow& window, int reduction) const override {
        return OpenPicture(file_, trusted_).reduced(window, reduction);
    }

  private:
    fs::path file_;
    bool trusted_;
};

/// A VRT reads files of this machine, as its user does, and no others.
void refuse_network_picture(const fs::path& file) {
    if (!is_vrt(file, start_of_input_file(file, 8))) return;
    const std::string text = read_input_file(file);
    for (const char* far : {"/vsi", "://"}) {
        if (text.find(far) == std::string::npos) continue;
        throw InputError(fmt::format(
            "{}: refers to a file by \"{}…\"; fumon reads a VRT only if it refers to files by path",
            file.string(), far));
    }
}

}  // namespace

std::unique_ptr<PictureSource> open_gdal_picture(const fs::path& file, bool trusted) {
    if (const std::string missing = missing_gdal(); !missing.empty()) {
        throw InputError(
            fmt::format("{}: a picture other than PNG, JPEG and WebP {}", file.string(), missing));
    }
    if (trusted) refuse_network_picture(file);
    return std::make_unique<GdalPicture>(file, trusted);
}

}  // namespace fumon
