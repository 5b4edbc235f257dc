#include "files/lock_descriptor.h"

#include <fmt/format.h>
#include <sys/file.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "base/tell.h"

namespace fumon {

bool lock_descriptor(int descriptor, const std::filesystem::path& named) {
    int reason = 0;
    do {
        reason = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    } while (reason == EINTR);
    if (reason == EWOULDBLOCK) return false;
    if (reason != 0) tell_not_locked(named, reason);
    return true;
}

void tell_not_locked(const std::filesystem::path& named, int reason) {
    static std::atomic<bool> told{false};
    if (told.exchange(true)) return;
    tell(fmt::format("{} cannot be locked ({}): make sure that no other fumon works there\n",
                     named.string(), std::generic_category().message(reason)));
}

}  // namespace fumon
