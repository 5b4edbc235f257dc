#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace fumon {

/// A file that appears whole or not at all: written under a temporary name ("NAME.part") in the
/// same folder and renamed by commit(). An uncommitted file is deleted.
class AtomicFile {
  public:
    /// Throws Error when the temporary file cannot be made.
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view text);  ///< throws Error on a full disk or any failed write
    void write(std::span<const std::uint8_t> bytes);  ///< likewise
    void commit();  ///< flushes, closes, renames; throws Error on failure

  private:
    std::filesystem::path file_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

/// One whole file at once. Throws Error naming the file and the system's reason.
void write_file(const std::filesystem::path& file, std::string_view text);
void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

}  // namespace fumon
