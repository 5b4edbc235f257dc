#include "foreign/file_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <numeric>
#include <system_error>

#include "base/error.h"
#include "foreign/calendar.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

bool is_digit(char letter) {
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

/// The numbers in a name: digits, with a point between digits as their decimals.
std::vector<double> numbers_in(std::string_view name) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < name.size();) {
        if (!is_digit(name[i])) {
            ++i;
            continue;
        }
        std::size_t end = i;
        bool point = false;
        while (end < name.size() &&
               (is_digit(name[end]) ||
                (!point && name[end] == '.' && end + 1 < name.size() && is_digit(name[end + 1])))) {
            point = point || name[end] == '.';
            ++end;
        }
        double number = 0.0;
        std::from_chars(name.data() + i, name.data() + end, number);
        numbers.push_back(number);
        i = end;
    }
    return numbers;
}

/// How many digits a part of a date's pattern has; 0 for what is none.
std::size_t digits_of(char part) {
    switch (part) {
        case 'Y':
            return 4;
        case 'j':
            return 3;
        case 'y':
        case 'm':
        case 'd':
        case 'H':
        case 'M':
        case 'S':
            return 2;
        default:
            return 0;
    }
}

void set_part(DateTime& date, char part, int number, int& day_of_year) {
    switch (part) {
        case 'Y':
            date.year = number;
            break;
        case 'y':
            date.year = number < 69 ? 2000 + number : 1900 + number;
            break;
        case 'm':
            date.month = number;
            break;
        case 'd':
            date.day = number;
            break;
        case 'j':
            day_of_year = number;
            break;
        case 'H':
            date.second += std::int64_t{3'600} * number;
            break;
        case 'M':
            date.second += std::int64_t{60} * number;
            break;
        default:
            date.second += number;
    }
}

/// The date at a text's front.
std::optional<std::int64_t> date_at(std::string_view text, std::string_view pattern) {
    DateTime date;
    int day_of_year = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '%' || i + 1 == pattern.size()) {
            if (at >= text.size() || text[at++] != pattern[i]) return std::nullopt;
            continue;
        }
        const char part = pattern[++i];
        const std::size_t digits = digits_of(part);
        int number = 0;
        if (digits == 0 || at + digits > text.size()) return std::nullopt;
        const char* const end = text.data() + at + digits;
        if (!is_digit(text[at]) || std::from_chars(text.data() + at, end, number).ptr != end)
            return std::nullopt;
        at += digits;
        set_part(date, part, number, day_of_year);
    }
    if (date.month < 1 || date.month > 12 || date.day < 1 || date.day > 31) return std::nullopt;
    constexpr std::int64_t day = 86'400;
    const std::int64_t seconds = seconds_of(date, CalendarKind::gregorian);
    return day_of_year > 0 ? seconds + (day_of_year - 1) * day : seconds;
}

bool fits(std::string_view name, std::string_view pattern) {
    if (pattern.empty()) return name.empty();
    if (pattern.front() == '*') {
        for (std::size_t i = 0; i <= name.size(); ++i)
            if (fits(name.substr(i), pattern.substr(1))) return true;
        return false;
    }
    return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
           fits(name.substr(1), pattern.substr(1));
}

/// Which of the numbers in the names orders the files: the last that differs.
std::size_t ordering_number(const std::vector<std::vector<double>>& numbers) {
    const std::size_t count = numbers.front().size();
    for (std::size_t k = count; k-- > 0;) {
        if (std::ranges::any_of(numbers, [&](const std::vector<double>& one) {
                return one[k] != numbers.front()[k];
            }))
            return k;
    }
    return count - 1;
}

/// Refuses names in which a number before the one that orders them falls, as those of dates do.
void check_one_order(const std::vector<fs::path>& files,
                     const std::vector<std::vector<double>>& numbers, std::size_t ordering) {
    std::vector<std::size_t> order(numbers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return numbers[i][ordering]; });
    for (std::size_t n = 1; n < order.size(); ++n) {
        for (std::size_t k = 0; k < ordering; ++k) {
            if (numbers[order[n]][k] >= numbers[order[n - 1]][k]) continue;
            throw InputError(
                fmt::format("{}: several numbers of its name change, and no one of them orders the "
                            "files; of dates, --time-pattern says how they are written (%Y-%m-%d)",
                            files[order[n]].string()));
        }
    }
}

}  // namespace

std::optional<std::int64_t> find_date(std::string_view text, std::string_view pattern) {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (const auto date = date_at(text.substr(i), pattern)) return date;
    return std::nullopt;
}

bool is_pattern(std::string_view text) {
    return text.find_first_of("*?") != std::string_view::npos;
}

std::vector<fs::path> files_of_pattern(const std::string& pattern) {
    const fs::path path(pattern);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (is_pattern(folder.string()))
        throw InputError(fmt::format(
            "{}: * and ? stand for letters of the files' names, not of a folder's; name one folder",
            pattern));
    std::vector<fs::path> files;
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        if (entry.is_regular_file(fault) &&
            fits(entry.path().filename().string(), path.filename().string()))
            files.push_back(path.has_parent_path() ? entry.path() : entry.path().filename());
    }
    if (files.empty())
        throw InputError(fmt::format("{}: no file has a name of this pattern", pattern));
    std::ranges::sort(files);
    return files;
}

std::vector<NumberedFile> in_order(const std::vector<fs::path>& files,
                                   const std::string& time_pattern) {
    std::vector<NumberedFile> series;
    std::vector<std::vector<double>> numbers;
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        if (time_pattern.empty()) {
            numbers.push_back(numbers_in(file.stem().string()));
            if (numbers.back().empty())
                throw InputError(fmt::format(
                    "{}: its name has no number that says its place in the series", file.string()));
            if (numbers.back().size() != numbers.front().size())
                throw InputError(fmt::format("{}: its name has {} numbers, that of {} {}",
                                             file.string(), numbers.back().size(),
                                             files.front().string(), numbers.front().size()));
            series.push_back({file, 0.0});
        } else {
            const auto date = find_date(name, time_pattern);
            if (!date)
                throw InputError(fmt::format("{}: its name has no date of the pattern \"{}\"",
                                             file.string(), time_pattern));
            series.push_back({file, static_cast<double>(*date)});
        }
    }
    if (time_pattern.empty()) {
        const std::size_t k = ordering_number(numbers);
        check_one_order(files, numbers, k);
        for (std::size_t i = 0; i < series.size(); ++i) series[i].number = numbers[i][k];
    }
    std::ranges::stable_sort(series, {}, &NumberedFile::number);
    for (std::size_t i = 1; i < series.size(); ++i) {
        if (series[i].number == series[i - 1].number)
            throw InputError(fmt::format("{}: has the same number or date in its name as {}",
                                         series[i].file.string(), series[i - 1].file.string()));
    }
    return series;
}

}  // namespace fumon
