// The memory that OpenGL drivers take by posix_memalign(). Mesa's llvmpipe fills each texture and
// target with zeros as it makes it, so the system is asked for all of a large one's pages at once:
// one by one, each at the first access to it, they cost half as much again. A program of its own
// may replace functions of the C library (the GNU C library's manual, "Replacing malloc"); this one
// goes back to the library's own.

#include <cstdlib>  // which says whose C library it is

#if defined(__GLIBC__) && !defined(FUMON_SANITIZED)

#include <malloc.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>

#ifndef MADV_POPULATE_WRITE
#define MADV_POPULATE_WRITE 23  // since Linux 5.14; older ones refuse it, and nothing is lost
#endif

namespace {

constexpr std::size_t large = std::size_t{1} << 20;  // bytes
constexpr std::uintptr_t page = 4096;

/// Maps the pages that lie within it as a whole.
void map_pages(void* memory, std::size_t size) {
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + page - 1) / page * page;
    const std::uintptr_t last = (begin + size) / page * page;
    const int before = errno;
    madvise(reinterpret_cast<void*>(first), last - first, MADV_POPULATE_WRITE);
    errno = before;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] int posix_memalign(void** memory, std::size_t alignment,
                                                             std::size_t size) noexcept {
    const bool power_of_two = alignment != 0 && (alignment & (alignment - 1)) == 0;
    if (!power_of_two || alignment % sizeof(void*) != 0) return EINVAL;
    const int before = errno;
    void* found = memalign(alignment, size);
    errno = before;
    if (found == nullptr) return ENOMEM;
    if (size >= large) map_pages(found, size);
    *memory = found;
    return 0;
}

#endif
