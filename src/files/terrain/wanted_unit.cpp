#include "files/terrain/wanted_unit.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

namespace fumon {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// A product of powers: "s/m^(1/3)" is s to 1 and m to −1/3. Nothing for what is none.
class Powers {
  public:
    explicit Powers(std::string_view text) : text_(text) {}

    std::optional<std::map<std::string, double>> read() {
        double side = 1.0;  // −1 behind a stroke
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == ' ' || c == '*' || c == '.') {
                ++at_;
            } else if (c == '/') {
                side = -1.0;
                ++at_;
            } else if (is_letter(c)) {
                std::string base;
                while (at_ < text_.size() && is_letter(text_[at_])) base += text_[at_++];
                powers_[base] += side * exponent();
                side = 1.0;
            } else {
                return std::nullopt;
            }
        }
        return powers_;
    }

  private:
    void skip(std::string_view any) {
        while (at_ < text_.size() && any.find(text_[at_]) != std::string_view::npos) ++at_;
    }

    double number() {
        double value = 0.0;
        const auto [end, fault] =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (fault != std::errc{}) return 1.0;
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }

    double exponent() {
        skip("^*({");
        const bool has_one =
            at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '-' || text_[at_] == '.');
        if (!has_one) return 1.0;
        double value = number();
        if (at_ + 1 < text_.size() && text_[at_] == '/' && is_digit(text_[at_ + 1])) {
            ++at_;
            value /= number();
        }
        skip(")}");
        return value;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::map<std::string, double> powers_;
};

bool same_powers(std::string_view one, std::string_view other) {
    constexpr double as_rounded = 0.005;  // of 0.33 for 1/3
    const auto a = Powers(one).read();
    const auto b = Powers(other).read();
    if (!a || !b || a->size() != b->size()) return false;
    for (const auto& [base, exponent] : *a) {
        const auto found = b->find(base);
        if (found == b->end() || !(std::abs(found->second - exponent) < as_rounded)) return false;
    }
    return true;
}

}  // namespace

std::optional<UnitConversion> conversion_for(const TerrainQuery& query,
                                             std::string_view file_unit) {
    if (!query.any_unit) {
        const auto metres =
            metres_per_height(query.height_unit.empty() ? file_unit : query.height_unit);
        return metres ? std::optional(UnitConversion{*metres}) : std::nullopt;
    }
    const std::string& wanted = query.wanted_unit;
    if (wanted.empty() || file_unit.empty() || file_unit == wanted) return UnitConversion{};
    const bool has_fraction = wanted.find("^(") != std::string::npos;
    if (!has_fraction) return water_conversion(file_unit, wanted);
    if (file_unit == "1" || same_powers(file_unit, wanted)) return UnitConversion{};
    return std::nullopt;
}

std::string wanted_units(const TerrainQuery& query, std::string_view remedy) {
    if (!query.any_unit) return fmt::format("heights are in a unit of length (\"m\"); {}", remedy);
    if (query.wanted_unit == "1")
        return fmt::format("this quantity is a pure number (\"1\"); {}", remedy);
    return fmt::format("this quantity is in {}, or in a unit that converts to it; {}",
                       query.wanted_unit, remedy);
}

std::string conversion_note(const TerrainQuery& query, std::string_view file_unit,
                            const UnitConversion& conversion) {
    if (conversion.factor == 1.0 && conversion.offset == 0.0) return {};
    if (query.any_unit) return fmt::format("converted to {} from {}", query.wanted_unit, file_unit);
    if (!query.height_unit.empty())
        return fmt::format("heights converted to metres from {} (bed.height_unit)",
                           query.height_unit);
    return fmt::format("heights converted to metres from {}", file_unit);
}

bool grows_downward(const std::string& positive, const std::string& standard_name) {
    if (!positive.empty()) return positive == "down" || positive == "Down" || positive == "DOWN";
    return standard_name == "depth" || standard_name == "sea_floor_depth" ||
           standard_name.find("depth_below") != std::string::npos;
}

}  // namespace fumon
