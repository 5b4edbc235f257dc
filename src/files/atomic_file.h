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

    /// Throws Error on a full disk or any failed write; the file then ends where it did before.
    void write(std::string_view text);
    void write(std::span<const std::uint8_t> bytes);  ///< likewise
    void commit();  ///< flushes, closes, renames; throws Error on failure

  private:
    std::filesystem::path file_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
};

/// What a path leads to: a link stays a link, and what it points to is written.
std::filesystem::path resolved_link(std::filesystem::path file);

/// Whether a file can be replaced by a rename: not pipes and devices ("/dev/stdout"), which are
/// written directly. Throws Error for a folder.
bool takes_a_rename(const std::filesystem::path& file);

/// Throws Error "cannot write FILE: REASON" for an errno value.
[[noreturn]] void refuse_to_write(const std::filesystem::path& file, int reason);

/// One whole file at once. Throws Error naming the file and the system's reason.
void write_file(const std::filesystem::path& file, std::string_view text);
void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

}  // namespace fumon
