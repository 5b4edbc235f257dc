#include "files/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/lock_descriptor.h"

namespace fumon {

FolderLock::FolderLock(const std::filesystem::path& folder, std::chrono::seconds longest_wait)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) {
        if (errno != EACCES) refuse_to_write(folder, errno);
        warn_not_locked(folder, errno);  // a folder that may be written, but not read
        return;
    }
    const auto end = std::chrono::steady_clock::now() + longest_wait;
    for (;;) {
        if (lock_descriptor(descriptor_, folder)) return;
        if (std::chrono::steady_clock::now() >= end) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ::close(descriptor_);
    throw InputError(fmt::format(
        "another fumon is working in {}; wait for it or name another folder", folder.string()));
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace fumon
