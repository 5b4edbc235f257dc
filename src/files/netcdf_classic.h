#pragma once

#include <filesystem>

namespace fumon {

/// Throws InputError where a file in one of the classic NetCDF formats (versions 1, 2 and 5) is
/// shorter than its own header says: the NetCDF library reads zeros there without a word. Files in
/// other formats, and headers that cannot be understood, are left to the library. Source of the
/// format: Unidata, "NetCDF Classic Format Specification".
void refuse_short_classic_file(const std::filesystem::path& file);

}  // namespace fumon
