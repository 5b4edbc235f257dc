#pragma once

#include <filesystem>

namespace fumon {

/// Locks an open file or folder for this descriptor alone, without waiting. False while another
/// one holds the lock. Where there are no locks it is true, and the first time that happens
/// standard error says so.
bool lock_descriptor(int descriptor, const std::filesystem::path& named);

/// Says, the first time, that something cannot be locked, for an errno value.
void warn_not_locked(const std::filesystem::path& named, int reason);

}  // namespace fumon
