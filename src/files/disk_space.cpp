#include "files/disk_space.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace fumon {

namespace {

std::int64_t length_of(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 ? static_cast<std::int64_t>(status.st_size) : 0;
}

bool exceeds_own_limit(std::int64_t length) {
    rlimit limit{};
    return ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
           static_cast<rlim_t>(length) > limit.rlim_cur;
}

}  // namespace

int reserve_space(int descriptor, std::int64_t bytes) {
    const std::int64_t length = length_of(descriptor);
    if (exceeds_own_limit(length + bytes)) return EFBIG;
#ifdef FALLOC_FL_KEEP_SIZE  // elsewhere a full disk shows when it is written to
    int reason = 0;
    do {
        const bool done = ::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, length, bytes) == 0;
        reason = done ? 0 : errno;
    } while (reason == EINTR);
    const bool no_room = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
    return no_room ? reason : 0;
#else
    return 0;
#endif
}

void release_space(int descriptor) {
    const std::int64_t length = length_of(descriptor);
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor, length);  // a fault keeps space
}

}  // namespace fumon
