#include "measure/bed/crest_theory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "wind/direction.h"
#include "wind/run_drift.h"

namespace fumon {

namespace {

/// Of directions that are equally favoured the one nearest to a line; NaN for none.
double nearest_to(const std::vector<double>& directions, double line) {
    double found = std::numeric_limits<double>::quiet_NaN();
    double least = full_turn;
    for (const double direction : directions) {
        const double apart = std::abs(std::fmod(direction - line, half_turn));
        const double angle = std::min(apart, half_turn - apart);
        if (angle >= least) continue;
        found = direction;
        least = angle;
    }
    return found;
}

}  // namespace

CrestTheory crest_theory(const CrestOrientation& crests, const CrestDirections& predicted) {
    CrestTheory theory;
    if (std::isnan(crests.degrees)) return theory;
    theory.measured = std::fmod(half_turn - crests.degrees, half_turn);
    theory.gross_normal_transport = nearest_to(predicted.gross_normal_transport, theory.measured);
    theory.bed_instability = nearest_to(predicted.bed_instability, theory.measured);
    theory.fingering = nearest_to(predicted.fingering, theory.measured);
    return theory;
}

CrestDirections predicted_crests(const Snapshot& snapshot, double flux_ratio) {
    return crest_directions(fluxes_of(snapshot.winds), flux_ratio);
}

}  // namespace fumon
