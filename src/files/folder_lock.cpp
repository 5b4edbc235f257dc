#include "files/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/lock_descriptor.h"

namespace fumon {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) {
        if (errno == EMFILE || errno == ENFILE) refuse_to_write(folder, errno);
        tell_not_locked(folder, errno);
        return;
    }
    if (lock_descriptor(descriptor_, folder)) return;
    ::close(descriptor_);
    throw InputError(fmt::format(
        "another fumon is at work in {}; wait for it or name another folder", folder.string()));
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace fumon
