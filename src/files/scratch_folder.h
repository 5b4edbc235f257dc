#pragma once

#include <filesystem>

namespace fumon {

/// A new empty folder among the system's temporary files, deleted with all in it when it goes out
/// of scope. Throws Error where none can be made.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace fumon
