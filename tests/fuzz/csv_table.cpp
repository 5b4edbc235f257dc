// Tables of comma-separated values: measurements, a sweep's tables, a figure's own.

#include "files/csv_table.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    Table table;
    const auto text_of = [](const Table& table) {
        std::string text = csv_line(table.names());
        for (std::size_t row = 0; row < table.rows(); ++row) {
            std::vector<std::string> cells;
            for (const TableColumn& column : table.columns) cells.push_back(column.text(row));
            text += csv_line(cells);
        }
        return text;
    };
    if (!fuzz::taken([&] { table = parse_csv_table({"table.csv", fuzz::as_text(data, size)}); }))
        return 0;
    Table twice = table;
    twice.append(table);
    if (twice.rows() != 2 * table.rows())
        fuzz::broken_promise("a table can be appended to itself", "");
    // Other separators and ends of lines within cells may look like a table of their own.
    for (const std::string& name : table.names())
        if (name.find_first_of("\t;\r\n") != std::string::npos) return 0;
    const std::string text = text_of(table);
    if (text_of(parse_csv_table({"again.csv", text})) != text)
        fuzz::broken_promise("a written table reads back the same", text);
    return 0;
}
