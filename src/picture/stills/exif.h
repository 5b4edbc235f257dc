#pragma once

#include <string>

namespace fumon {

/// The TIFF structure of an Exif block that states a picture's dots per inch, its size in pixels
/// and that its colours are sRGB (CIPA DC-008).
std::string exif_block(double dots_per_inch, int width, int height);

}  // namespace fumon
