#include "render/light/view_light.h"

namespace fumon {

namespace {

bool asks_for_sky(const View& view) {
    return view.look.sky != SkyModel::automatic || view.sun.source == LightSource::moon ||
           !view.sun.place.empty() || view.air.planet != Planet::earth ||
           view.air.clouds != Clouds::none;
}

bool is_in_studio(const View& view) {
    if (view.look.mode != ViewMode::scenic || view.look.ground == Ground::endless) return false;
    if (view.look.light == LightKind::automatic) return !asks_for_sky(view);
    return view.look.light == LightKind::studio;
}

/// What clouds throw down beside their shadows, a share of the sunlight on level ground that grows
/// with their cover.
void add_light_from_clouds(Light& light, const AirSettings& air) {
    if (air.clouds == Clouds::none) return;
    const double most = air.clouds == Clouds::cumulus ? 0.25 : 0.10;
    light.sky += static_cast<float>(most * air.cloud_cover) * light.to_sun.z * light.sun;
}

}  // namespace

View with_chosen_light(View view) {
    view.look.light = is_in_studio(view) ? LightKind::studio : LightKind::sun;
    if (view.look.light == LightKind::studio) view.sun.diameter = studio_lamp_width;
    return view;
}

Light light_of_view(const View& view) {
    if (view.look.light == LightKind::studio) return make_studio_light(view.sun);
    const bool auto_0_2 = view.look.ground == Ground::endless ||
                          view.sun.source == LightSource::moon ||
                          view.air.planet != Planet::earth || view.air.clouds != Clouds::none;
    const bool atmosphere = view.look.sky == SkyModel::atmosphere ||
                            view.look.sky == SkyModel::automatic ||
                            (view.look.sky == SkyModel::automatic_0_2 && auto_0_2);
    if (view.look.sky == SkyModel::overcast && view.look.mode == ViewMode::scenic)
        return make_overcast_light(view.sun);
    if (!atmosphere || view.look.mode != ViewMode::scenic) return make_light(view.sun);
    Light light = make_atmospheric_light(view.sun, view.air.planet, cloud_kilometres(view.air),
                                         chosen_aerosol(view));
    add_light_from_clouds(light, view.air);
    return light;
}

Aerosol chosen_aerosol(const View& view) {
    if (view.air.planet != Planet::earth) return Aerosol::thin;
    if (view.air.aerosol != Aerosol::automatic) return view.air.aerosol;
    return view.look.ground == Ground::endless ? Aerosol::desert : Aerosol::thin;
}

double cloud_kilometres(const AirSettings& air) {
    constexpr double cumulus = 1.8;
    constexpr double cirrus = 8.5;
    if (!air.cloud_height.is_word()) return 1e-3 * air.cloud_height.value;
    return air.clouds == Clouds::cirrus ? cirrus : cumulus;
}

}  // namespace fumon
