#include "files/lock_descriptor.h"

#include <fmt/format.h>
#include <sys/file.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "base/standard_error.h"

namespace fumon {

bool lock_descriptor(int descriptor, const std::filesystem::path& named) {
    int reason = 0;
    do {
        reason = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    } while (reason == EINTR);
    if (reason == EWOULDBLOCK) return false;
    if (reason != 0) warn_not_locked(named, reason);
    return true;
}

void warn_not_locked(const std::filesystem::path& named, int reason) {
    static std::atomic<bool> reported{false};
    if (reported.exchange(true)) return;
    print_to_stderr(
        fmt::format("{} cannot be locked ({}): make sure that no other fumon works there\n",
                    named.string(), std::generic_category().message(reason)));
}

}  // namespace fumon
