#include "models/dunes/wind/windward_bubbles.h"

#include <algorithm>

#include "base/error.h"
#include "base/worker_pool.h"

namespace fumon {

WindwardBubbles::WindwardBubbles(const DuneGround& ground, double tangent, WorkerPool& pool)
    : tangent_(tangent), pool_(pool), against_(ground, pool) {}

const WindwardBubbles& WindwardBubbles::find(const FixedPointGrid& surface,
                                             const BlowingWind& wind) {
    against_.cast(surface, {-wind.x, -wind.y}, {tangent_, tangent_},
                  WindShadow::Find::shade_and_envelope);
    return *this;
}

void WindwardBubbles::fill(Grid& relief) const {
    pool_.for_ranges(relief.ny(), [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            std::ranges::transform(
                relief.row(y), against_.envelope().row(y), relief.row(y).begin(),
                [](double height, double bubble) { return std::max(height, bubble); });
        }
    });
}

void check_windward_bubbles(const DunesParameters& parameters) {
    if (parameters.windward_angle.is_word()) return;
    if (parameters.transport == DuneTransport::continuous &&
        parameters.speed_up == DuneSpeedUp::relief)
        return;
    throw KeyError(
        "model.windward_angle",
        "still air before slopes needs the shear stress over relief; write model.speed_up = "
        "\"relief\" and continuous transport, or model.windward_angle = \"none\"");
}

}  // namespace fumon
