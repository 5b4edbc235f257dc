#pragma once

#include <filesystem>

namespace fumon {

/// Throws InputError where a file in one of the classic NetCDF formats (versions 1, 2 and 5) is
/// shorter than its own header says, where the NetCDF library reads zeros without a word, or where
/// a type is unknown, or a variable's dimension is not there or has no length though it is not
/// the records', where the library divides by zero. Files in other formats are left to the library.
/// Source of the format: Unidata, "NetCDF Classic Format Specification".
void refuse_damaged_classic_file(const std::filesystem::path& file);

}  // namespace fumon
