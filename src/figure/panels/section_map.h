#pragma once

#include "figure/panels/arrow_field.h"
#include "figure/panels/colour_bar.h"
#include "figure/plot/axes.h"
#include "render/air/section_air.h"
#include "scene/scene.h"

namespace fumon {

/// What a map's colours show of the air: the length of its velocity, or one of its fields.
enum class SectionQuantity { speed, velocity_x, velocity_z, pressure };

/// The palette and range of a map. A range that is not given comes from the air: from 0 where the
/// values have one sign, else as far below 0 as above it; where values lie beyond a given one, the
/// bar says so. A palette "sand" (for beds) gives way to
/// viridis, or vik for values of both signs. Throws InputError where there is no such palette.
ColourScale map_scale(const SectionAir& air, SectionQuantity quantity, const LookSettings& look,
                      const WordOrReal& low, const WordOrReal& high);

/// Colours a frame by the quantity, with the bed in front. `axes` in units of `unit` metres. The
/// air has the quantity's fields.
void draw_section_map(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air,
                      SectionQuantity quantity, const ColourScale& scale);

/// The velocity as arrows over axes in units of `unit` metres. Refers to the air, which must
/// outlive it.
ArrowField section_arrows(const SectionAir& air, double unit);

/// The velocity as streamlines over a map.
void draw_section_streamlines(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air);

/// The bed's ground from the frame's lower side up to its surface.
void draw_section_bed(Canvas& canvas, const Axes& axes, double unit, const SectionAir& air);

}  // namespace fumon
