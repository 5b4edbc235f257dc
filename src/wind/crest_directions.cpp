#include "wind/crest_directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/elementary.h"
#include "base/elementary_angle.h"
#include "base/units.h"
#include "wind/direction.h"

namespace fumon {

namespace {

constexpr int scan_steps_per_degree = 10;
constexpr double scan_step_degrees = 1.0 / scan_steps_per_degree;  // degrees
constexpr double same_direction = 1e-3;                            // degrees
constexpr double equally_good = 1e-6;                              // of the best, in relation to it
constexpr int bisections = 50;

double sine(double degrees) {
    return elementary::sin(degrees * degree);
}
double cosine(double degrees) {
    return elementary::cos(degrees * degree);
}

/// Where a function of the direction is largest between two directions about one maximum.
template <class Function>
double maximum_between(const Function& of, double low, double high) {
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < 2 * bisections; ++i) {
        const double span = golden * (high - low);
        if (of(high - span) < of(low + span)) {
            low = high - span;
        } else {
            high = low + span;
        }
    }
    return 0.5 * (low + high);
}

/// Where a function of the direction crosses 0 between two directions.
template <class Function>
double zero_between(const Function& of, double low, double high) {
    const bool low_is_negative = of(low) < 0.0;
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (low + high);
        ((of(middle) < 0.0) == low_is_negative ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// A direction from 0 up to `turn`.
double within(double direction, double turn) {
    direction = std::fmod(direction, turn);
    if (direction < 0.0) direction += turn;
    return direction > turn - same_direction ? 0.0 : direction;
}

struct Candidate {
    double direction = 0.0;
    double value = 0.0;
};

/// Those as good as the best, each once, in order.
std::vector<double> best_of(const std::vector<Candidate>& candidates) {
    double best = 0.0;
    for (const Candidate& one : candidates) best = std::max(best, one.value);
    std::vector<double> found;
    for (const Candidate& one : candidates) {
        if (one.value > 0.0 && one.value >= best * (1.0 - equally_good))
            found.push_back(one.direction);
    }
    std::ranges::sort(found);
    const auto same = [](double a, double b) { return std::abs(a - b) < same_direction; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

/// The directions from 0 up to 180 in which a function that turns in 180 degrees is largest.
template <class Function>
std::vector<double> maxima(const Function& of) {
    constexpr auto count = static_cast<std::size_t>(half_turn) * scan_steps_per_degree;
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = of(scan_step_degrees * static_cast<double>(i));
    const auto [lowest, highest] = std::ranges::minmax(values);
    if (highest - lowest <= equally_good * highest) return {};
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < count; ++i) {
        const double before = values[(i + count - 1) % count];
        const double after = values[(i + 1) % count];
        if (values[i] < before || values[i] < after) continue;
        const double at = scan_step_degrees * static_cast<double>(i);
        const double found = maximum_between(of, at - scan_step_degrees, at + scan_step_degrees);
        candidates.push_back({within(found, half_turn), of(found)});
    }
    return best_of(candidates);
}

std::vector<double> fingers(std::span<const SandFlux> fluxes, double flux_ratio) {
    const auto over_crest = [&](double along, auto part) {
        double sum = 0.0;
        for (const SandFlux& flux : fluxes) {
            const double angle = flux.toward - along;
            sum += flux.amount * (1.0 + flux_ratio * std::abs(sine(angle))) * part(angle);
        }
        return sum;
    };
    const auto across = [&](double along) { return over_crest(along, sine); };
    const double potential = drift_of(fluxes).potential;
    std::vector<Candidate> candidates;
    constexpr int count = static_cast<int>(full_turn) * scan_steps_per_degree;
    // Off the round numbers, on which the tables of people have their zeros.
    constexpr double first = scan_step_degrees / 3.0;
    for (int i = 0; i < count; ++i) {
        const double low = first + scan_step_degrees * i;
        const double high = low + scan_step_degrees;
        if ((across(low) < 0.0) == (across(high) < 0.0)) continue;
        const double found = zero_between(across, low, high);
        const double along = over_crest(found, cosine);
        if (along > equally_good * potential)
            candidates.push_back({within(found, full_turn), along});
    }
    return best_of(candidates);
}

}  // namespace

Drift drift_of(std::span<const SandFlux> fluxes) {
    Drift drift;
    double north = 0.0;
    double east = 0.0;
    for (const SandFlux& flux : fluxes) {
        drift.potential += flux.amount;
        north += flux.amount * cosine(flux.toward);
        east += flux.amount * sine(flux.toward);
    }
    drift.resultant = elementary::hypot(north, east);
    constexpr double rounding = 1e-12;
    if (drift.resultant <= rounding * drift.potential) {
        drift.resultant = 0.0;
        drift.toward = std::numeric_limits<double>::quiet_NaN();
    } else {
        drift.toward = within(elementary::atan2(east, north) * degrees_per_radian, full_turn);
    }
    return drift;
}

CrestDirections crest_directions(std::span<const SandFlux> fluxes, double flux_ratio) {
    const auto growth = [&](double ratio) {
        return maxima([&, ratio](double along) {
            double sum = 0.0;
            for (const SandFlux& flux : fluxes) {
                const double across = std::abs(sine(flux.toward - along));
                sum += flux.amount * (across + ratio * across * across);
            }
            return sum;
        });
    };
    return {growth(0.0), growth(flux_ratio), fingers(fluxes, flux_ratio)};
}

}  // namespace fumon
