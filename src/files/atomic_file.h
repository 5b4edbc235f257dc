#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace fumon {

/// A file that appears complete or not at all: it is written under a temporary name ("NAME.part")
/// in the same folder, and commit() renames it. An uncommitted file is deleted, unless it continues
/// the file of an earlier program or shall be kept.
class AtomicFile {
  public:
    /// Throws Error when the temporary file cannot be made.
    explicit AtomicFile(std::filesystem::path file);
    /// Continues a file that an earlier program left under its temporary or final name, after its
    /// first `length` bytes; the rest is cut off. Throws InputError if the file is shorter or
    /// missing, Error if it cannot be written.
    AtomicFile(std::filesystem::path file, std::int64_t length);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Throws Error on a full disk or any failed write; the file then ends where it did before.
    void write(std::string_view text);
    void write(std::span<const std::uint8_t> bytes);  ///< likewise
    /// Bytes written so far.
    [[nodiscard]] std::int64_t length() const;
    void sync();    ///< puts what was written on disk (fsync); throws Error on failure
    void keep();    ///< from now on it stays under its temporary name if it is not committed
    void commit();  ///< flushes, closes, renames; throws Error on failure

  private:
    std::filesystem::path file_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    bool keep_ = false;
};

/// Copies a file; the copy appears whole or not at all. Throws Error.
void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to);

/// The temporary name under which a file is written.
std::filesystem::path temporary_name(std::filesystem::path file);

/// Flushes the entries of a file's folder to disk, so that its name survives a power failure. File
/// systems that cannot do this are trusted.
void sync_folder_of(const std::filesystem::path& file);

/// Flushes a complete file that was written earlier to disk. Throws Error on failure.
void sync_file(const std::filesystem::path& file);

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
