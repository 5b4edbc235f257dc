#include "files/appended_file.h"

#include <fmt/format.h>

#include <system_error>

#include "base/error.h"
#include "files/input_file.h"

namespace fumon {

namespace {

/// Hashes the first `length` bytes; returns how many there were.
std::int64_t hash_beginning(const std::filesystem::path& file, std::int64_t length,
                            Sha256Stream& hash) {
    std::int64_t found = 0;
    stream_input_file(file, length, [&](std::string_view bytes) {
        hash.add(bytes.data(), bytes.size());
        found += static_cast<std::int64_t>(bytes.size());
    });
    return found;
}

AtomicFile checked(const std::filesystem::path& file, const FileBeginning& previous) {
    const std::string differs = difference(file, previous);
    if (!differs.empty())
        throw InputError(
            fmt::format("{}: cannot be continued: it {}", surviving_file(file).string(), differs));
    return AtomicFile(file, previous.length);
}

}  // namespace

std::filesystem::path surviving_file(const std::filesystem::path& file) {
    std::error_code fault;
    const std::filesystem::path temporary = temporary_name(resolved_link(file));
    return std::filesystem::exists(temporary, fault) ? temporary : file;
}

std::string difference(const std::filesystem::path& file, const FileBeginning& beginning) {
    const std::filesystem::path left = surviving_file(file);
    std::error_code fault;
    if (!std::filesystem::exists(left, fault)) return "does not exist";
    if (!std::filesystem::is_regular_file(left, fault)) return "is not a file";
    Sha256Stream hash;
    const std::int64_t found = hash_beginning(left, beginning.length, hash);
    if (found < beginning.length) return fmt::format("has {} bytes of {}", found, beginning.length);
    return hash.finish() == beginning.hash ? "" : "has changed since it was written";
}

AppendedFile::AppendedFile(const std::filesystem::path& file, const FileBeginning& previous)
    : file_(checked(file, previous)) {
    hash_beginning(surviving_file(file), previous.length, hash_);
}

void AppendedFile::write(std::string_view bytes) {
    file_.write(bytes);
    hash_.add(bytes.data(), bytes.size());
}

FileBeginning AppendedFile::sync() {
    file_.sync();
    file_.keep();
    return {file_.length(), hash_.so_far()};
}

}  // namespace fumon
