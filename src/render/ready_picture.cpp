#include "render/ready_picture.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "base/snapshot_lookup.h"
#include "render/light/lighting.h"
#include "render/light/sky_visibility.h"
#include "render/renderer_state.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"
#include "render/view/visible_sun.h"

namespace fumon {

namespace {

/// A bed up to the surface of its water, which is what light falls on and what is seen.
Snapshot with_water_level(Snapshot ground) {
    const Field<float> depth = water_depths(ground);
    for (std::size_t i = 0; i < depth.size(); ++i)
        ground.bed.values()[i] += static_cast<double>(depth.values()[i]) / ground.scale.height_unit;
    return ground;
}

}  // namespace

std::shared_ptr<const LitBed> RendererState::lit_bed(const ReadyPicture& picture,
                                                     const SunDirection& sun,
                                                     WorkerPool& with) const {
    const Snapshot& shown = picture.shown();
    auto lit = std::make_shared<LitBed>();
    lit->snapshot = picture.snapshot;
    lit->sun = sun;
    if (world) {
        if (plain) {
            const std::string& coloured = view.look.field;
            lit->in_plain = plain->is_drained()
                                ? plain->around(shown, with, coloured)
                                : SurroundingPlain(shown, with, known_sea(view, shown))
                                      .around(shown, with, coloured);
        }
        if (plain && water) {
            lit->water_tile = plain->own_tile(*lit->in_plain);
            lit->water_tile->rain = plain->rain_over_tile(shown);
        }
        const Block framed = plain ? plain->ground_of(picture.framed) : picture.framed;
        if (water) lit->water = display_water(plain ? *lit->water_tile : shown, refinement, with);
        const Snapshot& ground = plain ? *lit->in_plain : shown;
        lit->light = repeated_light(water ? with_water_level(ground) : ground, framed, refinement,
                                    origin, sun, prevailing_direction(shown), with);
        if (view.streamers.strength > 0.0)
            lit->blown = blown_sand(shown, view, picture.framed, sun);
        lit->heights = std::make_shared<const HeightPyramid>(std::move(lit->light.z), framed.tiles,
                                                             lit->light.walls);
    } else {
        lit->bed = display_bed(shown, picture.framed, refinement);
        if (!water) {
            lit->texels = lighting_texels(lit->bed, sun, with);
            return lit;
        }
        lit->water = display_water(shown, refinement, with);
        // Light falls on the water: what lies deep in it is not in the shadow of its own hollow.
        const Field<float> surface = surface_of(lit->bed, *lit->water, shown);
        const float dx = lit->bed.dx;
        const float dy = lit->bed.dy;
        lit->texels =
            lighting_texels(lit->bed,
                            LightShares{sun_visibility(surface, dx, dy, sun, sun_bounds),
                                        sky_visibility(surface, dx, dy, with), sun_bounds},
                            0, with);
    }
    return lit;
}

double RendererState::sun_share(const ReadyPicture& picture) const {
    if (!atmosphere) return 1.0;
    return visible_sun_share(picture.pose.camera, glm::dvec3(direction_to(picture.pose.sun)),
                             ground_for_rays(picture),
                             world ? static_cast<double>(world->curvature()) : 0.0);
}

/// Without a pose the camera is that of the snapshot's step.
ReadyPicture RendererState::ready(std::shared_ptr<const Snapshot> snapshot, const SunDirection& sun,
                                  const std::optional<FramePose>& pose,
                                  const std::shared_ptr<const LitBed>& before,
                                  WorkerPool& with) const {
    ReadyPicture picture;
    picture.snapshot = std::move(snapshot);
    picture.reshaped = shown_snapshot(drawable(*picture.snapshot), view);
    const Snapshot& shown = picture.shown();
    if (shown.bed.nx() != first.bed.nx() || shown.bed.ny() != first.bed.ny())
        throw Error("a snapshot of another size than the first one cannot be drawn");
    picture.framed = block_of_frame(block, view.look, first, shown);
    if (pose) {
        picture.pose = *pose;
    } else {
        picture.pose.camera = camera_at(shown.step);
        picture.pose.metered = camera_at(0);
        if (!plain)
            picture.pose.camera = above_ground(picture.pose.camera, picture.framed, shown, copies);
    }
    const bool raised = !pose && plain && picture.framed.eye;
    const bool same = before && before->snapshot == picture.snapshot && before->sun == sun;
    picture.lit = same ? before : lit_bed(picture, sun, with);
    if (raised) {
        glm::dvec3& eye = picture.pose.camera.eye;
        const auto under = static_cast<double>(picture.lit->heights->at(
            0, eye.x / ground.width_x + 0.5, eye.y / ground.width_y + 0.5));
        eye.z = std::max(eye.z, under + picture.framed.eye_above);
    }
    if (lens()) set_lens(picture, pose.has_value());
    if (world) {
        const auto samples_high = static_cast<double>(view.image.height * view.image.supersampling);
        picture.ground =
            world->visible_ground(picture.pose.camera, samples_high, *picture.lit->heights, with);
    }
    return picture;
}

}  // namespace fumon
