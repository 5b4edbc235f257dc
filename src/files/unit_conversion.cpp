#include "files/unit_conversion.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

#include "base/data_files.h"
#include "base/error.h"
#include "base/find_named.h"

namespace fumon {

namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

std::string_view without_outer_spaces(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// Lower case, with one space for what GDAL, PROJ and Esri put between words.
std::string plain_name(std::string_view unit) {
    std::string name;
    for (const char c : lower_case(unit)) {
        const bool between = c == ' ' || c == '_' || c == '-' || c == '(' || c == ')';
        if (!between) {
            name += c;
        } else if (!name.empty() && name.back() != ' ') {
            name += ' ';
        }
    }
    return std::string(without_outer_spaces(name));
}

/// Lengths that UDUNITS does not know, by the names of EPSG, PROJ, GDAL and Esri; in metres, as a
/// quotient where the definition is one. Source: EPSG registry, units of measure 9001 to 9098.
struct NamedLength {
    std::string_view name;
    double metres;
};

constexpr double us_foot = 12.0 / 39.37;
constexpr double clarke_foot = 0.3047972654;
constexpr double indian_foot = 0.3047995102481469;  // 12 / 39.370142
constexpr double sears_foot = 12.0 / 39.370147;

constexpr std::array<NamedLength, 55> named_lengths{{
    {"us survey foot", us_foot},
    {"us survey feet", us_foot},
    {"foot us", us_foot},
    {"feet us", us_foot},
    {"us foot", us_foot},
    {"us feet", us_foot},
    {"ftus", us_foot},
    {"us ft", us_foot},
    {"usft", us_foot},
    {"ft us", us_foot},
    {"survey foot", us_foot},
    {"survey feet", us_foot},
    {"us survey ft", us_foot},
    {"us survey foot depth", us_foot},
    {"foot intl", 0.3048},
    {"foot international", 0.3048},
    {"feet international", 0.3048},
    {"intl foot", 0.3048},
    {"international feet", 0.3048},
    {"foot clarke", clarke_foot},
    {"clarke's foot", clarke_foot},
    {"foot indian", indian_foot},
    {"indian foot", indian_foot},
    {"ind ft", indian_foot},
    {"ind yd", 3.0 * indian_foot},
    {"foot gold coast", 6378300.0 / 20926201.0},
    {"foot sears", sears_foot},
    {"british foot sears 1922", sears_foot},
    {"british foot 1936", 0.3048007491},
    {"gold coast foot", 6378300.0 / 20926201.0},
    {"us survey inch", 100.0 / 3937.0},
    {"us in", 100.0 / 3937.0},
    {"us survey yard", 3.0 * us_foot},
    {"us yd", 3.0 * us_foot},
    {"us survey chain", 66.0 * us_foot},
    {"us ch", 66.0 * us_foot},
    {"us survey link", 0.66 * us_foot},
    {"us survey mile", 5280.0 * us_foot},
    {"us mi", 5280.0 * us_foot},
    {"chain", 20.1168},
    {"chains", 20.1168},
    {"ch", 20.1168},
    {"link", 0.201168},
    {"links", 0.201168},
    {"fathom", 1.8288},
    {"fathoms", 1.8288},
    {"fath", 1.8288},
    {"statute mile", 1609.344},
    {"mi", 1609.344},
    {"nautical mile", 1852.0},
    {"nautical miles", 1852.0},
    {"kmi", 1852.0},
    {"chain sears", 66.0 * sears_foot},
    {"yard sears", 3.0 * sears_foot},
    {"german legal metre", 1.0000135965},
}};

struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// UDUNITS' database. Its parser keeps state of its own, so that whoever parses holds `mutex`.
class Units {
  public:
    static Units& all() {
        static Units units;
        return units;
    }

    Unit parse(std::string_view text) {
        return Unit(ut_parse(system_, std::string(text).c_str(), UT_UTF8));
    }

    std::mutex mutex;

  private:
    Units() {
        ut_set_error_message_handler(ut_ignore);
        system_ = ut_read_xml(nullptr);
        if (system_ != nullptr) return;
        // The units travel with an archive, whose system may have none.
        if (const auto beside = find_data_file("udunits/udunits2.xml"))
            system_ = ut_read_xml(beside->c_str());
        if (system_ != nullptr) return;
        throw Error(
            "the units of UDUNITS-2 cannot be read; install libudunits2-data, or name the file "
            "udunits2.xml by UDUNITS2_XML_PATH");
    }

    ut_system* system_ = nullptr;  ///< for as long as the program runs
};

/// Whether a quotient is a pure number: reciprocals, which UDUNITS would convert, have none.
bool same_kind(const ut_unit* one, const ut_unit* other) {
    const Unit quotient(ut_divide(one, other));
    return quotient != nullptr && ut_is_dimensionless(quotient.get()) != 0;
}

struct FreeConverter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};

/// The decimal number that a product of decimal numbers stands for: 0.3048, not 12 × 2.54 × 0.01 as
/// it is rounded.
double decimal(double value) {
    const std::string text = fmt::format("{:.12g}", value);
    double result = value;
    std::from_chars(text.data(), text.data() + text.size(), result);
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(value);
    return std::abs(result - value) <= rounding ? result : value;
}

std::optional<UnitConversion> between(ut_unit* from, ut_unit* to) {
    if (from == nullptr || to == nullptr || !same_kind(from, to)) return std::nullopt;
    const std::unique_ptr<cv_converter, FreeConverter> converter(ut_get_converter(from, to));
    if (converter == nullptr) return std::nullopt;
    const double zero = cv_convert_double(converter.get(), 0.0);
    const double one = cv_convert_double(converter.get(), 1.0);
    const double half = cv_convert_double(converter.get(), 0.5);
    const bool is_linear = std::abs(0.5 * (zero + one) - half) <= 1e-9 * std::abs(one - zero);
    if (!std::isfinite(zero) || !std::isfinite(one) || one == zero || !is_linear)
        return std::nullopt;  // decibels, say
    return UnitConversion{decimal(one - zero), zero};
}

}  // namespace

std::optional<UnitConversion> unit_conversion(std::string_view from, std::string_view to) {
    const std::string_view written = without_outer_spaces(from);
    if (written.empty()) return std::nullopt;
    const std::string plain = plain_name(written);
    Units& units = Units::all();
    const std::lock_guard lock(units.mutex);
    const Unit wanted = units.parse(to);
    if (wanted == nullptr) throw Error(fmt::format("\"{}\" is not a unit of UDUNITS", to));
    if (const NamedLength* named = find_named(named_lengths, plain)) {
        const Unit metre = units.parse("m");
        auto conversion = between(metre.get(), wanted.get());
        if (conversion) conversion->factor *= named->metres;
        return conversion;
    }
    if (auto conversion = between(units.parse(written).get(), wanted.get())) return conversion;
    return between(units.parse(lower_case(written)).get(), wanted.get());
}

std::optional<UnitConversion> water_conversion(std::string_view from, std::string_view to) {
    if (auto conversion = unit_conversion(from, to)) return conversion;
    return unit_conversion(from, fmt::format("1000 kg m-3 {}", to));
}

std::optional<double> metres_per_unit(std::string_view unit) {
    const auto conversion = unit_conversion(unit, "m");
    if (!conversion || conversion->offset != 0.0 || !(conversion->factor > 0.0))
        return std::nullopt;
    return conversion->factor;
}

std::optional<double> metres_per_height(std::string_view unit) {
    unit = without_outer_spaces(unit);
    if (unit.empty() || unit == "1") return 1.0;
    if (const auto metres = metres_per_unit(unit)) return metres;
    std::size_t end = unit.size();
    for (const char* begin : {" above ", " below ", " (", " a.s.l", " asl", " amsl", ", "})
        end = std::min(end, unit.find(begin));
    return end == unit.size() ? std::nullopt : metres_per_unit(unit.substr(0, end));
}

bool is_degrees(std::string_view unit) {
    const std::string lower = lower_case(without_outer_spaces(unit));
    return lower.starts_with("degree") || lower == "deg" || lower == "°" || lower == "arc_degree" ||
           lower == "arcdeg";
}

}  // namespace fumon
