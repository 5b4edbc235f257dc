#include "files/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/find_named.h"

namespace fumon {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The number that a whole cell is, blanks beside it passed over.
struct CellNumber {
    bool is_number = false;
    double value = nothing;
};

CellNumber number_of(std::string_view cell) {
    while (!cell.empty() && is_blank(cell.front())) cell.remove_prefix(1);
    while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
    if (cell.empty()) return {true, nothing};
    const ParsedNumber number = parse_number(cell);
    if (number.kind == NumberKind::none || number.length != cell.size()) return {};
    return {true, number.kind == NumberKind::finite ? number.value : nothing};
}

bool is_blank_text(std::string_view text) {
    return std::ranges::all_of(text, is_blank);
}

/// Whether a cell that begins so is a formula to a spreadsheet.
bool begins_a_formula(std::string_view cell) {
    return !cell.empty() && std::string_view("=+-@\t\r\n").find(cell.front()) != cell.npos;
}

/// Whether a cell is a text that apostrophes stand before, if any do, and else a formula.
bool is_marked_formula(std::string_view cell) {
    const std::size_t apostrophes = std::min(cell.find_first_not_of('\''), cell.size());
    return begins_a_formula(cell.substr(apostrophes));
}

/// A cell as it stands in a file: a text that a spreadsheet would take for a formula gets an
/// apostrophe before it. Numbers stay as they are.
std::string harmless(const std::string& cell) {
    return is_marked_formula(cell) && !number_of(cell).is_number ? "'" + cell : cell;
}

/// What harmless() was given.
std::string without_formula_mark(std::string cell) {
    if (cell.starts_with('\'') && is_marked_formula(cell)) cell.erase(0, 1);
    return cell;
}

class CsvReader {
  public:
    CsvReader(const TextSource& source, char separator) : source_(source), separator_(separator) {
        if (source_.text.starts_with(byte_order_mark)) place_ = byte_order_mark.size();
    }

    /// The columns' names: the same without the blanks beside those that are not quoted.
    std::vector<std::string> names() {
        of_names_ = true;
        std::vector<std::string> cells = next();
        of_names_ = false;
        return cells;
    }

    /// The cells of the next line that has some; none at the end.
    std::vector<std::string> next() {
        while (place_ < source_.text.size()) {
            begin_ = place_;
            const std::size_t end = end_of_line();
            if (is_line_end(source_.text[place_])) {
                ++place_;
            } else if (source_.text[place_] == '#' || is_blank_until(end)) {
                place_ = end;
            } else {
                return line();
            }
        }
        return {};
    }

    /// The number of the last line that had cells, where it begins.
    [[nodiscard]] std::size_t line_number() {
        line_ += line_of(source_.text.substr(counted_, begin_ - counted_), begin_ - counted_) - 1;
        counted_ = begin_;
        return line_;
    }

    [[noreturn]] void fail(std::string_view what, std::string_view remedy) const {
        source_.fail(begin_, what, remedy);
    }

  private:
    [[nodiscard]] std::size_t end_of_line() const {
        return std::min(source_.text.find_first_of("\r\n", place_), source_.text.size());
    }

    [[nodiscard]] bool is_blank_until(std::size_t end) const {
        return std::ranges::all_of(source_.text.substr(place_, end - place_), [this](char letter) {
            return is_blank(letter) && letter != separator_;
        });
    }

    std::vector<std::string> line() {
        std::vector<std::string> cells;
        for (;;) {
            cells.push_back(without_formula_mark(at('"') ? quoted() : plain()));
            if (!at(separator_)) return cells;
            ++place_;
        }
    }

    [[nodiscard]] bool at(char letter) const {
        return place_ < source_.text.size() && source_.text[place_] == letter;
    }

    std::string plain() {
        const std::string_view ends("\r\n");
        std::size_t end = place_;
        while (end < source_.text.size() && source_.text[end] != separator_ &&
               ends.find(source_.text[end]) == ends.npos)
            ++end;
        std::string_view cell = source_.text.substr(place_, end - place_);
        place_ = end;
        while (of_names_ && cell.starts_with(' ')) cell.remove_prefix(1);
        while (of_names_ && cell.ends_with(' ')) cell.remove_suffix(1);
        return std::string(cell);
    }

    std::string quoted() {
        std::string cell;
        for (++place_;; ++place_) {
            if (place_ >= source_.text.size())
                fail("a quoted cell is not closed", "write its closing quote");
            if (source_.text[place_] != '"') {
                cell += source_.text[place_];
            } else {
                ++place_;
                if (!at('"')) break;
                cell += '"';
            }
        }
        return cell + plain();
    }

    TextSource source_;
    char separator_;
    std::size_t place_ = 0;
    std::size_t begin_ = 0;
    bool of_names_ = false;
    std::size_t counted_ = 0;
    std::size_t line_ = 1;
};

/// With a point for its decimal comma, where that makes it a number.
std::string with_point(const std::string& cell) {
    const std::size_t comma = cell.find(',');
    if (comma == cell.npos || cell.find_first_of(",.", comma + 1) != cell.npos ||
        cell.find('.') != cell.npos)
        return cell;
    std::string number = cell;
    number[comma] = '.';
    return number_of(number).is_number ? number : cell;
}

/// Whether cells are numbers, and at least one is not empty.
bool are_numbers(const std::vector<std::string>& cells, bool decimal_commas) {
    bool any = false;
    for (const std::string& cell : cells) {
        if (!number_of(decimal_commas ? with_point(cell) : cell).is_number) return false;
        any = any || std::ranges::any_of(cell, [](char letter) { return !is_blank(letter); });
    }
    return any;
}

/// What stands between the cells.
char separator_of(const TextSource& source) {
    std::vector<char> that_fit;
    char in_first = ',';
    for (const char separator : {'\t', ';', ','}) {  // of the last most is kept
        try {
            CsvReader reader(source, separator);
            const std::size_t names = reader.next().size();
            if (names < 2) continue;
            in_first = separator;
            const std::vector<std::string> row = reader.next();
            if (row.size() != names) continue;
            if (separator == ',' && !that_fit.empty()) {  // decimal ones?
                CsvReader other(source, that_fit.back());
                other.next();
                if (are_numbers(other.next(), true)) continue;
            }
            that_fit.push_back(separator);
        } catch (const InputError&) {
            continue;  // a quote that it leaves open
        }
    }
    return that_fit.empty() ? in_first : that_fit.back();
}

/// Which of decimal commas and points the numbers of a file have.
class DecimalSigns {
  public:
    explicit DecimalSigns(char separator) : may_be_commas_(separator != ',') {}

    std::string taken(const std::string& cell, const CsvReader& reader) {
        if (!may_be_commas_) return cell;
        std::string number = with_point(cell);
        const bool comma = number != cell;
        has_comma_ = has_comma_ || comma;
        has_point_ = has_point_ || (!comma && cell.find('.') != cell.npos && is_number(cell));
        if (has_comma_ && has_point_)
            reader.fail("numbers mix decimal commas and decimal points", "write one of them");
        return number;
    }

  private:
    static bool is_number(const std::string& cell) { return number_of(cell).is_number; }

    bool may_be_commas_;
    bool has_comma_ = false;
    bool has_point_ = false;
};

void add_cell(TableColumn& column, const std::string& cell, const std::string& written) {
    const CellNumber number = number_of(cell);
    if (!number.is_number && column.words.empty()) {
        for (std::size_t row = 0; row < column.values.size(); ++row)
            column.words.push_back(column.text(row));
    }
    if (!number.is_number || !column.words.empty()) column.words.push_back(written);
    if (number.is_number && number.value != number.value && !is_blank_text(cell))
        column.not_finite.emplace(column.values.size(), written);
    column.values.push_back(number.value);
}

std::string counted(std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

[[noreturn]] void refuse_row(const CsvReader& reader, std::size_t cells, std::size_t columns,
                             char separator) {
    std::string remedy = fmt::format("the header has {}", counted(columns, "column"));
    if (separator == ',' && cells > columns)
        remedy += "; decimal commas take semicolons or tabs between cells";
    reader.fail(counted(cells, "cell"), remedy);
}

bool has_mark_of_utf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

}  // namespace

std::string TableColumn::text(std::size_t row) const {
    if (row < words.size()) return words[row];
    if (const auto special = not_finite.find(row); special != not_finite.end())
        return special->second;
    return values[row] == values[row] ? fmt::format("{}", values[row]) : "";
}

const TableColumn* Table::find(std::string_view name) const {
    return find_named(columns, name);
}

std::vector<std::string> Table::names() const {
    std::vector<std::string> all;
    all.reserve(columns.size());
    for (const TableColumn& column : columns) all.push_back(column.name);
    return all;
}

void Table::append(const Table& other) {
    if (columns.empty()) {
        *this = other;
        return;
    }
    lines.clear();  // of more than one file
    for (std::size_t k = 0; k < columns.size(); ++k) {
        TableColumn& column = columns[k];
        const TableColumn& more = other.columns[k];
        const std::size_t before = column.values.size();
        if (!column.words.empty() || !more.words.empty()) {
            while (column.words.size() < before)
                column.words.push_back(column.text(column.words.size()));
            for (std::size_t row = 0; row < more.values.size(); ++row)
                column.words.push_back(more.text(row));
        }
        for (const auto& [row, written] : more.not_finite)
            column.not_finite.emplace(before + row, written);
        column.values.insert(column.values.end(), more.values.begin(), more.values.end());
    }
}

TableColumn even_column(const std::string& name, const std::string& text, std::size_t rows) {
    TableColumn column{name};
    const CellNumber number = number_of(text);
    column.values.assign(rows, number.value);
    if (!number.is_number) column.words.assign(rows, text);
    return column;
}

Table parse_csv_table(const TextSource& source, const WantedHeader& wanted) {
    constexpr const char* utf16 = "the text is UTF-16";
    constexpr const char* remedy = "save it as UTF-8";
    if (has_mark_of_utf16(source.text)) source.fail(0, utf16, remedy);
    const char separator = separator_of(source);
    CsvReader reader(source, separator);
    DecimalSigns decimals(separator);
    Table table;
    const auto add_row = [&](const std::vector<std::string>& cells) {
        if (cells.size() != table.columns.size())
            refuse_row(reader, cells.size(), table.columns.size(), separator);
        for (std::size_t k = 0; k < cells.size(); ++k)
            add_cell(table.columns[k], decimals.taken(cells[k], reader), cells[k]);
        table.lines.push_back(reader.line_number());
    };
    const std::vector<std::string> first = reader.names();
    if (first.empty()) reader.fail("there is no header line", wanted.help);
    if (has_mark_of_utf16(first.front())) reader.fail(utf16, remedy);  // behind blank lines
    const bool is_data = are_numbers(first, separator != ',');
    if (is_data && wanted.by_position.size() != first.size()) {
        reader.fail(
            fmt::format("{} of numbers and no header line", counted(first.size(), "column")),
            wanted.help);
    }
    for (const std::string& name : is_data ? wanted.by_position : first) {
        if (table.find(name) != nullptr)
            reader.fail(fmt::format("column {} occurs twice", shown(name)), "rename one");
        table.columns.push_back({name});
    }
    if (is_data) add_row(first);
    for (auto cells = reader.next(); !cells.empty(); cells = reader.next()) add_row(cells);
    return table;
}

const std::vector<double>& numbers_of(const TextSource& source, const Table& table,
                                      const TableColumn& column, double low, double high) {
    for (std::size_t row = 0; row < column.values.size(); ++row) {
        const double value = column.values[row];
        if (value >= low && value <= high) continue;
        const auto special = column.not_finite.find(row);
        const std::string written =
            special == column.not_finite.end() ? column.text(row) : special->second;
        const std::string place = row < table.lines.size()
                                      ? fmt::format("{}:{}", source.name, table.lines[row])
                                      : source.name;
        const bool any = low == std::numeric_limits<double>::lowest() &&
                         high == std::numeric_limits<double>::max();
        throw InputError(fmt::format(
            "{}: {} is {}; it takes a {}", place, column.name,
            is_blank_text(written) ? "empty" : shown(written),
            any ? "finite number" : fmt::format("number from {:g} to {:g}", low, high)));
    }
    return column.values;
}

std::string csv_number(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& text : cells) {
        if (&text != &cells.front()) line += ',';
        const std::string cell = harmless(text);
        const bool begins = &text == &cells.front();
        const bool is_read =
            !begins || !(cell.starts_with('#') || cell.starts_with(byte_order_mark) ||
                         (is_blank_text(cell) && cells.size() == 1));
        const bool has_tab = cells.size() == 1 && cell.find('\t') != std::string::npos;
        const bool has_edges = cell.starts_with(' ') || cell.ends_with(' ');
        if (is_read && !has_tab && !has_edges &&
            cell.find_first_of(",;\"\r\n") == std::string::npos) {
            line += cell;
            continue;
        }
        line += '"';
        for (const char letter : cell) line += letter == '"' ? "\"\"" : std::string(1, letter);
        line += '"';
    }
    return line + "\n";
}

}  // namespace fumon
