// A library to preload (LD_PRELOAD) into a program under test, so that one of its requests for
// memory fails, whichever library makes it. It reads these from the environment:
//
//     FUMON_MEMORY_AFTER   the name of a file; requests count from when one that is called so is
//                          first opened. Without it nothing is done
//     FUMON_MEMORY_FAIL    the number of the request that fails, from 1; 0 or none: none does
//     FUMON_MEMORY_REPORT  a file that gets a MemoryReport (memory_report.h)

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "support/preload/memory_report.h"

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* block, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
}

namespace {

std::atomic<bool> counting{false};
std::atomic<std::int64_t> requests{0};
std::int64_t failing = 0;
fumon::test::MemoryReport nowhere;
fumon::test::MemoryReport* report = &nowhere;

bool fails() {
    if (!counting.load(std::memory_order_relaxed)) return false;
    const std::int64_t number = ++requests;
    report->requests = number;
    if (number != failing) return false;
    report->failed = 1;
    errno = ENOMEM;
    return true;
}

/// Whether a path ends in the name from which on requests count; then they do.
void opened(const char* path) {
    if (counting || path == nullptr) return;
    const char* name = std::getenv("FUMON_MEMORY_AFTER");
    if (name == nullptr || *name == '\0') return;
    const std::size_t length = std::strlen(path);
    const std::size_t end = std::strlen(name);
    if (length < end || std::strcmp(path + length - end, name) != 0) return;
    const char* number = std::getenv("FUMON_MEMORY_FAIL");
    if (number != nullptr) failing = std::atoll(number);
    const char* to = std::getenv("FUMON_MEMORY_REPORT");
    if (to != nullptr) {
        const long file = ::syscall(SYS_openat, AT_FDCWD, to, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        ::syscall(SYS_ftruncate, file, sizeof nowhere);
        void* at = ::mmap(nullptr, sizeof nowhere, PROT_READ | PROT_WRITE, MAP_SHARED,
                          static_cast<int>(file), 0);
        if (at != MAP_FAILED) report = static_cast<fumon::test::MemoryReport*>(at);
        ::syscall(SYS_close, file);
    }
    counting = true;
}

template <class Function>
Function* next(Function* /*own*/, const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

void* malloc(std::size_t bytes) {
    return fails() ? nullptr : __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
    return fails() ? nullptr : __libc_calloc(count, bytes);
}
void* realloc(void* block, std::size_t bytes) {
    return fails() ? nullptr : __libc_realloc(block, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    return fails() ? nullptr : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
    if (fails()) return ENOMEM;
    *block = __libc_memalign(alignment, bytes);
    return *block == nullptr ? ENOMEM : 0;
}

#define FUMON_OPEN(name)                                \
    int name(const char* path, int flags, ...) {        \
        va_list arguments;                              \
        va_start(arguments, flags);                     \
        const int mode = va_arg(arguments, int);        \
        va_end(arguments);                              \
        opened(path);                                   \
        return next(&::name, #name)(path, flags, mode); \
    }
FUMON_OPEN(open)
FUMON_OPEN(open64)
FILE* fopen(const char* path, const char* mode) {
    opened(path);
    return next(&::fopen, "fopen")(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
    opened(path);
    return next(&::fopen64, "fopen64")(path, mode);
}

}  // extern "C"
