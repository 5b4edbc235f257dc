#include "render/picture_drawing.h"

#include <algorithm>

#include "gl/functions.h"
#include "render/frame/view_uniforms.h"
#include "render/view/ground_choice.h"
#include "render/view/shown_snapshot.h"

namespace fumon {

PictureDrawing::PictureDrawing(RendererState& state, const ReadyPicture& picture)
    : state_(state),
      picture_(picture),
      shown_(picture.shown()),
      lit_(*picture.lit),
      camera_(picture.pose.camera) {
    RendererState& s = state_;
    if (picture.pose.reference)
        reference_ = FrameSetting::shown_first(drawable(*picture.pose.reference), s.view);
    if (reference_ && s.plain) {
        const std::string& coloured = s.view.look.field;
        reference_ = s.plain->is_drained()
                         ? s.plain->around(*reference_, s.pool, coloured)
                         : SurroundingPlain(*reference_, s.pool, known_sea(s.view, *reference_))
                               .around(*reference_, s.pool, coloured);
    }
    const bool held = s.uploaded == picture.lit && !reference_;
    fresh_ = !held || !s.world;
    s.uploaded = reference_ ? nullptr : picture.lit;
    s.light.metered = metered_exposure(s.view, s.light, picture.pose.metered.value_or(camera_));
    s.dry_block.forget_colours();
    gl::functions().BindVertexArray(s.no_attributes.name());
}

void PictureDrawing::upload_bed_maps() {
    const Snapshot& reference = reference_ ? *reference_ : state_.first_ground();
    if (state_.world) {
        state_.shading.upload(picture_.ground_shown(), reference, lit_.light, state_.origin);
        if (!lit_.water) return;
        if (state_.plain) {
            state_.shading.upload_water(*lit_.water_tile, state_.plain->own_tile(reference),
                                        *lit_.water);
        } else {
            state_.shading.upload_water(shown_, reference, *lit_.water);
        }
    } else {
        state_.shading.upload(shown_, reference, lit_.texels, lit_.water ? &*lit_.water : nullptr);
    }
}

void PictureDrawing::upload_world_maps() {
    state_.world->set_bed(shown_, lit_.light, lit_.heights);
}

void PictureDrawing::bind_sky() {
    state_.sky.bind(sky_unit);
}

void PictureDrawing::shade_bed() {
    state_.shading.shade(state_.light, camera_);
}

void PictureDrawing::take_world_mesh() {
    state_.world->look_at(picture_.ground);
}

void PictureDrawing::mesh_block() {
    RendererState& s = state_;
    if (lit_.water) water_depth_ = s.drawn_depth(*lit_.water, shown_);
    s.terrain.set_bed(lit_.bed, water_depth_ ? &*water_depth_ : nullptr, camera_);
    const auto rise = static_cast<float>(s.block.height_scale / shown_.scale.height_unit);
    s.terrain.set_water(rise * static_cast<float>(s.shading.clarity()),
                        static_cast<float>(s.shading.turbidity()));
    if (s.water_block && s.drawn_by_block_passes(camera_))
        s.water_block->find_kinds(*lit_.water, shown_, !colours_water(s.view.look.colour_by));
}

void PictureDrawing::place_plants() {
    RendererState& s = state_;
    if (s.world && s.plain) {
        // Those of the plain beyond the bed's tile are its tint alone.
        const Field<float>& maps = lit_.heights->finest();
        Field<float> tile(maps.nx() / 2, maps.ny());
        for (int y = 0; y < tile.ny(); ++y)
            std::copy_n(maps.row(y).begin(), tile.nx(), tile.row(y).begin());
        s.plants->set_bed(s.plain->own_tile(*lit_.in_plain), tile, false);
    } else if (s.world) {
        s.plants->set_bed(shown_, lit_.heights->finest(), true);
    } else {
        s.plants->set_bed(shown_, lit_.bed.z, false);
    }
}

void PictureDrawing::place_persons() {
    if (state_.world) {
        state_.persons->set_bed(lit_.heights->finest(), state_.ground, true);
    } else {
        state_.persons->set_bed(lit_.bed.z, state_.block, false);
    }
}

void PictureDrawing::place_prints() {
    if (state_.world) {
        state_.tracks->set_bed(lit_.heights->finest(), state_.ground, true,
                               state_.ground_transform(camera_), nullptr);
    } else {
        state_.tracks->set_bed(lit_.bed.z, state_.block, false, {},
                               water_depth_ ? &*water_depth_ : nullptr);
    }
}

/// How much of it the camera sees, for its glare.
void PictureDrawing::look_at_sun() {
    RendererState& s = state_;
    auto visibility = static_cast<float>(picture_.sun_share);
    gl::functions().BindVertexArray(s.no_attributes.name());
    if (visibility > 0.0F) visibility *= s.background.sun_through_clouds(s.light, camera_);
    if (visibility != s.light.visible_sun) s.background.forget();
    s.light.visible_sun = visibility;
}

void PictureDrawing::paint_air() {
    state_.air->set_air(shown_, picture_.framed, camera_, state_.pool);
}

void PictureDrawing::choose_plants() {
    state_.plants->choose(state_.ground_transform(camera_), camera_);
}

void PictureDrawing::choose_streamers() {
    state_.streamers->choose(*lit_.blown, picture_.pose.frame.value_or(shown_.step),
                             state_.ground_transform(camera_), camera_);
}

}  // namespace fumon
