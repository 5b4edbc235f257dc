#pragma once

#include <chrono>
#include <filesystem>

namespace fumon {

/// Keeps other fumon programs out of a folder while it exists. However the program ends, the lock
/// ends with it and leaves no file behind.
class FolderLock {
  public:
    /// Throws InputError if another program still holds the lock after `longest_wait`, Error where
    /// the folder cannot be opened. Some network file systems cannot lock folders; there nothing is
    /// locked, and standard error says so.
    explicit FolderLock(const std::filesystem::path& folder,
                        std::chrono::seconds longest_wait = {});
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

}  // namespace fumon
