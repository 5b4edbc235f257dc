#include "render/frame/clouds.h"

#include <algorithm>
#include <numbers>

#include "base/elementary.h"
#include "render/light/view_light.h"

namespace fumon {

namespace {

/// Where the wind at the clouds' height blows to.
glm::dvec2 wind_direction(const AirSettings& air) {
    const double from = air.cloud_wind * std::numbers::pi / 180.0;
    return {-elementary::sin(from), -elementary::cos(from)};
}

/// The value that a share of a normal distribution lies above, in standard deviations (the logistic
/// distribution of Bowling et al. 2009, within 0.03 between 2 and 98 %).
double exceeded_by(double share) {
    constexpr double steepness = 1.702;
    const double kept = std::clamp(share, 0.002, 0.998);
    return elementary::log((1.0 - kept) / kept) / steepness;
}

}  // namespace

float cloud_number(const View& view, const Light& light) {
    if (view.look.mode != ViewMode::scenic || !light.atmosphere) return 0.0F;
    return view.air.clouds == Clouds::cumulus  ? 1.0F
           : view.air.clouds == Clouds::cirrus ? 2.0F
                                               : 0.0F;
}

glm::vec2 cloud_shift(const AirSettings& air, double share_of_run) {
    return glm::vec2(wind_direction(air) * (air.cloud_drift * share_of_run));
}

void set_clouds(const gl::Program& program, const View& view, const Light& light,
                const Camera& camera, const Block& block) {
    if (cloud_number(view, light) == 0.0F) return;
    constexpr double deviation = 0.31;  // of the noise
    program.set("cloud_threshold",
                static_cast<float>(deviation * exceeded_by(view.air.cloud_cover)));
    program.set("cloud_base", static_cast<float>(cloud_kilometres(view.air)));
    program.set("cloud_eye", glm::vec2(block.kilometres * glm::dvec2(camera.eye)));
    program.set("kilometres", static_cast<float>(block.kilometres));
    program.set("cloud_shift", light.cloud_shift);
    program.set("cloud_wind", glm::vec2(wind_direction(view.air)));
    program.set("cloud_seed", static_cast<int>(view.air.cloud_seed));
}

}  // namespace fumon
