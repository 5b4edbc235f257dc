#pragma once

#include "gl/program.h"
#include "gl/texture.h"

namespace fumon {

/// What draws the points that pixels see at their middles, a tile at once.
struct SurfacePositionPass {
    SurfacePositionPass(int width, int height)
        : surface("position/bed_position.vert.glsl", "position/position.frag.glsl",
                  {"east_north", "height"}),
          sides("position/side_position.vert.glsl", "position/position.frag.glsl",
                {"east_north", "normal", "heights"}),
          leaves("position/plant_position.vert.glsl", "position/position.frag.glsl",
                 {"leaf", "leaf_normal", "root", "form"}),
          persons("position/person_position.vert.glsl", "position/position.frag.glsl",
                  {"part", "part_normal", "part_colour"}),
          depths(width, height),
          target(width, height, {GL_RGBA32F, GL_RGBA, GL_FLOAT, GL_NEAREST, 0, GL_CLAMP_TO_EDGE},
                 &depths) {}

    gl::Program surface;
    gl::Program sides;
    gl::Program leaves;
    gl::Program persons;
    gl::DepthBuffer depths;
    gl::RenderTarget target;
};

}  // namespace fumon
