#pragma once

#include <filesystem>

namespace fumon {

/// Keeps other programs of fumon out of a folder while it lives; however the program ends, the lock
/// ends with it, and it leaves no file behind.
class FolderLock {
  public:
    /// Throws InputError where another one holds it. Some network file systems have no locks for
    /// folders; there one goes without.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

}  // namespace fumon
