#pragma once

#include <memory>

#include "figure/overlays/overlay.h"

namespace fumon {

/// The frame's colours as a level bar: the palette and range with which they were drawn, and the
/// quantity with its unit; heights in metres where the bed has them, in millimetres on beds shorter
/// than 10 m. Throws KeyError where the colours mean no quantity (look.colour_by = "natural"), and
/// over a section's flat figure, which has bars of its own.
std::unique_ptr<Overlay> make_colour_bar(const OverlayScene& on, std::size_t number);

}  // namespace fumon
