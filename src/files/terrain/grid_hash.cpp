#include "files/terrain/grid_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

#include "files/gdal/gdal_notes.h"
#include "files/gdal/raster_kinds.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "files/terrain/terrain_format.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::size_t longest_text = std::size_t{1} << 22;  // bytes of a VRT or of GDAL's notes
constexpr int deepest = 4;                                  // VRTs within VRTs

std::string in_case(std::string text, int (*letter_case)(int)) {
    for (char& letter : text)
        letter = static_cast<char>(letter_case(static_cast<unsigned char>(letter)));
    return text;
}

bool is_file(const fs::path& file) {
    std::error_code fault;
    return fs::is_regular_file(file, fault);
}

/// Endings in the place of a grid's own: those of what belongs to every raster, and of its kind.
std::vector<std::string> endings_beside(const std::string& ending) {
    std::vector<std::string> endings{".wld"};
    if (ending != ".tif" && ending != ".tiff")
        endings.insert(endings.end(), {".prj", ".hdr", ".aux"});
    if (ending.size() > 2) {  // .tfw and .tifw of .tif
        endings.push_back({'.', ending[1], ending.back(), 'w'});
        endings.push_back(ending + 'w');
    }
    if (ending == ".shp") endings.insert(endings.end(), {".shx", ".dbf", ".cpg"});
    if (ending == ".img") endings.emplace_back(".ige");
    if (ending == ".sdat") endings.emplace_back(".sgrd");
    if (ending == ".sgrd") endings.emplace_back(".sdat");
    if (ending == ".rst") endings.emplace_back(".rdc");
    if (ending == ".grd") endings.emplace_back(".gri");
    if (ending == ".ers") endings.emplace_back("");
    if (ending == ".xml" || ending == ".lbl")
        endings.insert(endings.end(), {".img", ".cub", ".dat"});
    return endings;
}

/// What a VRT's text has between <TAG …> and </TAG>.
std::vector<std::string> named_in(std::string_view text, std::string_view tag) {
    std::vector<std::string> names;
    const std::string open = fmt::format("<{}", tag);
    for (std::size_t at = text.find(open); at != text.npos; at = text.find(open, at + 1)) {
        const std::size_t begin = text.find('>', at);
        const std::size_t end = begin == text.npos ? begin : text.find('<', begin);
        if (end == text.npos) break;
        std::string name(text.substr(begin + 1, end - begin - 1));
        for (const auto& [entity, letter] : {std::pair{"&lt;"sv, "<"sv},
                                             {"&gt;"sv, ">"sv},
                                             {"&quot;"sv, "\""sv},
                                             {"&amp;"sv, "&"sv}}) {
            for (std::size_t place = 0; (place = name.find(entity, place)) != name.npos; ++place)
                name.replace(place, entity.size(), letter);
        }
        names.push_back(name);
    }
    return names;
}

void add_parts(const fs::path& grid, const std::string& before, int depth,
               std::vector<GridPart>& parts);

void add_named(const fs::path& vrt, const std::string& before, int depth,
               std::vector<GridPart>& parts) {
    const std::string text = start_of_input_file(vrt, longest_text);
    std::vector<std::string> names;
    for (const char* tag : {"SourceFilename", "SourceDataset"}) {
        for (const std::string& name : named_in(text, tag)) names.push_back(name);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& name : names) {
        const fs::path beside = vrt.parent_path() / name;
        const fs::path file = is_file(beside) || is_zarr(beside) ? beside : fs::path(name);
        if (!is_file(file) && !is_zarr(file)) continue;
        const std::string role = fmt::format("{}\t{}", before, name);
        parts.push_back({file, role});
        add_parts(file, role, depth + 1, parts);
    }
}

/// Adds what counts with a grid; `before`: what its parts' roles begin with.
void add_parts(const fs::path& grid, const std::string& before, int depth,
               std::vector<GridPart>& parts) {
    const std::string ending = in_case(grid.extension().string(), std::tolower);
    constexpr std::array alone{".nc"sv, ".nc4"sv, ".cdf"sv, ".zarr"sv};
    if (std::ranges::find(alone, ending) != alone.end() || !is_file(grid)) return;
    const auto add = [&](const fs::path& file, const std::string& role) {
        if (file == grid || !is_file(file)) return;
        parts.push_back({file, before + role});
    };
    for (const char* more : {".msk", ".aux.xml", ".hdr"}) {
        const fs::path file = grid.string() + more;
        if (more == ".aux.xml"sv && is_file(file) &&
            without_statistics(start_of_input_file(file, longest_text)).empty())
            continue;
        add(file, ending + more);
    }
    for (const std::string& beside : endings_beside(ending)) {
        fs::path file = grid;
        file.replace_extension(beside);
        if (!is_file(file)) file.replace_extension(in_case(beside, std::toupper));
        if (beside == ".aux" && !is_erdas_aux(file)) continue;
        add(file, beside);
    }
    if (depth < deepest && is_vrt(grid, start_of_input_file(grid, TerrainFormat::signature_length)))
        add_named(grid, before, depth, parts);
}

Sha256 part_hash(const GridPart& part) {
    if (!part.role.ends_with(".aux.xml")) return file_hash(part.file);
    return text_hash(without_statistics(start_of_input_file(part.file, longest_text)));
}

}  // namespace

std::vector<GridPart> grid_parts(const fs::path& grid) {
    std::vector<GridPart> parts;
    add_parts(grid, "", 0, parts);
    std::ranges::sort(parts, {}, &GridPart::role);
    const auto same_role = [](const GridPart& one, const GridPart& other) {
        return one.role == other.role;
    };
    parts.erase(std::unique(parts.begin(), parts.end(), same_role), parts.end());
    return parts;
}

Sha256 grid_hash(const fs::path& grid) {
    const std::vector<GridPart> parts = grid_parts(grid);
    const Sha256 own = file_hash(grid);
    if (parts.empty()) return own;
    std::string text = fmt::format("\n{}\n", hex(own));
    for (const GridPart& part : parts)
        text += fmt::format("{}\n{}\n", part.role, hex(part_hash(part)));
    return text_hash(text);
}

bool has_grid_hash(const fs::path& grid, const std::string& hash) {
    std::error_code fault;
    if (!fs::is_regular_file(grid, fault) && !is_zarr(grid)) return false;
    try {
        return hex(grid_hash(grid)) == hash;
    } catch (const std::exception&) {
        return false;  // it cannot be read
    }
}

}  // namespace fumon
