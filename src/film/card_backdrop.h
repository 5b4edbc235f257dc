#pragma once

#include "base/image.h"

namespace fumon {

/// A picture of a film out of focus and darkened, for a card's letters to stand on: three box
/// averages one after the other, each a fortieth of the picture's shorter side wide to both sides
/// (together nearly a Gaussian of that deviation), of what is then a third as bright. Opaque, with
/// the picture's width and height; its last bits are dithered, so that the soft tones have no
/// bands.
Image card_backdrop(const Image& picture);

}  // namespace fumon
