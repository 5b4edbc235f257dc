#include "files/udunits_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "base/find_named.h"

namespace fumon {

namespace {

using Symbol = std::pair<std::string_view, std::string_view>;

/// fumon's symbols and names, and UDUNITS' symbols.
constexpr std::array<Symbol, 21> symbols{{
    {"m", "m"},
    {"mm", "mm"},
    {"km", "km"},
    {"kg", "kg"},
    {"s", "s"},
    {"min", "min"},
    {"h", "h"},
    {"d", "d"},
    {"yr", "yr"},
    {"Pa", "Pa"},
    {"N", "N"},
    {"K", "K"},
    {"J", "J"},
    {"W", "W"},
    {"deg", "degree"},
    {"degree", "degree"},
    {"degrees", "degree"},
    {"seconds", "s"},
    {"minutes", "min"},
    {"hours", "h"},
    {"days", "d"},
}};

struct Factor {
    std::string_view symbol;
    int power;
};

/// Reads products and quotients: symbols with whole powers, "1", spaces, "/" and brackets.
class Reader {
  public:
    explicit Reader(std::string_view text) : left_(text) {}

    std::optional<std::vector<Factor>> factors() {
        if (!product(1) || !left_.empty()) return std::nullopt;
        return factors_;
    }

  private:
    bool take(char letter) {
        if (!left_.starts_with(letter)) return false;
        left_.remove_prefix(1);
        return true;
    }

    bool product(int sign) {
        if (!factor(sign)) return false;
        while (!left_.empty() && !left_.starts_with(')')) {
            if (take('/')) {
                if (!factor(-sign)) return false;
            } else if (!take(' ') || !factor(sign)) {
                return false;
            }
        }
        return true;
    }

    bool factor(int sign) {
        if (take('1')) return true;
        if (take('(')) return product(sign) && take(')');
        const auto* end = std::ranges::find_if(left_, [](char letter) {
            return (letter < 'a' || letter > 'z') && (letter < 'A' || letter > 'Z');
        });
        const auto* found = find_by(symbols, &Symbol::first, std::string_view(left_.begin(), end));
        if (found == nullptr) return false;
        left_.remove_prefix(found->first.size());
        int power = 1;
        if (take('^') || (!left_.empty() && left_.front() >= '0' && left_.front() <= '9')) {
            const auto [rest, fault] =
                std::from_chars(left_.data(), left_.data() + left_.size(), power);
            if (fault != std::errc()) return false;
            left_.remove_prefix(static_cast<std::size_t>(rest - left_.data()));
        }
        multiply(found->second, sign * power);
        return true;
    }

    void multiply(std::string_view symbol, int power) {
        const auto same = std::ranges::find(factors_, symbol, &Factor::symbol);
        if (same == factors_.end())
            factors_.push_back({symbol, power});
        else
            same->power += power;
    }

    std::string_view left_;
    std::vector<Factor> factors_;
};

}  // namespace

std::string udunits_unit(std::string_view unit, bool in_metres) {
    if (unit == "m or sites" || unit == "m, or sites") return in_metres ? "m" : "1";
    constexpr std::string_view per = "per ";
    std::string quotient;
    if (unit.starts_with(per)) quotient = fmt::format("1/({})", unit.substr(per.size()));
    const auto factors = Reader(quotient.empty() ? unit : quotient).factors();
    std::string text;
    for (const Factor& factor : factors.value_or(std::vector<Factor>{})) {
        if (factor.power == 0) continue;
        if (!text.empty()) text += ' ';
        text += factor.symbol;
        if (factor.power != 1) text += fmt::format("{}", factor.power);
    }
    return text.empty() ? "1" : text;
}

}  // namespace fumon
