#include "render/water_shading.h"

#include <cstddef>
#include <vector>

#include "render/grain.h"

namespace fumon {

namespace {

const gl::TextureLayout water_layout{GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_LINEAR, 0, GL_CLAMP_TO_EDGE};
const gl::TextureLayout streak_layout{GL_R8, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR, 0, GL_REPEAT};

}  // namespace

WaterShading::WaterShading(const View& view, const Block& block, int nx, int ny)
    : view_(view),
      block_(block),
      water_(nx, ny, water_layout),
      streaks_(grain_size, grain_size, streak_layout, grain_texels().data()) {}

void WaterShading::upload(const Snapshot& snapshot, const DisplayWater& water) {
    std::vector<float> texels;
    texels.reserve(4 * water.depth.size());
    for (std::size_t i = 0; i < water.depth.size(); ++i) {
        for (const Field<float>* field :
             {&water.depth, &water.velocity_x, &water.velocity_y, &water.damp})
            texels.push_back(field->values()[i]);
    }
    water_.upload(texels.data());
    const WaterStatistics usual = water_statistics(snapshot);
    clarity_ = water_clarity(view_.look, usual);
    usual_froude_ = usual.median_froude;
    height_unit_ = snapshot.scale.height_unit;
}

void WaterShading::set_uniforms(const gl::Program& program, int unit) const {
    water_.bind(unit);
    streaks_.bind(unit + 1);
    program.set("water_map", unit);
    program.set("streak_map", unit + 1);
    program.set("water_cell", glm::vec2(1.0 / water_.width(), 1.0 / water_.height()));
    program.set("water_rise", static_cast<float>(block_.height_scale / height_unit_));
    program.set("clarity", static_cast<float>(clarity_));
    program.set("turbidity", static_cast<float>(view_.look.turbidity));
    program.set("usual_froude", static_cast<float>(usual_froude_));
}

}  // namespace fumon
