#include "files/gdal/raster_kinds.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/input_file.h"

namespace fumon {

namespace {

using namespace std::string_view_literals;

std::string lower_case(std::string text) {
    for (char& letter : text)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

/// Whether the first word is one of an ESRI ASCII grid's header.
bool starts_esri_ascii(std::string_view start) {
    if (start.starts_with("\xEF\xBB\xBF")) start.remove_prefix(3);
    while (!start.empty() && std::isspace(static_cast<unsigned char>(start.front())) != 0)
        start.remove_prefix(1);
    constexpr std::size_t longest_word = 6;
    const std::string word = lower_case(std::string(start.substr(0, longest_word)));
    constexpr std::array words{"ncols"sv, "nrows"sv, "xllc"sv,  "yllc"sv,
                               "cells"sv, "dx"sv,    "nodata"sv};
    return std::ranges::any_of(words, [&](std::string_view known) {
        return word.starts_with(known.substr(0, word.size()));
    });
}

}  // namespace

bool is_vrt(const std::filesystem::path& file, std::string_view start) {
    return start.starts_with("<VRTData") || file.extension() == ".vrt";
}

bool is_geotiff(const std::filesystem::path& file, std::string_view start) {
    for (const std::string_view signature : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (start.starts_with(signature)) return true;
    }
    const auto ending = file.extension();
    return ending == ".tif" || ending == ".tiff" || is_vrt(file, start);
}

bool is_other_raster(const std::filesystem::path& file, std::string_view start) {
    for (const std::string_view signature :
         {"EHFA_HEA"sv, "DSAA"sv, "DSBB"sv, "DSRB"sv, "SQLite f"sv, "\0\0\0\x0CjP  "sv,
          "\xFF\x4F\xFF\x51"sv, "UHL1"sv, "RUU CROS"sv}) {
        if (start.starts_with(signature)) return true;
    }
    constexpr std::array endings{".img"sv,  ".gpkg"sv, ".jp2"sv,  ".j2k"sv, ".hgt"sv,
                                 ".dt0"sv,  ".dt1"sv,  ".dt2"sv,  ".xyz"sv, ".bil"sv,
                                 ".bip"sv,  ".bsq"sv,  ".flt"sv,  ".ers"sv, ".rst"sv,
                                 ".sdat"sv, ".sgrd"sv, ".zarr"sv, ".ddf"sv};
    std::string ending = lower_case(file.extension().string());
    if (std::ranges::find(endings, ending) != endings.end()) return true;
    if (start.empty() || !has_gdal()) return false;
    constexpr std::size_t looked_at = 4096;  // bytes; a text may begin with blanks
    if (starts_esri_ascii(start_of_input_file(file, looked_at))) return false;
    const GdalSession session(GdalSession::Siblings::by_name);
    return gdal().GDALIdentifyDriverEx(std::filesystem::absolute(file).c_str(), GDAL_OF_RASTER,
                                       raster_drivers(true).data(), nullptr) != nullptr;
}

std::span<const char* const> raster_drivers(bool trusted) {
    static constexpr std::array<const char*, 10> alone{"GTiff",   "JP2OpenJPEG", "SRTMHGT", "DTED",
                                                       "USGSDEM", "GSAG",        "GSBG",    "GS7BG",
                                                       "XYZ",     nullptr};
    static constexpr std::array<const char*, 38> all{
        "GTiff",   "VRT",    "HFA",  "GPKG",  "JP2OpenJPEG",    "SRTMHGT",  "DTED",
        "USGSDEM", "GSAG",   "GSBG", "GS7BG", "ENVI",           "EHdr",     "Zarr",
        "SAGA",    "RST",    "ERS",  "BT",    "GRASSASCIIGrid", "PCRaster", "SDTS",
        "ISIS3",   "PDS",    "PDS4", "VICAR", "Terragen",       "GXF",      "ZMap",
        "RRASTER", "SIGDEM", "HF2",  "GTX",   "ILWIS",          "Leveller", "ROI_PAC",
        "ACE2",    "XYZ",    nullptr};
    if (trusted) return all;
    return alone;
}

}  // namespace fumon
