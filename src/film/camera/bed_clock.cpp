#include "film/camera/bed_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "files/unit_conversion.h"
#include "film/camera/camera_path.h"
#include "film/script/moment.h"
#include "render/view/water.h"

namespace fumon {

namespace {

constexpr int sampled_cells_per_side = 256;  // cells along each side

/// Lambert's light on a cell, 0 … 1: on its water, where it has some.
double light_on(const Snapshot& snapshot, const Grid* depth, int x, int y, int stride) {
    const Grid& bed = snapshot.bed;
    const auto height = [&](int i, int j) {
        i = std::clamp(i, 0, bed.nx() - 1);
        j = std::clamp(j, 0, bed.ny() - 1);
        const double water = depth != nullptr ? (*depth)(i, j) : 0.0;
        return bed(i, j) * snapshot.scale.height_unit + water;
    };
    const double east =
        (height(x + stride, y) - height(x - stride, y)) / (2.0 * stride * snapshot.scale.dx);
    const double north =
        (height(x, y + stride) - height(x, y - stride)) / (2.0 * stride * snapshot.scale.dy);
    constexpr double level = 0.5;  // of the unit vector to the sun, west and north
    constexpr double up = 0.7071067811865476;
    return std::max(
        0.0, (level * east - level * north + up) / std::sqrt(1.0 + east * east + north * north));
}

/// How much of a cell water hides, 0 … 1.
double hidden_by(double depth, double closed) {
    return depth > 0.0 ? depth / (depth + closed) : 0.0;
}

double value_of(const StoredBed& bed, FilmClock clock) {
    return clock == FilmClock::step ? static_cast<double>(bed.step) : bed.time;
}

/// The number on the scale of a value between two stored ones.
double place_of(double value, const std::vector<double>& values,
                const std::vector<double>& places) {
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(values, value) - values.begin());
    if (after == 0) return places.front();
    if (after == values.size()) return places.back();
    const double share = (value - values[after - 1]) / (values[after] - values[after - 1]);
    return (1.0 - share) * places[after - 1] + share * places[after];
}

}  // namespace

std::size_t stride_over(std::size_t beds, const Film& film) {
    constexpr std::size_t enough = 40;  // beds
    return film.settings.draft ? std::max<std::size_t>(1, beds / enough) : 1;
}

double visible_change(const Snapshot& one, const Snapshot& other) {
    const int stride = std::max(1, std::max(one.bed.nx(), one.bed.ny()) / sampled_cells_per_side);
    constexpr double of_water = 0.5;  // of light, between ground and water over it
    const Grid* before = field_of(one.fields, "water_depth");
    const Grid* after = field_of(other.fields, "water_depth");
    if (before == nullptr || after == nullptr) before = after = nullptr;
    const double closed = closed_depth(one.scale);
    double sum = 0.0;
    std::size_t count = 0;
    for (int y = 0; y < one.bed.ny(); y += stride) {
        for (int x = 0; x < one.bed.nx(); x += stride, ++count) {
            sum += std::abs(light_on(one, before, x, y, stride) -
                            light_on(other, after, x, y, stride));
            if (before != nullptr)
                sum += of_water * std::abs(hidden_by((*before)(x, y), closed) -
                                           hidden_by((*after)(x, y), closed));
        }
    }
    return sum / static_cast<double>(count);
}

std::shared_ptr<const Snapshot> bed_as_seen(const StoredBeds& beds, std::size_t number) {
    return has_water(beds.first()) ? beds.snapshot(number) : beds.heights(number);
}

namespace {

/// Of a shot's clock, what all stored beds have and where a moment lies among them.
class ClockValues {
  public:
    ClockValues(const Film& film, std::size_t number, const StoredBeds& beds)
        : film_(film), number_(number), clock_(film.shots[number].clock), beds_(beds) {
        for (const StoredBed& bed : beds.beds()) {
            values_.push_back(value_of(bed, clock_));
            times_.push_back(bed.time);
        }
    }

    [[nodiscard]] const std::vector<double>& all() const { return values_; }

    /// Throws InputError, located, where it is not among them.
    [[nodiscard]] double of(const WordOrReal& end, const char* name) const {
        const bool steps = clock_ == FilmClock::step;
        if (!end.is_word()) {
            check(end.value, values_, name, fmt::format("{}", end.value),
                  steps ? "steps" : "times");
            return end.value;
        }
        if (end.word == "start") return values_.front();
        if (end.word == "end") return values_.back();
        const auto moment = written_moment(end.word);
        if (!moment) return values_.back();
        if (moment->unit == "%") {
            const double share = moment->number / 100.0;
            return (1.0 - share) * values_.front() + share * values_.back();
        }
        const std::string& unit = beds_.first().time_unit;
        const auto conversion = unit_conversion(moment->unit, unit);
        if (!conversion) {
            throw InputError(fmt::format(
                "{} = \"{}\": the run counts its time in {}; name a step, or a share (\"40 %\")",
                located(name), end.word, unit));
        }
        const double time = (*conversion)(moment->number);
        check(time, times_, name, fmt::format("\"{}\"", end.word), "times in " + unit);
        return steps ? place_of(time, times_, values_) : time;
    }

  private:
    [[nodiscard]] std::string located(const char* name) const {
        const std::string key = fmt::format("shot.{}.{}", number_, name);
        return film_.at(key) + key;
    }

    void check(double value, const std::vector<double>& among, const char* name,
               const std::string& written, const std::string& what) const {
        const double room = 1e-9 * std::max(1.0, among.back());
        if (value >= among.front() - room && value <= among.back() + room) return;
        throw InputError(fmt::format("{} = {}: the stored beds have {} {} to {}", located(name),
                                     written, what, among.front(), among.back()));
    }

    const Film& film_;
    std::size_t number_;
    FilmClock clock_;
    const StoredBeds& beds_;
    std::vector<double> values_;
    std::vector<double> times_;
};

}  // namespace

BedClock::BedClock(const Film& film, std::size_t number, const StoredBeds& beds) {
    const Shot& shot = film.shots[number];
    const ClockValues clock(film, number, beds);
    const std::vector<double>& values = clock.all();
    const double from = clock.of(shot.from, "from");
    const double to = clock.of(shot.to, "to");
    places_ = values;
    if (shot.pace == Pace::logarithmic) {
        // From 1 on, the first steps of a run that starts at 0, or before it, included.
        const double before = std::min(0.0, values.front());
        for (double& place : places_) place = elementary::log(1.0 + place - before);
        logarithmic_ = true;
    } else if (shot.pace == Pace::change) {
        const double low = std::min(from, to);
        const double high = std::max(from, to);
        double sum = 0.0;
        places_.front() = 0.0;
        const auto shown = static_cast<std::size_t>(std::ranges::count_if(
            values, [&](double value) { return value >= low && value <= high; }));
        const std::size_t stride = stride_over(shown, film);
        for (std::size_t i = 0; i + 1 < values.size();) {
            const std::size_t next = std::min(i + stride, values.size() - 1);
            const double before = sum;
            if (values[next] >= low && values[i] <= high)
                sum += visible_change(*bed_as_seen(beds, i), *bed_as_seen(beds, next));
            for (const std::size_t first = i; i < next;) {
                ++i;
                const double share =
                    static_cast<double>(i - first) / static_cast<double>(next - first);
                places_[i] = before + share * (sum - before) +
                             1e-12 * static_cast<double>(i);  // beds that are alike come in turn
            }
        }
    }
    begin_ = place_of(from, values, places_);
    end_ = place_of(to, values, places_);
    eased_ = shot.pace == Pace::eased;
    blends_ = film.settings.between == RecordsBetween::blend;
}

double BedClock::passed_to(double share) const {
    const double passed = eased_ ? eased(share) : std::clamp(share, 0.0, 1.0);
    return (1.0 - passed) * begin_ + passed * end_;
}

/// What changes evenly with the run's time between two beds.
double BedClock::value_at(double place) const {
    return logarithmic_ ? elementary::exp(place) : place;
}

RecordPlace BedClock::place_at(double share) const {
    const double place = passed_to(share);
    const auto after =
        static_cast<std::size_t>(std::ranges::lower_bound(places_, place) - places_.begin());
    const bool on_one = after == 0 || after == places_.size() || places_[after] == place;
    if (!blends_ || on_one) {
        const std::size_t bed = bed_at(share);
        return {bed, bed, 0.0};
    }
    const double from = value_at(places_[after - 1]);
    return {after - 1, after, (value_at(place) - from) / (value_at(places_[after]) - from)};
}

std::size_t BedClock::bed_at(double share) const {
    const double place = passed_to(share);
    const auto after =
        static_cast<std::size_t>(std::ranges::lower_bound(places_, place) - places_.begin());
    if (after == 0) return 0;
    if (after == places_.size()) return places_.size() - 1;
    return place - places_[after - 1] <= places_[after] - place ? after - 1 : after;
}

std::size_t BedClock::earliest() const {
    return std::min(place_at(0.0).bed, place_at(1.0).bed);
}

std::size_t BedClock::latest() const {
    return std::max(place_at(0.0).next, place_at(1.0).next);
}

}  // namespace fumon
