#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>

#include "files/input_file.h"
#include "files/terrain/esri_ascii.h"
#include "files/terrain/geographic.h"
#include "files/terrain/geotiff.h"
#include "files/terrain/prj_file.h"

namespace fumon {

namespace {

/// The shortest digits that read back as the same number.
template <class Number>
void append(std::string& text, Number value) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end);
}

/// A coordinate, without an exponent, which some readers do not take there.
void append_coordinate(std::string& text, std::string_view word, double value) {
    std::array<char, 400> digits{};  // of the largest double
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                            std::chars_format::fixed);
    text += word;
    text += ' ';
    text.append(digits.data(), end);
    text += '\n';
}

template <class Number>
void append_line(std::string& text, std::string_view word, Number value) {
    text += word;
    text += ' ';
    append(text, value);
    text += '\n';
}

std::string in_xml(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '&')
            result += "&amp;";
        else if (letter == '<')
            result += "&lt;";
        else
            result += letter;
    }
    return result;
}

Terrain read_esri_ascii(const std::filesystem::path& file, const TerrainQuery& query) {
    const std::string bytes = read_input_file(file);
    Terrain terrain = parse_esri_ascii({file.string(), bytes}, query.window);
    terrain.place->crs = crs_beside(file, terrain);
    return terrain;
}

/// Whether a grid that is written where it lies is read back as what it is.
bool reads_back(const TerrainOutput& terrain) {
    const WorldScale& scale = terrain.scale;
    const GeoReference& place = *scale.place;
    // By its .prj; and what is no height is not read as one.
    if (!place.crs.empty() || !terrain.description.empty()) return true;
    if (!place.degrees) {
        constexpr double tolerance = 1e-6;
        return std::abs(place.dx / scale.dx - 1.0) < tolerance &&
               std::abs(place.dy / scale.dy - 1.0) < tolerance;
    }
    return is_geographic({place.west, place.south, place.dx * terrain.heights.nx(),
                          place.dy * terrain.heights.ny(), place.dx, place.dy,
                          relief(terrain.heights, terrain.nodata)});
}

/// What GDAL reads beside a grid of another quantity than heights: its description and unit.
std::string auxiliary_xml(const TerrainOutput& terrain) {
    return fmt::format(
        "<PAMDataset>\n  <PAMRasterBand band=\"1\">\n    <Description>{}</Description>\n"
        "    <UnitType>{}</UnitType>\n  </PAMRasterBand>\n</PAMDataset>\n",
        in_xml(terrain.description), in_xml(terrain.unit));
}

/// The grid, and the file with its reference system.
std::vector<TerrainBytes> grid_files(const TerrainOutput& terrain) {
    const Grid& heights = terrain.heights;
    const Mask& nodata = terrain.nodata;
    const WorldScale& scale = terrain.scale;
    if (!scale.in_metres || !scale.place || !reads_back(terrain))
        return {{".asc", esri_ascii(heights, nodata, scale.dx, scale.dy)}};
    const GeoReference& place = *scale.place;
    std::vector<TerrainBytes> files{
        {".asc", esri_ascii(heights, nodata, place.dx, place.dy, place.west, place.south)}};
    const std::string crs =
        place.degrees && place.crs.empty() ? degrees_of_unknown_datum : place.crs;
    if (!crs.empty()) files.push_back({".prj", esri_projection(crs) + "\n"});
    return files;
}

std::vector<TerrainBytes> write_esri_ascii(const TerrainOutput& terrain) {
    std::vector<TerrainBytes> files = grid_files(terrain);
    if (!terrain.description.empty()) files.push_back({".asc.aux.xml", auxiliary_xml(terrain)});
    return files;
}

}  // namespace

double unused_height(const Grid& heights) {
    double value = -9999.0;
    const auto cells = heights.values();
    while (std::find(cells.begin(), cells.end(), value) != cells.end()) value = value * 10.0 - 9.0;
    return value;
}

TerrainFormat esri_ascii_format() {
    return {.name = "esri-ascii",
            .title = "an ESRI ASCII grid",
            .is_one = [](const std::filesystem::path&, std::string_view) { return true; },
            .read = read_esri_ascii,
            .write = write_esri_ascii,
            .endings = {".asc", ".prj"}};
}

std::string esri_ascii(const Grid& heights, const Mask& nodata, double dx, double dy, double west,
                       double south) {
    constexpr std::size_t usual_cell = 20;  // characters: 17 digits, sign, point, space
    const double nodata_value = unused_height(heights);
    std::string text;
    text.reserve(usual_cell * heights.size() + 200);
    append_line(text, "ncols", heights.nx());
    append_line(text, "nrows", heights.ny());
    append_coordinate(text, "xllcorner", west);
    append_coordinate(text, "yllcorner", south);
    if (dx == dy) {
        append_line(text, "cellsize", dx);
    } else {
        append_line(text, "dx", dx);
        append_line(text, "dy", dy);
    }
    append_line(text, "NODATA_value", nodata_value);
    for (int y = heights.ny() - 1; y >= 0; --y) {
        for (int x = 0; x < heights.nx(); ++x) {
            if (x > 0) text += ' ';
            append(text, !nodata.empty() && nodata(x, y) != 0 ? nodata_value : heights(x, y));
        }
        text += '\n';
    }
    return text;
}

}  // namespace fumon
