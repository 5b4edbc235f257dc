#include "files/file_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "files/atomic_file.h"
#include "files/lock_descriptor.h"

namespace fumon {

namespace {

/// Whether the file that is open is still the one under its name: whoever held it before may have
/// taken it away after we opened it.
bool is_still_there(int descriptor, const std::filesystem::path& file) {
    struct stat open_one {};
    struct stat named_one {};
    return ::fstat(descriptor, &open_one) == 0 && ::stat(file.c_str(), &named_one) == 0 &&
           open_one.st_dev == named_one.st_dev && open_one.st_ino == named_one.st_ino;
}

}  // namespace

FileLock::FileLock(std::filesystem::path file) : file_(std::move(file)) {
    constexpr mode_t default_file_mode = 0666;  // less the umask
    const int descriptor = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, default_file_mode);
    if (descriptor < 0) refuse_to_write(file_, errno);
    if (!lock_descriptor(descriptor, file_) || !is_still_there(descriptor, file_)) {
        ::close(descriptor);
        return;
    }
    descriptor_ = descriptor;
}

FileLock::~FileLock() {
    if (descriptor_ < 0) return;
    ::unlink(file_.c_str());
    ::close(descriptor_);
}

}  // namespace fumon
