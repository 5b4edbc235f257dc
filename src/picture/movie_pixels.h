#pragma once

#include "base/image.h"

struct AVFrame;

namespace fumon {

class ColourTable;

/// Copies an image into an RGB frame of even sides, repeating its last column and row.
void copy_padded(const Image& image, AVFrame& frame);
/// The same of an image with alpha into an RGBA frame.
void copy_padded_open(const Image& image, AVFrame& frame);
/// Copies an image into a frame of the table's colours.
void copy_indexed(const Image& image, const ColourTable& colours, AVFrame& frame);

}  // namespace fumon
