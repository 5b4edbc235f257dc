#include "figure/plot/coordinate_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figure/words/words.h"
#include "files/crs_kind.h"

namespace fumon {

namespace {

constexpr double metres_per_foot = 0.3048;
constexpr double foot_tolerance_ratio = 1e-4;

}  // namespace

CoordinateScale::CoordinateScale(const WorldScale& scale, Axis axis)
    : axis_(axis),
      unit_(scale.in_metres ? Unit::metres : Unit::sites),
      lies_somewhere_(scale.in_metres && scale.place.has_value()),
      begin_(0.0),
      per_length_(1.0) {
    if (!lies_somewhere_) return;
    const GeoReference& place = *scale.place;
    begin_ = axis == Axis::east ? place.west : place.south;
    per_length_ = axis == Axis::east ? place.dx / scale.dx : place.dy / scale.dy;
    if (place.degrees) {
        unit_ = Unit::degrees;
    } else if (std::abs(crs_kind(place.crs).metres / metres_per_foot - 1.0) <
               foot_tolerance_ratio) {
        unit_ = Unit::feet;
    }
}

double CoordinateScale::place_of(double coordinate) const {
    return (coordinate - begin_) / per_length_;
}

double CoordinateScale::coordinate_at(double place) const {
    return begin_ + place * per_length_;
}

CoordinateScale::Range CoordinateScale::range(double length) const {
    const bool east = axis_ == Axis::east;
    Range range{begin_, coordinate_at(length), east ? "x" : "y", "sites"};
    if (lies_somewhere_) range.name = east ? word("easting") : word("northing");
    constexpr double kilometre = 1000.0;
    constexpr double least_in_kilometres = 1e5;  // whose metres are long numbers
    if (unit_ == Unit::degrees) {
        range.name = east ? word("longitude") : word("latitude");
        range.unit = "°";
        constexpr double circle = 360.0;
        if (east && range.low > 0.5 * circle) {  // of 0 to 360
            range.low -= circle;
            range.high -= circle;
        }
    } else if (unit_ == Unit::feet) {
        range.unit = "ft";
    } else if (unit_ == Unit::metres &&
               (range.high - range.low >= kilometre ||
                std::max(std::abs(range.low), std::abs(range.high)) >= least_in_kilometres)) {
        range.low /= kilometre;
        range.high /= kilometre;
        range.unit = "km";
    } else if (unit_ == Unit::metres) {
        range.unit = "m";
    }
    return range;
}

Ticks CoordinateScale::ticks(double length, int most) const {
    const double end = coordinate_at(length);
    const RoundStep step = round_step(begin_, end, most);
    constexpr int thousand = 3;
    const bool in_kilometres =
        unit_ == Unit::metres &&
        (step.exponent >= thousand || (lies_somewhere_ && step.exponent >= thousand - 1));
    Ticks ticks;
    ticks.values = multiples(step.value(), begin_, end);
    for (const double value : ticks.values)
        ticks.labels.push_back(label(value, step, in_kilometres));
    return ticks;
}

std::string CoordinateScale::label(double coordinate, const RoundStep& step,
                                   bool in_kilometres) const {
    constexpr int thousand = 3;
    const int decimals = std::max(0, (in_kilometres ? thousand : 0) - step.exponent);
    const std::string towards = axis_ == Axis::east ? word("E") : word("N");
    if (unit_ == Unit::degrees) {
        const std::string from = axis_ == Axis::east ? word("W") : word("S");
        constexpr double circle = 360.0;
        double angle = coordinate;
        if (axis_ == Axis::east && angle > 0.5 * circle) angle -= circle;  // of 0 to 360
        const bool at_zero = std::abs(angle) < 0.25 * step.value();
        return fmt::format("{}°{}{}", plain_number(std::abs(angle), decimals), at_zero ? "" : " ",
                           at_zero       ? ""
                           : angle < 0.0 ? from
                                         : towards);
    }
    std::string number = plain_number(in_kilometres ? coordinate / 1000.0 : coordinate, decimals);
    if (unit_ == Unit::sites) return number;
    const char* const unit = unit_ == Unit::feet ? "ft" : in_kilometres ? "km" : "m";
    return lies_somewhere_ ? fmt::format("{} {} {}", number, unit, towards)
                           : fmt::format("{} {}", number, unit);
}

}  // namespace fumon
