#pragma once

#include <cstdint>

/// The loops over rows of a bed that light takes, see vectors/target.h: the same bits on every
/// target.
namespace fumon::light_vectors {

/// Arrays of what the shadows of the sun's two limbs are over a row: the height each reaches, and
/// how far apart both are of the point that casts it.
struct Shadow {
    float* lower;
    float* lower_width;
    float* upper;
    float* upper_width;
};

/// One row's step of the sweep of sun_visibility().
struct ShadowStep {
    int count;
    float fraction;    ///< of the way from a column to the next, where a ray crossed the row before
    float lower_drop;  ///< how far the limbs' shadows sink between two rows
    float upper_drop;
    float lowest;  ///< between which shares of the sun are kept
    float highest;
};

/// The shadow after a row of heights, and the share of the sun that these see. Column x looks back
/// between columns x and x + 1 of `before`.
void sweep_shadow(const ShadowStep& step, const float* heights, const Shadow& before,
                  const Shadow& after, float* visibility);

/// Adds to `sum` the visible sky in both directions of a line of `count` heights z[−1] … z[count],
/// see sky_visibility(): `back` and `ahead` are the horizons' tangents in cells of a length of
/// `spacing`, `weight` is one direction's.
void add_sky(const float* z, int count, const float* back, const float* ahead, float spacing,
             float weight, float* sum);

/// Three rows of heights: `row` from one column before, the others from the first column on.
struct ThreeRows {
    const float* south;
    const float* row;
    const float* north;
    float scale_x;  ///< of the difference of two columns apart, to the slope
    float scale_y;  ///< of north less south
};

/// sum[x] times the upward part of the normal, 0 … 1.
void multiply_by_normal(const ThreeRows& heights, int count, float* sum);

/// From a share of the sun to its number.
struct SunTexel {
    float scale;
    float offset;
};

/// Four numbers a cell, as lighting_texels() says.
void pack_texels(const ThreeRows& heights, const float* sun, const float* sky,
                 const SunTexel& sun_texel, int count, std::uint16_t* texels);

}  // namespace fumon::light_vectors
