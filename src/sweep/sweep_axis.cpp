#include "sweep/sweep_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace fumon {

namespace {

constexpr const char* right_form =
    "write key=v1,v2 or key=low:high:count, for example model.creep_rate=0.1:0.5:5";

template <class Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    if (fault != std::errc{} || stop != end) return std::nullopt;
    return number;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

/// Number k of `count` from low to high. Where both ends are short decimals the division below is
/// the only rounding, so 0.1:0.5:5 gives 0.3 and not 0.30000000000000004.
double evenly_spaced(double low, double high, std::int64_t count, std::int64_t k) {
    if (k == 0) return low;
    if (k == count - 1) return high;
    const auto after = static_cast<double>(k);
    const auto before = static_cast<double>(count - 1 - k);
    const auto all = static_cast<double>(count - 1);
    constexpr double exact_limit = 9007199254740992.0;  // 2^53
    constexpr int most_decimals = 15;
    double power = 1.0;
    for (int decimals = 0; decimals <= most_decimals; ++decimals, power *= 10.0) {
        const double whole_low = std::round(low * power);
        const double whole_high = std::round(high * power);
        if (std::max(std::abs(whole_low), std::abs(whole_high)) * all >= exact_limit) break;
        if (power * all >= exact_limit) break;
        if (whole_low / power == low && whole_high / power == high)
            return (whole_low * before + whole_high * after) / (all * power);
    }
    return low + (high - low) * (after / all);
}

/// Reads one axis from its text, saying where in it something is wrong.
class AxisReader {
  public:
    AxisReader(const std::string& text, const std::string& place, bool columns)
        : text_(text), place_(place), columns_(columns) {}

    SweepAxis read() {
        const std::size_t equals = text_.find('=');
        if (equals == std::string::npos || equals == 0)
            refuse(0, fmt::format("\"{}\" varies nothing; {}", text_, right_form));
        axis_.place = place_;
        read_keys(text_.substr(0, equals));
        start_ = equals + 1;
        if (!read_range()) read_list();
        return std::move(axis_);
    }

  private:
    [[noreturn]] void refuse(std::size_t at, const std::string& what) const {
        throw InputError(columns_ ? fmt::format("{}:{}: {}", place_, at + 1, what)
                                  : fmt::format("{}: {}", place_, what));
    }

    void read_keys(const std::string& text) {
        std::size_t at = 0;
        for (const std::string_view key : split(text, '+')) {
            if (key.empty())
                refuse(at, fmt::format("a key is missing in \"{}\"; {}", text, right_form));
            if (key == "seed") {
                refuse(at, "seeds have an option of their own; write --seeds 10 or --seeds 1:10");
            }
            if (key.starts_with("sweep."))
                refuse(at, fmt::format("{} cannot be varied by a sweep itself", key));
            axis_.keys.emplace_back(key);
            at += key.size() + 1;
        }
    }

    void add(std::string value, std::size_t at) {
        axis_.values.push_back(
            {axis_.keys.front(), std::move(value), place_, columns_ ? at + 1 : 0});
    }

    /// LOW:HIGH:COUNT; false where the values are something else.
    bool read_range() {
        const std::string_view values = std::string_view(text_).substr(start_);
        const auto parts = split(values, ':');
        if (parts.size() < 2) return false;
        const auto low = number_in<double>(parts[0]);
        const auto high = number_in<double>(parts[1]);
        if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high)) return false;
        const auto count =
            parts.size() == 3 ? number_in<std::int64_t>(parts[2]) : std::optional<std::int64_t>{};
        if (!count || *count < 1 || *count > most_runs) {
            refuse(start_,
                   fmt::format("\"{}\" is not a range; low:high:count takes a count of 1 … {},"
                               " for example 0:1:11",
                               values, most_runs));
        }
        if (*count == 1 && *low != *high) {
            refuse(start_, fmt::format("\"{}\" has two ends but one value; both ends belong to a "
                                       "range, so its count is 2 or more",
                                       values));
        }
        for (std::int64_t k = 0; k < *count; ++k)
            add(fmt::format("{}", evenly_spaced(*low, *high, *count, k)), start_);
        return true;
    }

    void read_list() {
        std::size_t item = start_;
        std::size_t depth = 0;
        char quote = '\0';
        for (std::size_t at = start_; at <= text_.size(); ++at) {
            const char letter = at < text_.size() ? text_[at] : ',';
            if (quote != '\0') {
                if (at == text_.size()) break;
                if (letter == '\\' && quote == '"') ++at;
                if (letter == quote) quote = '\0';
            } else if ((letter == '"' || letter == '\'') && only_blanks(item, at, depth)) {
                quote = letter;
            } else if (letter == '[' && (depth > 0 || only_blanks(item, at, depth))) {
                ++depth;
            } else if (letter == ']' && depth > 0) {
                --depth;
            } else if (letter == ',' && (depth == 0 || at == text_.size())) {
                if (depth > 0) refuse(item, "a bracket is not closed");
                add_item(item, at);
                item = at + 1;
            }
        }
        if (quote != '\0') refuse(item, "a quote is not closed");
    }

    /// Whether a value begins here: a quote or bracket inside a word is part of the word, but
    /// inside brackets every quote counts.
    [[nodiscard]] bool only_blanks(std::size_t from, std::size_t to, std::size_t depth) const {
        return depth > 0 || text_.find_first_not_of(' ', from) >= to;
    }

    void add_item(std::size_t from, std::size_t to) {
        while (from < to && text_[from] == ' ') ++from;
        std::size_t end = to;
        while (end > from && text_[end - 1] == ' ') --end;
        if (from == end) {
            refuse(from,
                   fmt::format("a value of {} is missing; {}", axis_.keys.front(), right_form));
        }
        add(text_.substr(from, end - from), from);
    }

    const std::string& text_;
    const std::string& place_;
    bool columns_;
    SweepAxis axis_;
    std::size_t start_ = 0;  ///< of the values
};

}  // namespace

SweepAxis read_axis(const std::string& text, const std::string& place, bool columns) {
    return AxisReader(text, place, columns).read();
}

SeedRange read_seeds(const std::string& text, std::int64_t scene_seed) {
    const auto parts = split(text, ':');
    const auto first = number_in<std::int64_t>(parts.front());
    const auto last = number_in<std::int64_t>(parts.back());
    const bool range = parts.size() == 2;
    if (parts.size() > 2 || !first || !last || *first < (range ? 0 : 1) || *last < *first) {
        throw InputError(
            fmt::format("--seeds is \"{}\"; it takes how many (10) or first:last (1:10)", text));
    }
    const std::int64_t count = range ? *last - *first : *first - 1;
    const std::int64_t start = range ? *first : scene_seed;
    if (count >= most_runs || start > std::numeric_limits<std::int64_t>::max() - count) {
        throw InputError(
            fmt::format("--seeds {} are too many; a sweep has at most {} runs", text, most_runs));
    }
    return {start, start + count};
}

}  // namespace fumon
