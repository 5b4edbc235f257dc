#pragma once

#include <filesystem>
#include <memory>

#include "drape/picture_source.h"

namespace fumon {

/// A picture in any format of colours that GDAL reads from files: one band of grey or of a palette,
/// or red, green and blue, with an opacity or a mask; 8 or 16 bits a channel. Throws as
/// open_picture(), also where GDAL is not installed.
std::unique_ptr<PictureSource> open_gdal_picture(const std::filesystem::path& file, bool trusted);

}  // namespace fumon
