#pragma once

#include "gl/program.h"
#include "gl/texture.h"

namespace fumon {

/// What draws the points that pixels see at their middles, a tile at once.
struct PlacePass {
    PlacePass(int width, int height)
        : surface("places/bed_place.vert.glsl", "places/place.frag.glsl", {"east_north", "height"}),
          sides("places/side_place.vert.glsl", "places/place.frag.glsl",
                {"east_north", "normal", "heights"}),
          leaves("places/plant_place.vert.glsl", "places/place.frag.glsl",
                 {"leaf", "leaf_normal", "root", "form"}),
          persons("places/person_place.vert.glsl", "places/place.frag.glsl",
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
