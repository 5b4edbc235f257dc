#pragma once

#include <filesystem>

namespace fumon {

/// A lock file, held until the object is destroyed, which deletes the file. On file systems without
/// locks nothing is locked, and standard error says so.
class FileLock {
  public:
    /// Tries once. Throws Error where the file cannot be made.
    explicit FileLock(std::filesystem::path file);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// False while another program (or thread) has it.
    [[nodiscard]] bool held() const { return descriptor_ >= 0; }

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace fumon
