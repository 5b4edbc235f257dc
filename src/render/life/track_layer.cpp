#include "render/life/track_layer.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "render/frame/view_uniforms.h"
#include "render/view/bed_positions.h"
#include "render/view/bilinear_height.h"
#include "render/view/framing.h"
#include "render/view/ground_choice.h"

namespace fumon {

namespace {

constexpr int relief_unit = 12;
constexpr int printed_unit = 13;
constexpr int corners_of_box = 36;
constexpr GLint surface_of_block = 1;  // the stencil of its samples, see TerrainLayer
constexpr double slope_span = 0.25;    // metres, over which the slope under a print is measured
constexpr float wet = 1e-3F;           // metres of water that hide a print

void check_line(const TrackSettings& track, const std::string& key, const View& view,
                const Block& block, const Snapshot& first) {
    if (track.along.size() < 4 || track.along.size() % 2 != 0) {
        throw KeyError(key, key +
                                " is two points or more, two numbers each: metres east and north "
                                "of the bed's south-western corner");
    }
    for (std::size_t i = 0; i < track.along.size(); i += 2) {
        static_cast<void>(bed_position({track.along[i], track.along[i + 1]}, view, block, first,
                                       key, fmt::format("{}, point {}", key, i / 2 + 1)));
    }
    const double length = track_length(track);
    if (length < step_length) {
        throw KeyError(key, fmt::format("{} is {:g} m long; a track is at least a step, {:g} m",
                                        key, length, step_length));
    }
}

std::vector<Footprint> prints_of(const View& view, const Block& block, const Snapshot& first) {
    check_shows_scale(view, block, first, "track.0.along", "a track");
    std::vector<Footprint> prints;
    double together = 0.0;
    for (std::size_t i = 0; i < view.tracks.size(); ++i) {
        const std::string key = fmt::format("track.{}.along", i);
        check_line(view.tracks[i], key, view, block, first);
        together += track_length(view.tracks[i]);
        if (together > longest_tracks) {
            throw KeyError(key, fmt::format("{} makes tracks of {:g} m; all of them together have "
                                            "at most {:g} m",
                                            key, together, longest_tracks));
        }
        const std::vector<Footprint> added =
            footprints(view.tracks[i], static_cast<std::uint32_t>(i));
        prints.insert(prints.end(), added.begin(), added.end());
    }
    return prints;
}

}  // namespace

void check_tracks(const View& view, const Snapshot& first) {
    if (view.tracks.empty()) return;
    const View drawn = with_chosen_ground(view, first);
    static_cast<void>(prints_of(drawn, framed_block(drawn, first), first));
}

TrackLayer::TrackLayer(const View& view, const Block& block, const Snapshot& first,
                       const gl::Constants& fixed)
    : view_(view),
      block_(block),
      prints_(prints_of(view, block, first)),
      program_("life/track.vert.glsl",
               view.look.ground == Ground::endless ? "life/track_world.frag.glsl"
                                                   : "life/track_block.frag.glsl",
               {"root", "form", "slope"}, fixed) {
    for (const Footprint& print : prints_) {
        positions_.push_back(print.at / block.side -
                             0.5 * glm::dvec2(block.width_x, block.width_y));
    }
    anchor_ = positions_.front();
    const gl::Functions& gl = gl::functions();
    gl.BindVertexArray(array_.name());
    instances_.bind();
    constexpr std::array offsets{offsetof(Instance, root), offsetof(Instance, form),
                                 offsetof(Instance, slope)};
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const auto index = static_cast<GLuint>(i);
        gl.VertexAttribPointer(index, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                               reinterpret_cast<const void*>(offsets.at(i)));
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribDivisor(index, 1);
    }
    gl.BindVertexArray(0);
}

void TrackLayer::set_bed(const Field<float>& z, const Block& ground, bool repeats,
                         const GroundTransform& on, const Field<float>* water) {
    const auto share = [&](const glm::dvec2& at) {
        const glm::dvec2 from = on.copies.bed_position_at(at) - on.origin;
        const glm::dvec2 in_maps =
            ground.tiles.in_maps(from / glm::dvec2(ground.width_x, ground.width_y) + 0.5);
        return repeats ? in_maps - glm::floor(in_maps) : in_maps;
    };
    const auto height = [&](const glm::dvec2& at) {
        return on.copies.raised(on.copies.at(at),
                                static_cast<double>(bilinear_height(z, share(at), repeats)));
    };
    const double apart = 0.5 * slope_span / block_.side;
    const auto rise = [&](const glm::dvec2& at, const glm::dvec2& way) {
        return static_cast<float>((height(at + way) - height(at - way)) / (2.0 * apart));
    };
    std::vector<Instance> instances;
    for (std::size_t i = 0; i < prints_.size(); ++i) {
        const Footprint& print = prints_[i];
        const glm::dvec2& at = positions_[i];
        const bool dry =
            water == nullptr ||
            bilinear_height(*water, share(at), repeats) * static_cast<float>(block_.side) < wet;
        instances.push_back(
            {glm::vec4(glm::dvec4(at - anchor_, height(at), print.unevenness)),
             glm::vec4(glm::dvec4(print.heading, print.right ? 1.0 : -1.0, print.depth)),
             glm::vec4(rise(at, {apart, 0.0}), rise(at, {0.0, apart}), dry ? 1.0F : 0.0F, 0.0F)});
    }
    instances_.fill(instances);
    if (repeats) return;  // endless ground has its heights in the samples
    if (!heights_) {
        heights_.emplace(
            z.nx(), z.ny(),
            gl::TextureLayout{GL_R32F, GL_RED, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE});
    }
    heights_->upload(z.data());
}

void TrackLayer::draw(const gl::Texture2D& visibility, const WorldLayer* world,
                      const GroundTransform& ground, const BedShading& shading, const Light& light,
                      const Camera& camera, const TileSamples& tile) const {
    const gl::Functions& gl = gl::functions();
    program_.use();
    if (world != nullptr) {
        world->bind(program_, &visibility, shading, light, camera);
    } else {
        shading.bind(program_);
        set_light(program_, view_, light, camera, block_);
        visibility.bind(printed_unit);
        program_.set("visibility", printed_unit);
        heights_->bind(relief_unit);
        program_.set("height_map", relief_unit);
    }
    const glm::dvec2 anchor = world != nullptr ? anchor_ - glm::dvec2(camera.eye) : anchor_;
    program_.set("clip", ground.clip);
    program_.set("picture_size", tile.picture_size);
    program_.set("tile_corner", tile.corner);
    program_.set("tile_size", tile.size);
    program_.set("anchor", glm::vec3(glm::dvec3(anchor, world != nullptr ? -camera.eye.z : 0.0)));
    program_.set("eye_position", world != nullptr ? glm::vec3(0.0F) : glm::vec3(camera.eye));
    program_.set("curvature", ground.curvature);
    program_.set("metre", static_cast<float>(1.0 / block_.side));
    program_.set("step_length", static_cast<float>(step_length));
    program_.set("half_step_width", static_cast<float>(half_step_width));
    program_.set("angle", 2.0F * static_cast<float>(camera.half.y) / tile.picture_size.y);
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT);  // of each box the far side, whether or not the eye is within
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    if (world == nullptr) {
        gl.Enable(GL_STENCIL_TEST);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        gl.StencilFunc(GL_EQUAL, surface_of_block, 0xFF);
    }
    gl.BindVertexArray(array_.name());
    gl.DrawArraysInstanced(GL_TRIANGLES, 0, corners_of_box, static_cast<GLsizei>(prints_.size()));
    gl.BindVertexArray(0);
    gl.Disable(GL_STENCIL_TEST);
    gl.Disable(GL_BLEND);
    gl.CullFace(GL_BACK);
    gl.Disable(GL_CULL_FACE);
}

}  // namespace fumon
