#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "files/text_source.h"

namespace fumon {

/// One column of a table: a value for each row, NaN if the cell is empty or a word.
struct TableColumn {
    std::string name;
    std::string unit{};  ///< empty where there is none or it is not known
    std::vector<double> values{};
    std::vector<std::string> words{};  ///< the cells as written, where one is no number; else empty

    /// A cell as text.
    [[nodiscard]] std::string text(std::size_t row) const;
};

/// Rows of numbers and words under named columns.
struct Table {
    std::vector<TableColumn> columns;

    [[nodiscard]] std::size_t rows() const {
        return columns.empty() ? 0 : columns.front().values.size();
    }
    /// The column of that name, or nullptr.
    [[nodiscard]] const TableColumn* find(std::string_view name) const;
    [[nodiscard]] std::vector<std::string> names() const;

    /// Appends the rows of another table with the same columns in the same order.
    void append(const Table& other);
};

/// A column of one text in every row: a number where it is one.
TableColumn even_column(const std::string& name, const std::string& text, std::size_t rows);

/// Reads comma-separated values (RFC 4180; lines end in LF, CRLF or CR, a UTF-8 byte order mark and
/// empty lines are passed over, lines that begin with '#' are comments) with a header line. The
/// apostrophe that csv_line() puts before a text is taken away. Throws
/// InputError "file:line: what; remedy" for a missing header, a column named twice, a row with
/// another number of cells, and a quote without end.
Table parse_csv_table(const TextSource& source);

/// One line of such a file, ended by LF: cells with a comma, quote or line break are quoted, and a
/// first one that would make the line a comment or an empty one. A cell
/// that is no number and begins with =, +, -, @, a tab or a line break, which spreadsheets take for
/// a formula, gets an apostrophe before it.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace fumon
