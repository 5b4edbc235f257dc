#pragma once

#include <cstddef>
#include <map>
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
    std::map<std::size_t, std::string> not_finite{};  ///< "inf", "nan" … as written, by their rows

    /// A cell as text.
    [[nodiscard]] std::string text(std::size_t row) const;
};

/// Rows of numbers and words under named columns.
struct Table {
    std::vector<TableColumn> columns;
    std::vector<std::size_t> lines{};  ///< of a file that was read: where each row begins, from 1

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

/// What a reader wants at the head of a table.
struct WantedHeader {
    /// Names of the columns where a file has as many and begins with numbers: only where their
    /// order leaves no doubt. Empty: it has to name them.
    std::vector<std::string> by_position{};
    std::string help = "begin with the columns' names";  ///< a remedy
};

/// Reads a table of cells between commas, semicolons or tabs (RFC 4180; lines end in LF, CRLF or
/// CR, a UTF-8 byte order mark and blank lines are passed over, lines that begin with '#' are
/// comments) under a header line. Every table that fumon reads goes through here but those of
/// avalanches, which only fumon writes.
///
/// Between cells is that of the three which cuts the first two lines into as many cells; between
/// semicolons or tabs numbers may have decimal commas, in the whole file or nowhere. A first line
/// of numbers alone is data under `wanted.by_position`. The apostrophe that csv_line() puts before
/// a text is taken away.
///
/// Throws InputError "file:line: what; remedy" for a missing header, also where the first line is
/// of numbers and the columns have no names by position, a column named twice, a row with another
/// number of cells, decimal commas beside decimal points, UTF-16, and a quote without end.
Table parse_csv_table(const TextSource& source, const WantedHeader& wanted = {});

/// The numbers of a column. Throws InputError "file:line: what; remedy" for the first cell that is
/// empty, a word, not finite, or not from `low` to `high`.
const std::vector<double>& numbers_of(const TextSource& source, const Table& table,
                                      const TableColumn& column, double low, double high);

/// One line of such a file, ended by LF: cells with a comma, semicolon, quote or line break are
/// quoted, and a first one that would make the line a comment or an empty one, or begin it with a
/// blank. A cell
/// that is no number and begins with =, +, -, @, a tab or a line break, which spreadsheets take for
/// a formula, gets an apostrophe before it.
std::string csv_line(const std::vector<std::string>& cells);

/// A number as a cell of such a line: empty where it is not known (NaN).
std::string csv_number(double value);

}  // namespace fumon
