#include "files/avalanche_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <system_error>

#include "files/input_file.h"

namespace fumon {

namespace {

constexpr std::size_t columns = 5;
constexpr std::array<std::string_view, columns> column_names{"grain", "size", "duration",
                                                             "topplings", "lost"};
constexpr std::array<std::int64_t, columns> least{1, 1, 1, 1, 0};
constexpr std::int64_t most = 1'000'000'000'000'000;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// Goes through a text line by line.
class Lines {
  public:
    Lines(std::string_view text, std::size_t start) : text_(text), offset_(start) {}

    [[nodiscard]] bool ended() const { return offset_ >= text_.size(); }

    /// The next line without its end, which is a part of the text.
    std::string_view next() {
        std::size_t end = offset_;
        while (end < text_.size() && !is_line_end(text_[end])) ++end;
        const std::string_view line = text_.substr(offset_, end - offset_);
        const bool pair = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
        offset_ = end + (pair ? 2 : 1);
        return line;
    }

  private:
    std::string_view text_;
    std::size_t offset_;
};

class AvalancheReader {
  public:
    explicit AvalancheReader(const TextSource& source) : source_(source) {}

    [[nodiscard]] std::vector<Avalanche> read() const {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        std::string_view text = source_.text;
        const std::size_t start = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        while (text.size() > start && is_space(text.back())) text.remove_suffix(1);
        if (text.size() == start)
            source_.fail_at_column(
                0, "the file is empty",
                fmt::format("a table of avalanches starts with '{}'", avalanche_table_header));
        Lines lines(text, start);
        check_header(lines.next());
        std::vector<Avalanche> avalanches;
        while (!lines.ended()) avalanches.push_back(row(lines.next()));
        return avalanches;
    }

  private:
    [[nodiscard]] std::size_t offset_of(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - source_.text.data());
    }

    void check_header(std::string_view line) const {
        if (trimmed(line) != avalanche_table_header)
            source_.fail_at_column(
                offset_of(line),
                fmt::format("{} does not start a table of avalanches", shown(line)),
                fmt::format("its first line is '{}'", avalanche_table_header));
    }

    [[nodiscard]] Avalanche row(std::string_view line) const {
        const auto found = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
        if (trimmed(line).empty())
            source_.fail_at_column(offset_of(line), "a blank line between rows",
                                   "take it out, or the rows below it");
        if (found != columns)
            source_.fail_at_column(
                offset_of(line), fmt::format("{} fields in {}", found, shown(line)),
                fmt::format("write {} whole numbers: {}", columns, avalanche_table_header));
        std::array<std::int64_t, columns> numbers{};
        std::size_t start = 0;
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t end = std::min(line.find(',', start), line.size());
            numbers[column] = number(line.substr(start, end - start), column);
            start = end + 1;
        }
        return {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
    }

    [[nodiscard]] std::int64_t number(std::string_view field, std::size_t column) const {
        const std::string_view word = trimmed(field);
        std::int64_t value = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool whole = error == std::errc{} && stop == word.data() + word.size();
        if (!whole || value < least[column] || value > most)
            source_.fail_at_column(
                offset_of(word), fmt::format("{} is {}", column_names[column], shown(word)),
                fmt::format("write a whole number from {} to {}", least[column], most));
        return value;
    }

    const TextSource& source_;
};

}  // namespace

AvalancheFile::AvalancheFile(const std::filesystem::path& file) : file_(file) {
    rows_.append(avalanche_table_header).push_back('\n');
}

AvalancheFile::AvalancheFile(const std::filesystem::path& file, const FileBeginning& previous)
    : file_(file, previous) {}

void AvalancheFile::add(std::span<const Avalanche> avalanches) {
    constexpr std::size_t enough = 1 << 16;  // bytes; spares a system call for every grain
    for (const Avalanche& avalanche : avalanches) {
        fmt::format_to(std::back_inserter(rows_), "{},{},{},{},{}\n", avalanche.grain,
                       avalanche.size, avalanche.duration, avalanche.topplings, avalanche.lost);
        if (rows_.size() < enough) continue;
        file_.write(rows_);
        rows_.clear();
    }
}

FileBeginning AvalancheFile::sync() {
    file_.write(rows_);
    rows_.clear();
    return file_.sync();
}

void AvalancheFile::commit() {
    file_.write(rows_);
    rows_.clear();
    file_.commit();
}

std::vector<Avalanche> parse_avalanches(const TextSource& source) {
    return AvalancheReader(source).read();
}

std::vector<Avalanche> read_avalanches(const std::filesystem::path& file) {
    const std::string text = read_input_file(file);
    return parse_avalanches({file.string(), text});
}

}  // namespace fumon
