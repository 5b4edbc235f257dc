#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fumon {

/// What GDAL's notes of a raster (.aux.xml) say that changes how it is read: without statistics and
/// histograms, which QGIS and gdalinfo write there, without elements that are then empty, and
/// without the space between elements. Empty where nothing is left.
std::string without_statistics(std::string_view notes);

/// Whether a file .aux is of ERDAS, as GDAL reads beside a raster; LaTeX writes others.
bool is_erdas_aux(const std::filesystem::path& file);

}  // namespace fumon
