#include "render/renderer_state.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "gl/functions.h"
#include "render/frame/clouds.h"
#include "render/frame/view_uniforms.h"
#include "render/land/land_cover.h"
#include "render/light/view_light.h"
#include "render/view/display_bed.h"
#include "render/view/repeated_bed.h"

namespace fumon {

namespace {

const gl::TextureLayout sky_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};

gl::Constants constants_of(const FrameSetting& setting, const Light& light) {
    gl::Constants fixed = fixed_uniforms(setting.view, light, setting.ground, setting.kind);
    fixed.push_back({"visibility_in_buffer", setting.rasterises_in_buffer() ? 1.0F : 0.0F});
    return fixed;
}

}  // namespace

RendererState::RendererState(gl::Context& context_, const View& view_, const Snapshot& first_,
                             std::int64_t last_step_, WorkerPool& pool_, const RenderLimits& limits,
                             PixelFormat kind_)
    : FrameSetting(view_, first_, last_step_, limits, kind_, pool_),
      context(context_),
      pool(pool_),
      light(light_of_view(view)),
      atmosphere(light.atmosphere),
      light_before(light),
      sun_before(view.sun),
      fixed(constants_of(*this, light)),
      sky(light.sky_columns, light.sky_rows, sky_layout, light.sky_texels.data()),
      targets({plan, kind, view.look.ground, shades_water_by_pixel(view, first),
               shades_single_surface_pixels()}),
      shading(view, ground, first_ground(), display_bed(first_ground(), ground, refinement),
              samples_across(), fixed, mipmaps, kind,
              {block.width_x / ground.width_x, block.width_y / ground.width_y}),
      terrain(view, block, fixed, shades_water_by_pixel(view, first)),
      background(view, block, light, floor(pool), fixed, wanted, !limits.one_picture),
      one_picture(limits.one_picture) {
    if (shades_water_by_pixel(view, first))
        water_block.emplace(plan, fixed, kind, limits.pixels_alike);
    if (view.look.cover != LandCover::bare) {
        const WordOrReal& snow = view.look.snow_line;
        shading.cover(rolled(
            land_cover(first_ground(), snow.is_word() ? std::nullopt : std::optional(snow.value)),
            origin.east, origin.north));
    }
    if (plain && view.look.survey_edge == SurveyEdge::fade)
        shading.pale(plain->invented_share(first));
    if (plain) plain->stand_in(view.camera, *first_in_plain, block);
    if (endless())
        world.emplace(view, ground, first_ground(), refinement, origin, copies, fixed, mipmaps,
                      rasterises_in_buffer());
    if (first.section)
        air.emplace(block, camera_at(0),
                    static_cast<int>(std::max(view.image.width, view.image.height)), fixed,
                    mipmaps);
    if (draws_plants(view, first)) plants.emplace(view, ground, fixed);
    if (!view.persons.empty()) persons.emplace(view, block, first, fixed);
    if (!view.tracks.empty()) tracks.emplace(view, block, first, fixed);
    if (world && view.streamers.strength > 0.0)
        streamers.emplace(view, block, plan.tiles.front().width, plan.tiles.front().height);
    // From now on of the first snapshot only its bed is compared with, and a field that is
    // coloured.
    for (SnapshotField& field : first.fields) {
        const bool of_water = field.name == "water_depth" || field.name.starts_with("velocity_");
        if (of_water && field.name != view.look.field) field.values = {};
    }
    gl::check_errors("the renderer's setup");
}

void RendererState::set_light(const FramePose& pose) {
    if (pose.sun.azimuth != view.sun.azimuth || pose.sun.elevation != view.sun.elevation) {
        const bool again =
            pose.sun.azimuth == sun_before.azimuth && pose.sun.elevation == sun_before.elevation;
        std::swap(light, light_before);
        sun_before = view.sun;
        view.sun.azimuth = pose.sun.azimuth;
        view.sun.elevation = pose.sun.elevation;
        if (!again) light = light_of_view(view);
        sky.upload(light.sky_texels.data());
        background.set_floor(floor(pool));
    }
    light.stops = pose.exposure;
    light.cloud_shift = cloud_shift(view.air, pose.share);
    background.forget();
}

GroundTransform RendererState::ground_transform(const Camera& camera) const {
    if (world)
        return {world->clip_from_eye(camera),  true, world->curvature(), origin.position, copies,
                world->eye_from_middle(camera)};
    return {glm::mat4(clip_matrix(camera)), false, 0.0F, glm::dvec2(0.0), {}, glm::dvec2(0.0)};
}

bool RendererState::drawn_by_block_passes(const Camera& camera) const {
    const bool alone = !world && !air && !plants && !persons && !tracks && !terrain.has_rim();
    const bool by_pixels = kind == PixelFormat::display_8 && view.look.mode == ViewMode::scenic &&
                           view.camera.projection != Projection::map && plan.factor == 2 && alone;
    if (water)
        return by_pixels && water_block &&
               (camera.perspective || terrain.needs_no_clipping(camera));
    return by_pixels && !shading.has_mipmaps() && terrain.needs_no_clipping(camera);
}

Field<float> RendererState::drawn_surface(const ReadyPicture& picture) const {
    if (world)
        return rolled(picture.lit->heights->finest(), -refinement * origin.east,
                      -refinement * origin.north);
    const LitBed& lit = *picture.lit;
    return lit.water ? surface_of(lit.bed, *lit.water, picture.shown()) : lit.bed.z;
}

Field<float> RendererState::drawn_depth(const DisplayWater& standing, const Snapshot& shown) const {
    const auto rise = static_cast<float>(block.height_scale / shown.scale.height_unit);
    Field<float> depth = standing.depth;
    for (float& metres : depth.values()) metres = rise * std::max(metres, 0.0F);
    return depth;
}

Field<float> RendererState::surface_of(const DisplayBed& bed, const DisplayWater& standing,
                                       const Snapshot& shown) const {
    Field<float> surface = drawn_depth(standing, shown);
    for (std::size_t i = 0; i < surface.size(); ++i) surface.values()[i] += bed.z.values()[i];
    return surface;
}

}  // namespace fumon
