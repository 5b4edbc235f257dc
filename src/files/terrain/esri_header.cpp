#include "files/terrain/esri_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/limits.h"
#include "files/terrain/terrain_format.h"
#include "files/terrain/text_grid.h"

namespace fumon {

namespace {

enum Word : std::size_t {
    ncols,
    nrows,
    xllcorner,
    yllcorner,
    xllcenter,
    yllcenter,
    cellsize,
    dx,
    dy,
    nodata_value,
    word_count
};

constexpr std::array<std::string_view, word_count> word_names{
    "ncols",     "nrows",    "xllcorner", "yllcorner", "xllcenter",
    "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

constexpr std::string_view all_words =
    "ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy), "
    "NODATA_value";

constexpr std::size_t looked_at = 4096;  // bytes; other formats betray themselves sooner

struct Entry {
    std::string_view text;  ///< the value as written
    double value = 0.0;
    bool is_nan = false;
    std::size_t offset = 0;
};

using Entries = std::array<std::optional<Entry>, word_count>;

std::optional<Word> known_word(std::string_view written) {
    std::string lower(written);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    if (lower == "nodata") return nodata_value;
    if (lower == "xllcentre") return xllcenter;
    if (lower == "yllcentre") return yllcenter;
    // GeoClaw's, whose corner is the first point, not an edge.
    if (lower == "mx") return ncols;
    if (lower == "my") return nrows;
    if (lower == "xlower" || lower == "xll") return xllcenter;
    if (lower == "ylower" || lower == "yll") return yllcenter;
    const auto* found = std::find(word_names.begin(), word_names.end(), lower);
    if (found == word_names.end()) return std::nullopt;
    return static_cast<Word>(found - word_names.begin());
}

std::size_t skip_spaces(std::string_view text, std::size_t offset) {
    while (offset < text.size() && is_space(text[offset])) ++offset;
    return offset;
}

std::size_t skip_blanks(std::string_view text, std::size_t offset) {
    while (offset < text.size() && is_blank(text[offset])) ++offset;
    return offset;
}

/// The word of a line that has its number first, as GeoClaw writes headers ("20 ncols"), and with
/// it the number as the line's entry; nothing where the line is no such one.
std::optional<std::pair<Word, Entry>> value_first(const TextSource& source, std::size_t& offset) {
    const std::string_view number_text = word_at(source.text, offset);
    const ParsedNumber number = parse_number(number_text);
    if (number.kind != NumberKind::finite && number.kind != NumberKind::not_a_number)
        return std::nullopt;
    const std::size_t at = skip_blanks(source.text, offset + number_text.size());
    if (at >= source.text.size() || is_line_end(source.text[at])) return std::nullopt;
    const std::string_view word = word_at(source.text, at);
    const auto known = known_word(word);
    if (!known) return std::nullopt;
    const Entry entry{number_text, number.value, number.kind == NumberKind::not_a_number, offset};
    offset = at + word.size();
    while (offset < source.text.size() && !is_line_end(source.text[offset])) ++offset;  // a comment
    return std::pair(*known, entry);
}

/// GeoClaw's line of two sizes, "10 20 cellsize": those of dx and dy lines.
bool read_two_sizes(const TextSource& source, std::size_t& offset, Entries& entries) {
    std::array<Entry, 2> sizes;
    std::size_t at = offset;
    for (Entry& size : sizes) {
        const std::string_view text = word_at(source.text, at);
        const ParsedNumber number = parse_number(text);
        if (number.kind != NumberKind::finite) return false;
        size = {text, number.value, false, at};
        at = skip_blanks(source.text, at + text.size());
    }
    const std::string_view word = word_at(source.text, at);
    if (known_word(word) != cellsize) return false;
    entries[dx] = sizes[0];
    entries[dy] = sizes[1];
    offset = at + word.size();
    return true;
}

/// The value of a header word, which stands on the rest of its line and alone there.
Entry read_value(const TextSource& source, std::string_view word, std::size_t& offset) {
    const std::size_t word_offset = offset;
    offset = skip_blanks(source.text, offset + word.size());
    const std::string_view text = word_at(source.text, offset);
    const std::string remedy = fmt::format("write one number after {}", word);
    if (text.empty()) source.fail(word_offset, fmt::format("{} has no value", word), remedy);
    const ParsedNumber number = parse_number(text);
    if (number.kind == NumberKind::none)
        source.fail(offset, fmt::format("{} is {}, which is not a number", word, shown(text)),
                    remedy);
    if (number.kind == NumberKind::infinite)
        source.fail(offset, fmt::format("{} is {}, which is infinite", word, shown(text)),
                    "write a finite number");
    const Entry entry{text, number.value, number.kind == NumberKind::not_a_number, word_offset};
    offset = skip_blanks(source.text, offset + text.size());
    if (offset < source.text.size() && !is_line_end(source.text[offset]))
        source.fail(offset,
                    fmt::format("{} has more than one value: {}", word,
                                shown(word_at(source.text, offset))),
                    fmt::format("{}, and nothing else on its line", remedy));
    return entry;
}

void refuse_what_is_no_grid(const TextSource& source, std::size_t start) {
    if (skip_spaces(source.text, start) == source.text.size())
        source.fail(start, "the file is empty", "an ESRI ASCII grid starts with its ncols line");
    constexpr char end_of_dos_text = '\x1A';
    for (std::size_t i = start; i < std::min(source.text.size(), start + looked_at); ++i) {
        const auto code = static_cast<unsigned char>(source.text[i]);
        if (code < 0x20 && !is_space(source.text[i]) && source.text[i] != end_of_dos_text)
            source.fail(
                i, "this is a binary file",
                "terrain is " + terrain_titles() + " (gdal_translate -of AAIGrid makes one)");
    }
}

[[noreturn]] void refuse_again(const TextSource& source, std::size_t offset, std::string_view word,
                               std::size_t first) {
    source.fail(
        offset,
        fmt::format("{} occurs again (first on line {})", word, line_of(source.text, first)),
        "keep one of the two lines");
}

void check_number(const TextSource& source, const Entry& entry, Word known, std::string_view word) {
    if (entry.is_nan && known != nodata_value)
        source.fail(entry.offset, fmt::format("{} is not a number", word),
                    fmt::format("write one number after {}", word));
}

/// Reads all header lines; returns the offset of the first height.
std::size_t read_entries(const TextSource& source, std::size_t offset, Entries& entries) {
    bool first = true;
    for (;; first = false) {
        offset = skip_spaces(source.text, offset);
        const std::string_view word = word_at(source.text, offset);
        const std::size_t line = offset;
        if (read_two_sizes(source, offset, entries)) continue;
        if (auto turned = value_first(source, offset)) {
            auto& entry = entries[turned->first];
            if (entry) refuse_again(source, line, word_names[turned->first], entry->offset);
            entry = turned->second;
            check_number(source, *entry, turned->first, word_names[turned->first]);
            continue;
        }
        if (word.empty() || parse_number(word).kind != NumberKind::none) return offset;
        const bool is_name = std::all_of(word.begin(), word.end(), [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
        });
        const auto known = known_word(word);
        if (!known && first)
            source.fail(offset, fmt::format("{} does not start an ESRI ASCII grid", shown(word)),
                        fmt::format("its header has {}", all_words));
        // A first height that is misspelt reads better as such than as an unknown header word.
        if (!known && !is_name) return offset;
        if (!known)
            source.fail(offset, fmt::format("unknown header word {}", shown(word)),
                        fmt::format("known are {}", all_words));
        auto& entry = entries[*known];
        if (entry) refuse_again(source, offset, word, entry->offset);
        entry = read_value(source, word, offset);
        check_number(source, *entry, *known, word);
    }
}

/// Both words of a pair that exclude each other.
void refuse_both(const TextSource& source, const Entries& entries, Word one, Word other) {
    if (!entries[one] || !entries[other]) return;
    source.fail(std::max(entries[one]->offset, entries[other]->offset),
                fmt::format("{} and {} exclude each other", word_names[one], word_names[other]),
                "keep one of the two lines");
}

const Entry& required(const TextSource& source, const Entries& entries, Word word,
                      std::size_t end) {
    if (!entries[word])
        source.fail(end, fmt::format("no {} line before the heights", word_names[word]),
                    fmt::format("add '{} NUMBER' to the header", word_names[word]));
    return *entries[word];
}

int read_count(const TextSource& source, const Entry& entry, std::string_view word) {
    const bool fits = entry.value >= 1.0 &&
                      entry.value <= static_cast<double>(largest_grid_cells) &&
                      entry.value == std::floor(entry.value);
    if (!fits)
        source.fail(entry.offset, fmt::format("{} is {}", word, shown(entry.text)),
                    fmt::format("write a whole number from 1 to {}", largest_grid_cells));
    return static_cast<int>(entry.value);
}

double read_cell_size(const TextSource& source, const Entry& entry, std::string_view word) {
    if (!(entry.value > 0.0))
        source.fail(entry.offset, fmt::format("{} is {}", word, shown(entry.text)),
                    "write a cell size greater than 0");
    return entry.value;
}

double read_edge(const Entries& entries, Word corner, Word centre, double cell) {
    if (entries[corner]) return entries[corner]->value;
    return entries[centre] ? entries[centre]->value - 0.5 * cell : 0.0;
}

}  // namespace

EsriHeader read_esri_header(const TextSource& source) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    const std::size_t start = source.text.starts_with(byte_order_mark) ? 3 : 0;
    if (const auto other = other_text_grid(source.text.substr(0, looked_at)))
        source.fail(0, fmt::format("this is {}", other->title), other->remedy);
    refuse_what_is_no_grid(source, start);

    Entries entries;
    EsriHeader header;
    header.end = read_entries(source, start, entries);
    const Entry& columns = required(source, entries, ncols, header.end);
    const Entry& rows = required(source, entries, nrows, header.end);
    header.nx = read_count(source, columns, "ncols");
    header.ny = read_count(source, rows, "nrows");
    const long long cells = static_cast<long long>(header.nx) * header.ny;
    if (cells > largest_grid_cells)
        source.fail(std::max(columns.offset, rows.offset),
                    fmt::format("ncols × nrows = {} × {} = {} cells", header.nx, header.ny, cells),
                    fmt::format("at most {} are read; cut out or coarsen the part you need",
                                largest_grid_cells));

    refuse_both(source, entries, cellsize, dx);
    refuse_both(source, entries, cellsize, dy);
    refuse_both(source, entries, xllcorner, xllcenter);
    refuse_both(source, entries, yllcorner, yllcenter);
    const bool two_sizes = entries[dx] || entries[dy];
    const Word size_x = two_sizes ? dx : cellsize;
    const Word size_y = two_sizes ? dy : cellsize;
    header.dx =
        read_cell_size(source, required(source, entries, size_x, header.end), word_names[size_x]);
    header.dy =
        read_cell_size(source, required(source, entries, size_y, header.end), word_names[size_y]);
    header.west = read_edge(entries, xllcorner, xllcenter, header.dx);
    header.south = read_edge(entries, yllcorner, yllcenter, header.dy);
    if (entries[nodata_value])
        header.nodata = entries[nodata_value]->is_nan ? std::nan("") : entries[nodata_value]->value;
    return header;
}

}  // namespace fumon
