#pragma once

#include <filesystem>

namespace fumon {

/// Why a file may just have failed to open whatever it is: EMFILE where this program has too many
/// open files, ENFILE where the system has, else 0. For libraries that do not tell.
int shortage_of_open_files();

/// Where a file could not be opened for reading: throws Error if that is why.
void refuse_shortage_of_open_files(const std::filesystem::path& file);

}  // namespace fumon
