#include "render/light/view_light.h"

namespace fumon {

Light light_of_view(const View& view) {
    const bool needed = view.look.ground == Ground::endless ||
                        view.sun.source == LightSource::moon || view.air.planet != Planet::earth;
    const bool atmosphere =
        view.look.sky == SkyModel::atmosphere || (view.look.sky == SkyModel::automatic && needed);
    if (view.look.sky == SkyModel::overcast && view.look.mode == ViewMode::scenic)
        return make_overcast_light(view.sun);
    if (!atmosphere || view.look.mode != ViewMode::scenic) return make_light(view.sun);
    return make_atmospheric_light(view.sun, view.air.planet);
}

}  // namespace fumon
