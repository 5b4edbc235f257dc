#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/sha256.h"
#include "files/atomic_file.h"

namespace fumon {

/// The first bytes of a file that grows.
struct FileBeginning {
    std::int64_t length = -1;  ///< bytes; −1: there was no file
    Sha256 hash{};
};

/// The name under which a program that was stopped left a file: its temporary one where there is
/// one, else its own.
std::filesystem::path surviving_file(const std::filesystem::path& file);

/// Why a file does not begin with these bytes: "does not exist", "has 40 bytes of 96" …; empty
/// where it does. Throws where it cannot be read.
std::string difference(const std::filesystem::path& file, const FileBeginning& beginning);

/// An atomic file that only grows and whose SHA-256 is known at any time, so that a later program
/// can go on with it and knows that it is the same.
class AppendedFile {
  public:
    /// Throws Error when it cannot be made.
    explicit AppendedFile(const std::filesystem::path& file) : file_(file) {}
    /// Goes on with what a former program left, after its first bytes. Throws InputError where they
    /// are no longer those that it wrote, Error where the file cannot be written.
    AppendedFile(const std::filesystem::path& file, const FileBeginning& previous);

    void write(std::string_view bytes);  ///< throws as AtomicFile
    /// Puts all on disk, where it stays for a later program. Throws Error on failure.
    [[nodiscard]] FileBeginning sync();
    void commit() { file_.commit(); }  ///< throws Error on failure

  private:
    AtomicFile file_;
    Sha256Stream hash_;
};

}  // namespace fumon
