#include "files/terrain/prj_file.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "files/gdal/gdal_functions.h"
#include "files/gdal/gdal_session.h"
#include "files/gdal/spatial_reference.h"
#include "files/input_file.h"
#include "files/wkt.h"

namespace fumon {

namespace {

/// A text without line breaks and the indentation behind them.
std::string on_one_line(std::string_view text) {
    std::string line;
    bool begins = true;
    for (const char letter : text) {
        const bool printed = static_cast<unsigned char>(letter) >= 0x20;
        begins = !printed || (begins && letter == ' ');
        if (!begins) line += letter;
    }
    return line;
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char letter : text) {
        if (static_cast<unsigned char>(letter) >= 0x20 || letter == '\t') {
            lines.back() += letter;
        } else if (!lines.back().empty()) {
            lines.emplace_back();
        }
    }
    return lines;
}

}  // namespace

std::string crs_beside(const std::filesystem::path& grid, Terrain& terrain) {
    constexpr std::size_t longest = 65536;  // bytes; a system takes a few thousand at most
    const auto prj = std::filesystem::path(grid).replace_extension(".prj");
    std::error_code fault;
    if (!std::filesystem::is_regular_file(prj, fault)) return {};
    const std::string text = start_of_input_file(prj, longest);
    std::string line = on_one_line(text);
    if (line.empty()) return {};
    if (parse_wkt(line)) return line;
    if (has_gdal()) {
        const GdalSession session;
        const SpatialReference crs(lines_of(text));
        if (crs.understood()) return crs.wkt();
    }
    add_note(terrain,
             fmt::format("{} holds no reference system that can be read, and is passed over",
                         prj.string()));
    return {};
}

}  // namespace fumon
