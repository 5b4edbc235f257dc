#pragma once

#include <cstdint>
#include <span>

#include "base/image.h"
#include "figure/canvas/cairo_handles.h"

namespace fumon {

/// Pixels as Cairo keeps them, 32 bits each, premultiplied by the opacity (0 … 255 a pixel; empty:
/// opaque), `copies` by `copies` of each. Throws Error where they are more than Cairo can hold.
Surface cairo_image(const Image& image, std::span<const std::uint8_t> opacity, int copies);

/// The pixels of an opaque image of Cairo's.
Image image_of_cairo(cairo_surface_t* surface);

}  // namespace fumon
