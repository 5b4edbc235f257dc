#include "sweep/sweep_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

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
        if (!std::getline(stream_, header_)) fail("it has no headerer line");
    }

    [[nodiscard]] const std::string& header() const { return header_; }

    bool next(std::string& line) {
        if (std::getline(stream_, line)) {
            if (std::count(line.begin(), line.end(), ',') !=
                std::count(header_.begin(), header_.end(), ','))
                fail("it has a line with more or fewer cells than its header");
            return true;
        }
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

/// The columns of all files, by name.
class Columns {
  public:
    explicit Columns(const std::vector<TablePart>& parts) {
        std::set<std::string> headers;  // runs of one model have the same
        for (const TablePart& part : parts) {
            const MeasurementReader reader(part.file);
            if (!headers.insert(reader.header()).second) continue;
            for (const std::string& name : split_cells(reader.header())) {
                if (places_.emplace(name, names_.size()).second) names_.push_back(name);
            }
        }
    }

    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

    /// Which of them each column of a file is.
    [[nodiscard]] std::vector<std::size_t> places(const std::string& header) const {
        std::vector<std::size_t> found;
        for (const std::string& name : split_cells(header)) found.push_back(places_.at(name));
        return found;
    }

  private:
    std::vector<std::string> names_;
    std::map<std::string, std::size_t> places_;
};

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
    const Columns columns(parts);
    std::vector<std::string> header = names;
    header.insert(header.end(), columns.names().begin(), columns.names().end());
    AtomicFile file(table);
    std::string text = csv_line(header);
    std::string line;
    for (const TablePart& part : parts) {
        MeasurementReader reader(part.file);
        std::string before = csv_line(part.cells);
        before.back() = ',';  // was the line's end
        const auto place = columns.places(reader.header());
        const bool as_it_stands =
            place.size() == columns.names().size() && std::is_sorted(place.begin(), place.end());
        while (reader.next(line)) {
            text += before;
            text += as_it_stands ? line + "\n" : rearranged(line, place, columns.names().size());
            if (text.size() < enough_to_write) continue;
            file.write(text);
            text.clear();
        }
    }
    file.write(text);
    file.commit();
}

}  // namespace fumon
