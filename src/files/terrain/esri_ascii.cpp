#include "files/terrain/esri_ascii.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "files/terrain/esri_header.h"
#include "files/terrain/geographic.h"

namespace fumon {

namespace {

/// Recognises the cells that hold no data.
class NoDataValue {
  public:
    explicit NoDataValue(double value)
        : value_(value), tolerance_(std::abs(value) >= huge ? std::abs(value) * single : 0.0) {}
    [[nodiscard]] bool matches(double cell) const {
        return cell == value_ || std::abs(cell - value_) < tolerance_;
    }

  private:
    static constexpr double huge = 1e30;    // metres; no height is
    static constexpr double single = 1e-6;  // relative: single precision
    double value_;
    double tolerance_;
};

std::size_t count_words(std::string_view text) {
    std::size_t count = 0;
    bool inside = false;
    for (const char c : text) {
        const bool space = is_space(c);
        if (!space && !inside) ++count;
        inside = !space;
    }
    return count;
}

/// Everything that can be wrong with one cell's text.
[[noreturn]] void refuse_cell(const TextSource& source, std::size_t offset, NumberKind kind,
                              std::size_t cell, int nx) {
    const std::string_view word = word_at(source.text, offset);
    const std::size_t row = cell / static_cast<std::size_t>(nx) + 1;
    const std::size_t column = cell % static_cast<std::size_t>(nx) + 1;
    const std::string where = fmt::format("(row {}, column {})", row, column);
    if (kind == NumberKind::infinite)
        source.fail(offset, fmt::format("height {} {} is infinite", shown(word), where),
                    "write a finite number or the NODATA_value");
    const bool comma = word.find(',') != std::string_view::npos;
    source.fail(offset, fmt::format("height {} {} is not a number", shown(word), where),
                comma ? "write a decimal point, and spaces between numbers"
                      : "write a number or the NODATA_value");
}

[[noreturn]] void refuse_count(const TextSource& source, const EsriHeader& header,
                               std::size_t offset, std::size_t count) {
    source.fail(offset,
                fmt::format("{} heights where ncols × nrows = {} × {} = {} are needed", count,
                            header.nx, header.ny, static_cast<long long>(header.nx) * header.ny),
                "correct the header or the rows");
}

/// DOS editors ended a text with Control-Z.
std::string_view without_trailing_space(std::string_view text) {
    while (!text.empty() && (is_space(text.back()) || text.back() == '\x1A')) text.remove_suffix(1);
    return text;
}

void read_cells(const TextSource& source, const EsriHeader& header, Terrain& terrain) {
    const std::string_view text = without_trailing_space(source.text);
    const std::size_t needed =
        static_cast<std::size_t>(header.nx) * static_cast<std::size_t>(header.ny);
    // Every height takes a character and a space: a file too short for its header is refused before
    // memory is asked for.
    const std::size_t at_hand = text.size() - std::min(header.end, text.size());
    if (at_hand < 2 * needed - 1) {
        const std::size_t count = count_words(text.substr(text.size() - at_hand));
        refuse_count(source, header, text.size(), count);
    }
    terrain.heights = Grid(header.nx, header.ny);
    const NoDataValue nodata(header.nodata);
    std::size_t offset = header.end;
    std::size_t count = 0;
    for (int y = header.ny - 1; y >= 0; --y) {
        for (int x = 0; x < header.nx; ++x, ++count) {
            while (offset < text.size() && is_space(text[offset])) ++offset;
            if (offset == text.size()) refuse_count(source, header, offset, count);
            const ParsedNumber number = parse_number(text.substr(offset));
            if (number.kind == NumberKind::none || number.kind == NumberKind::infinite)
                refuse_cell(source, offset, number.kind, count, header.nx);
            offset += number.length;
            if (number.kind == NumberKind::not_a_number || nodata.matches(number.value)) {
                if (terrain.nodata.empty()) terrain.nodata = Mask(header.nx, header.ny);
                terrain.nodata(x, y) = 1;
            } else {
                terrain.heights(x, y) = number.value;
            }
        }
    }
    while (offset < text.size() && is_space(text[offset])) ++offset;
    if (offset < text.size())
        refuse_count(source, header, offset, count + count_words(text.substr(offset)));
}

}  // namespace

Terrain parse_esri_ascii(const TextSource& source, const std::optional<TerrainWindow>& window) {
    const EsriHeader header = read_esri_header(source);
    Terrain terrain;
    terrain.dx = header.dx;
    terrain.dy = header.dy;
    read_cells(source, header, terrain);
    const GridExtent extent{header.west,
                            header.south,
                            header.dx * header.nx,
                            header.dy * header.ny,
                            header.dx,
                            header.dy,
                            relief(terrain.heights, terrain.nodata)};
    if (extent.relief < 0.0)
        source.fail(
            header.end, "every cell is no-data",
            fmt::format("at least one height must differ from the NODATA_value {}", header.nodata));
    terrain.place = {header.west, header.south, header.dx, header.dy, is_geographic(extent)};
    crop(terrain, window, source.name);
    return terrain;
}

}  // namespace fumon
