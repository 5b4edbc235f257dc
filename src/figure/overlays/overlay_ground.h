#pragma once

#include <memory>

#include "figure/overlays/overlay.h"

namespace fumon {

/// A level bar of a round length, at most a fifth of the picture's width: true everywhere in a map
/// and, for lengths across the picture, in an orthographic view; in perspective at the middle of
/// the block, which its text says. Throws KeyError over a section's flat figure, whose axes have
/// the scale.
std::unique_ptr<Overlay> make_scale_bar(const OverlayScene& on, std::size_t number);

/// The direction of the wind (sand and air) or of the slope that water runs down (a tilted plane),
/// as the camera sees the ground at the frame, beside a compass; a compass alone where the model
/// has neither. Over a section's flat figure the wind alone, which blows to the right. Throws
/// KeyError where there is nothing to show.
std::unique_ptr<Overlay> make_arrow(const OverlayScene& on, std::size_t number);

}  // namespace fumon
