#include "render/light/haze.h"

#include <algorithm>

#include "render/light/view_light.h"
#include "render/sky/desert_aerosol.h"

namespace fumon {

namespace {

/// Km, where the view does not say. Landscapes of many kilometres are looked at on clear days.
double usual_visibility(const View& view, const Block& block) {
    const double least = block.tiles.plain ? 8.0 * block.kilometres : 0.0;
    if (chosen_aerosol(view) == Aerosol::desert)
        return std::max(desert_aerosol::visibility(view.sun.dust), least);
    return std::max(40.0, least) * std::min(1.0, 2.0 / std::max(view.sun.dust, 1e-3));
}

}  // namespace

Haze haze_of(const View& view, const Block& block) {
    const double visibility =
        view.air.visibility.is_word() ? usual_visibility(view, block) : view.air.visibility.value;
    Haze haze;
    haze.per_kilometre = desert_aerosol::extinction_of_visibility(visibility);
    if (chosen_aerosol(view) == Aerosol::desert) {
        const glm::dvec3 found = desert_aerosol::extinction(visibility, view.sun.dust);
        haze.bands = found / found.g;
        haze.height = desert_aerosol::height;
    }
    return haze;
}

double extinction_from(const glm::dvec3& eye, const Haze& haze, const View& view,
                       const Block& block) {
    const double near_ground = haze.per_kilometre * block.kilometres;
    if (chosen_aerosol(view) != Aerosol::desert) return near_ground;
    return near_ground * desert_aerosol::thinner_from((eye.z - block.surface) * block.kilometres);
}

}  // namespace fumon
