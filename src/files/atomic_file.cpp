#include "files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace fumon {

namespace {

int open_retrying(const std::filesystem::path& file, int flags) {
    constexpr mode_t default_file_mode = 0666;  // less the umask
    int descriptor = -1;
    do {
        descriptor = ::open(file.c_str(), flags, default_file_mode);
    } while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

}  // namespace

void refuse_to_write(const std::filesystem::path& file, int reason) {
    throw Error(
        fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(reason)));
}

std::filesystem::path resolved_link(std::filesystem::path file) {
    std::error_code ignored;
    if (!std::filesystem::is_symlink(file, ignored)) return file;
    auto target = std::filesystem::canonical(file, ignored);
    return target.empty() ? file : target;
}

bool takes_a_rename(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return true;
    if (S_ISDIR(status.st_mode)) refuse_to_write(file, EISDIR);
    return S_ISREG(status.st_mode);
}

AtomicFile::AtomicFile(std::filesystem::path file) : file_(resolved_link(std::move(file))) {
    if (takes_a_rename(file_)) {
        temporary_ = temporary_name(file_);
        ::unlink(temporary_.c_str());  // what an interrupted run may have left
        descriptor_ = open_retrying(temporary_, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
    } else {
        descriptor_ = open_retrying(file_, O_WRONLY | O_CLOEXEC);
    }
    if (descriptor_ < 0) refuse_to_write(file_, errno);
}

AtomicFile::AtomicFile(std::filesystem::path file, std::int64_t length)
    : file_(resolved_link(std::move(file))), temporary_(temporary_name(file_)), keep_(true) {
    std::error_code fault;
    if (!std::filesystem::exists(temporary_, fault))
        std::filesystem::rename(file_, temporary_, fault);
    descriptor_ = open_retrying(temporary_, O_WRONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor_ < 0 || ::fstat(descriptor_, &status) != 0 || status.st_size < length) {
        const std::string reason =
            descriptor_ < 0 ? std::generic_category().message(errno)
                            : fmt::format("it has {} bytes of {}", status.st_size, length);
        if (descriptor_ >= 0) ::close(descriptor_);
        throw InputError(fmt::format("{}: cannot be continued: {}", temporary_.string(), reason));
    }
    if (::ftruncate(descriptor_, length) == 0 && ::lseek(descriptor_, 0, SEEK_END) == length)
        return;
    const int reason = errno;
    ::close(descriptor_);
    refuse_to_write(file_, reason);
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty() && !keep_) ::unlink(temporary_.c_str());
}

std::int64_t AtomicFile::length() const {
    return ::lseek(descriptor_, 0, SEEK_CUR);
}

void AtomicFile::sync() {
    // Pipes and some file systems cannot, and say EINVAL.
    if (::fsync(descriptor_) != 0 && errno != EINVAL) refuse_to_write(file_, errno);
}

void AtomicFile::keep() {
    keep_ = true;
}

void AtomicFile::write(std::string_view text) {
    constexpr std::size_t most_at_once = std::size_t{1} << 30;  // bytes; Linux writes at most 2 GiB
    const off_t end = ::lseek(descriptor_, 0, SEEK_CUR);
    while (!text.empty()) {
        const ssize_t written =
            ::write(descriptor_, text.data(), std::min(text.size(), most_at_once));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            const int reason = errno;
            if (!temporary_.empty() && ::ftruncate(descriptor_, end) == 0)
                ::lseek(descriptor_, end, SEEK_SET);
            refuse_to_write(file_, reason);
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void AtomicFile::commit() {
    // A network file system may report a full disk only here. On Linux the descriptor is gone even
    // after EINTR.
    const int closed = ::close(std::exchange(descriptor_, -1));
    if (closed != 0 && errno != EINTR) refuse_to_write(file_, errno);
    if (temporary_.empty()) return;
    if (::rename(temporary_.c_str(), file_.c_str()) != 0) refuse_to_write(file_, errno);
    temporary_.clear();
}

std::filesystem::path temporary_name(std::filesystem::path file) {
    file += ".part";
    return file;
}

void sync_folder_of(const std::filesystem::path& file) {
    const int folder = open_retrying(std::filesystem::absolute(file).parent_path(),
                                     O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    ::fsync(folder);
    ::close(folder);
}

void sync_file(const std::filesystem::path& file) {
    const int descriptor = open_retrying(file, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) refuse_to_write(file, errno);
    const int reason = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (reason != 0 && reason != EINVAL) refuse_to_write(file, reason);
}

void write_file(const std::filesystem::path& file, std::string_view text) {
    AtomicFile out(file);
    out.write(text);
    out.commit();
}

void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
    AtomicFile out(file);
    out.write(bytes);
    out.commit();
}

void copy_whole(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::error_code fault;
    const std::filesystem::path temporary = temporary_name(to);
    std::filesystem::copy_file(from, temporary, std::filesystem::copy_options::overwrite_existing,
                               fault);
    if (!fault) std::filesystem::rename(temporary, to, fault);
    if (fault) {
        throw Error(
            fmt::format("cannot copy {} to {}: {}", from.string(), to.string(), fault.message()));
    }
}

}  // namespace fumon
