#include "files/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

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
std::string as_meant(std::string cell) {
    if (cell.starts_with('\'') && is_marked_formula(cell)) cell.erase(0, 1);
    return cell;
}

class CsvReader {
  public:
    explicit CsvReader(const TextSource& source) : source_(source) {
        if (source_.text.starts_with(byte_order_mark)) place_ = byte_order_mark.size();
    }

    /// The cells of the next line that has some; none at the end.
    std::vector<std::string> next() {
        while (place_ < source_.text.size()) {
            begin_ = place_;
            if (is_line_end(source_.text[place_])) {
                ++place_;
            } else if (source_.text[place_] == '#') {
                while (place_ < source_.text.size() && !is_line_end(source_.text[place_])) ++place_;
            } else {
                return line();
            }
        }
        return {};
    }

    [[noreturn]] void fail(std::string_view what, std::string_view remedy) const {
        source_.fail(begin_, what, remedy);
    }

  private:
    std::vector<std::string> line() {
        std::vector<std::string> cells;
        for (;;) {
            cells.push_back(as_meant(at('"') ? quoted() : plain()));
            if (!at(',')) return cells;
            ++place_;
        }
    }

    [[nodiscard]] bool at(char letter) const {
        return place_ < source_.text.size() && source_.text[place_] == letter;
    }

    std::string plain() {
        const std::size_t end =
            std::min(source_.text.find_first_of(",\r\n", place_), source_.text.size());
        const std::size_t begin = std::exchange(place_, end);
        return std::string(source_.text.substr(begin, end - begin));
    }

    std::string quoted() {
        std::string cell;
        for (++place_;; ++place_) {
            if (place_ >= source_.text.size()) fail("a quote has no end", "close it");
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
    std::size_t place_ = 0;
    std::size_t begin_ = 0;
};

void add_cell(TableColumn& column, const std::string& cell) {
    const CellNumber number = number_of(cell);
    if (!number.is_number && column.words.empty()) {
        for (std::size_t row = 0; row < column.values.size(); ++row)
            column.words.push_back(column.text(row));
    }
    if (!number.is_number || !column.words.empty()) column.words.push_back(cell);
    column.values.push_back(number.value);
}

}  // namespace

std::string TableColumn::text(std::size_t row) const {
    if (row < words.size()) return words[row];
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

Table parse_csv_table(const TextSource& source) {
    CsvReader reader(source);
    Table table;
    for (const std::string& name : reader.next()) {
        if (table.find(name) != nullptr)
            reader.fail(fmt::format("column {} is there twice", shown(name)), "rename one");
        table.columns.push_back({name});
    }
    if (table.columns.empty())
        reader.fail("there is no header line", "begin with the columns' names");
    for (auto cells = reader.next(); !cells.empty(); cells = reader.next()) {
        if (cells.size() != table.columns.size()) {
            reader.fail(fmt::format("{} cells", cells.size()),
                        fmt::format("the header has {} columns", table.columns.size()));
        }
        for (std::size_t k = 0; k < cells.size(); ++k) add_cell(table.columns[k], cells[k]);
    }
    return table;
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& text : cells) {
        if (&text != &cells.front()) line += ',';
        const std::string cell = harmless(text);
        const bool begins = &text == &cells.front();
        const bool is_read =
            !begins || !(cell.starts_with('#') || cell.starts_with(byte_order_mark) ||
                         (cell.empty() && cells.size() == 1));
        if (is_read && cell.find_first_of(",\"\r\n") == std::string::npos) {
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
