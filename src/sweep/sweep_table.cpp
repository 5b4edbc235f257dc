#include "sweep/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/csv_table.h"

namespace fumon {

namespace {

/// A file of measurements, whose cells hold neither commas nor quotes.
class MeasurementReader {
  public:
    explicit MeasurementReader(const std::filesystem::path& file)
        : file_(file), stream_(file, std::ios::binary) {
        if (!next(header_)) fail("it has no header line");
    }

    [[nodiscard]] const std::string& header() const { return header_; }

    bool next(std::string& line) {
        if (std::getline(stream_, line)) return true;
        if (stream_.bad() || !stream_.eof()) fail("reading fails");
        return false;
    }

  private:
    [[noreturn]] void fail(const char* what) const {
        throw Error(fmt::format("cannot read {}: {}", file_.string(), what));
    }

    std::filesystem::path file_;
    std::ifstream stream_;
    std::string header_;
};

std::vector<std::string> split_cells(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t comma = line.find(',', begin);
        cells.push_back(line.substr(begin, comma - begin));
        if (comma == std::string::npos) return cells;
        begin = comma + 1;
    }
}

/// The columns of all files; runs of one model have the same, so a header is mostly a known one.
std::vector<std::string> all_columns(const std::vector<TablePart>& parts) {
    std::vector<std::string> columns;
    std::string last_header;
    for (const TablePart& part : parts) {
        const MeasurementReader reader(part.file);
        if (reader.header() == last_header) continue;
        last_header = reader.header();
        for (const std::string& name : split_cells(last_header)) {
            if (std::find(columns.begin(), columns.end(), name) == columns.end())
                columns.push_back(name);
        }
    }
    return columns;
}

/// Which of the table's columns each column of a file is.
std::vector<std::size_t> places(const std::string& header,
                                const std::vector<std::string>& columns) {
    std::vector<std::size_t> found;
    for (const std::string& name : split_cells(header)) {
        found.push_back(static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                                 columns.begin()));
    }
    return found;
}

std::string rearranged(const std::string& line, const std::vector<std::size_t>& place,
                       std::size_t columns) {
    const std::vector<std::string> cells = split_cells(line);
    std::vector<std::string> all(columns);
    for (std::size_t k = 0; k < std::min(cells.size(), place.size()); ++k) all[place[k]] = cells[k];
    return csv_line(all);
}

}  // namespace

void write_table(const std::filesystem::path& table, const std::vector<std::string>& names,
                 const std::vector<TablePart>& parts) {
    constexpr std::size_t enough_to_write = 1 << 16;  // bytes
    const std::vector<std::string> columns = all_columns(parts);
    std::vector<std::string> header = names;
    header.insert(header.end(), columns.begin(), columns.end());
    AtomicFile file(table);
    std::string text = csv_line(header);
    std::string line;
    for (const TablePart& part : parts) {
        MeasurementReader reader(part.file);
        std::string before = csv_line(part.cells);
        before.back() = ',';  // was the line's end
        const auto place = places(reader.header(), columns);
        const bool as_it_stands =
            place.size() == columns.size() && std::is_sorted(place.begin(), place.end());
        while (reader.next(line)) {
            text += before;
            text += as_it_stands ? line + "\n" : rearranged(line, place, columns.size());
            if (text.size() < enough_to_write) continue;
            file.write(text);
            text.clear();
        }
    }
    file.write(text);
    file.commit();
}

}  // namespace fumon
