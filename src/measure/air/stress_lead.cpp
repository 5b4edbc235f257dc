#include "measure/air/stress_lead.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "numerics/peak_offset.h"
#include "numerics/stress_fit.h"

namespace fumon {

namespace {

double highest_site(std::span<const double> curve) {
    const std::size_t n = curve.size();
    const auto top = static_cast<std::size_t>(std::ranges::max_element(curve) - curve.begin());
    return static_cast<double>(top) +
           peak_offset(curve[(top + n - 1) % n], curve[top], curve[(top + 1) % n]);
}

}  // namespace

StressLead stress_lead(std::span<const double> stress, const ProfileUnderAir& bed, double dx) {
    StressLead lead;
    if (bed.waves == 0 || stress.size() != bed.heights.size()) return lead;
    const StressFit fit = fit_stress(stress, bed.waves);
    const double turn = 2.0 * std::numbers::pi;
    const double radians = std::remainder(fit.phase - bed.phase, turn);
    lead.degrees = radians * 360.0 / turn;
    lead.length = radians / turn * bed.wavelength;
    lead.r_squared = fit.r_squared;
    lead.maximum_from_crest = bed.from_crest(highest_site(stress) * dx);
    return lead;
}

}  // namespace fumon
