// A library to preload (LD_PRELOAD) into a program under test, so that its file operations can be
// counted, made to fail, and logged, whichever library calls them. Only operations on what lies in
// one folder count. It reads these from the environment:
//
//     FUMON_CALLS_FOLDER   the folder, absolute, with no links in it; without it nothing is done
//     FUMON_CALLS_REPORT   a file that gets a CallReport (call_report.h): how many there were, and
//                          which one failed
//     FUMON_CALLS_FAIL     the number of the operation that fails, from 1; 0 or none: none does
//     FUMON_CALLS_ERRNO    what it fails with
//     FUMON_CALLS_LASTING  "1": so do all later ones that the errno can befall
//     FUMON_CALLS_LOG      a file that gets every operation that changes something (call_log.h)
//
// A write that fails has written half its bytes; a close that fails has closed. A removal is not
// counted, and only fails after something else has.

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>

#include "support/preload/counted_calls.h"

namespace {

using fumon::test::absolute;
using fumon::test::Call;
using fumon::test::fails;
using fumon::test::is_inside;
using fumon::test::log;
using fumon::test::open_file;
using fumon::test::OpenFile;
using fumon::test::state;

/// What the library stands in front of.
struct NextFunction {
    const char* name;
    void* address = nullptr;
};
constinit std::array next_functions{std::to_array<NextFunction>(
    {{"__open64_2"},  {"__open_2"},    {"close"},     {"creat"},    {"creat64"}, {"fallocate"},
     {"fallocate64"}, {"fclose"},      {"fdatasync"}, {"fopen"},    {"fopen64"}, {"fsync"},
     {"ftruncate"},   {"ftruncate64"}, {"fwrite"},    {"link"},     {"mkdir"},   {"mkstemp"},
     {"open"},        {"open64"},      {"openat"},    {"openat64"}, {"opendir"}, {"pread"},
     {"pwrite"},      {"pwrite64"},    {"read"},      {"remove"},   {"rename"},  {"renameat"},
     {"renameat2"},   {"rmdir"},       {"unlink"},    {"unlinkat"}, {"write"},   {"writev"}})};

/// Before any operation: whoever loads a library calls some of them with the loader's lock, for
/// which dlsym() would wait with this library's.
__attribute__((constructor)) void find_next_functions() {
    for (NextFunction& function : next_functions)
        function.address = ::dlsym(RTLD_NEXT, function.name);
}

template <class Function>
Function* next(Function* /*own*/, const char* name) {
    void* address = nullptr;
    for (const NextFunction& function : next_functions)
        if (std::strcmp(function.name, name) == 0) address = function.address;
    return reinterpret_cast<Function*>(address != nullptr ? address : ::dlsym(RTLD_NEXT, name));
}
#define NEXT(name) (next(&::name, #name))

using Guard = std::lock_guard<std::recursive_mutex>;

bool writes(int flags) {
    return (flags & O_ACCMODE) != O_RDONLY;
}

template <class Open>
int opened(const char* name, int folder, int flags, const Open& open) {
    const bool known = folder == AT_FDCWD || (name != nullptr && *name == '/');
    if (state().folder.empty() || !known) return open();
    const std::string path = absolute(name);
    if (!is_inside(path)) return open();
    const Guard guard(state().mutex);
    // A file without a name: it takes space while it is made, and is not followed.
    if ((flags & O_TMPFILE) == O_TMPFILE) return fails(Call::create, path) ? -1 : open();
    struct stat before {};
    const bool there = ::syscall(SYS_newfstatat, AT_FDCWD, path.c_str(), &before, 0) == 0;
    const bool makes = (flags & O_CREAT) != 0 && !there;
    if (fails(makes ? Call::create : Call::open, path)) return -1;
    const int descriptor = open();
    if (descriptor < 0) return descriptor;
    const std::int64_t number = ++state().opened;
    state().files[descriptor] = {path, number};
    if (makes || writes(flags)) log(Call::create, path, "", number, makes ? 1 : 0, nullptr, 0);
    if (there && (flags & O_TRUNC) != 0) log(Call::truncate, path, "", number, 0, nullptr, 0);
    return descriptor;
}

mode_t mode_of(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

template <class Open>
FILE* opened_stream(const char* name, const char* mode, const Open& open) {
    FILE* stream = nullptr;
    const int flags = *mode == 'r' && std::strchr(mode, '+') == nullptr ? O_RDONLY
                      : *mode == 'w'                                    ? O_RDWR | O_CREAT | O_TRUNC
                                                                        : O_RDWR | O_CREAT;
    opened(name, AT_FDCWD, flags, [&] {
        stream = open();
        return stream == nullptr ? -1 : ::fileno(stream);
    });
    return stream;
}

template <class Write>
ssize_t written(int descriptor, const void* data, std::size_t count, off_t offset,
                const Write& write) {
    if (state().folder.empty()) return write(data, count, offset);
    const Guard guard(state().mutex);
    const OpenFile* file = open_file(descriptor);
    if (file == nullptr) return write(data, count, offset);
    const off_t at = offset >= 0 ? offset : ::lseek(descriptor, 0, SEEK_CUR);
    if (fails(Call::write, file->path)) {
        const int error = errno;
        if (count > 1) {
            const ssize_t half = write(data, count / 2, offset);
            if (half > 0)
                log(Call::write, file->path, "", file->number, at, data,
                    static_cast<std::size_t>(half));
        }
        errno = error;
        return -1;
    }
    const ssize_t done = write(data, count, offset);
    if (done > 0)
        log(Call::write, file->path, "", file->number, at, data, static_cast<std::size_t>(done));
    return done;
}

template <class Work>
int on_descriptor(Call call, int descriptor, std::int64_t offset, const Work& work) {
    if (state().folder.empty()) return work();
    const Guard guard(state().mutex);
    const OpenFile* file = open_file(descriptor);
    if (file == nullptr) return work();
    if (fails(call, file->path)) return -1;
    const int status = work();
    const int error = errno;
    if (status == 0 && call != Call::allocate)
        log(call, file->path, "", file->number, offset, nullptr, 0);
    errno = error;
    return status;
}

template <class Work>
int on_path(Call call, const char* name, const char* other, const Work& work) {
    if (state().folder.empty()) return work();
    const std::string path = absolute(name);
    const std::string second = other == nullptr ? "" : absolute(other);
    if (!is_inside(path) && (second.empty() || !is_inside(second))) return work();
    const Guard guard(state().mutex);
    if (fails(call, path)) return -1;
    const int status = work();
    const int error = errno;
    if (status == 0) log(call, path, second, 0, 0, nullptr, 0);
    errno = error;
    return status;
}

template <class Work>
int closed(int descriptor, const Work& work) {
    if (state().folder.empty()) return work();
    const Guard guard(state().mutex);
    const OpenFile* file = open_file(descriptor);
    if (file == nullptr) return work();
    const std::string path = file->path;
    state().files.erase(descriptor);
    if (!fails(Call::close, path)) return work();
    const int error = errno;
    work();
    errno = error;
    return -1;
}

}  // namespace

extern "C" {

#define FUMON_OPEN(name)                                                                     \
    int name(const char* path, int flags, ...) {                                             \
        va_list arguments;                                                                   \
        va_start(arguments, flags);                                                          \
        const mode_t mode = mode_of(flags, arguments);                                       \
        va_end(arguments);                                                                   \
        return opened(path, AT_FDCWD, flags, [&] { return NEXT(name)(path, flags, mode); }); \
    }
FUMON_OPEN(open)
FUMON_OPEN(open64)

#define FUMON_OPENAT(name)                                                                         \
    int name(int folder, const char* path, int flags, ...) {                                       \
        va_list arguments;                                                                         \
        va_start(arguments, flags);                                                                \
        const mode_t mode = mode_of(flags, arguments);                                             \
        va_end(arguments);                                                                         \
        return opened(path, folder, flags, [&] { return NEXT(name)(folder, path, flags, mode); }); \
    }
FUMON_OPENAT(openat)
FUMON_OPENAT(openat64)

int __open_2(const char* path, int flags);
int __open_2(const char* path, int flags) {
    return opened(path, AT_FDCWD, flags, [&] { return NEXT(__open_2)(path, flags); });
}
int __open64_2(const char* path, int flags);
int __open64_2(const char* path, int flags) {
    return opened(path, AT_FDCWD, flags, [&] { return NEXT(__open64_2)(path, flags); });
}
int mkstemp(char* path) {
    int made = -1;
    opened((std::string(path) + "~").c_str(), AT_FDCWD, O_RDWR | O_CREAT, [&] {
        made = NEXT(mkstemp)(path);
        return -1;  // not followed
    });
    return made;
}
int creat(const char* path, mode_t mode) {
    return opened(path, AT_FDCWD, O_WRONLY | O_CREAT | O_TRUNC,
                  [&] { return NEXT(creat)(path, mode); });
}
int creat64(const char* path, mode_t mode) {
    return opened(path, AT_FDCWD, O_WRONLY | O_CREAT | O_TRUNC,
                  [&] { return NEXT(creat64)(path, mode); });
}
FILE* fopen(const char* path, const char* mode) {
    return opened_stream(path, mode, [&] { return NEXT(fopen)(path, mode); });
}
FILE* fopen64(const char* path, const char* mode) {
    return opened_stream(path, mode, [&] { return NEXT(fopen64)(path, mode); });
}
DIR* opendir(const char* path) {
    DIR* folder = nullptr;
    on_path(Call::open, path, nullptr, [&] {
        folder = NEXT(opendir)(path);
        return -1;  // nothing to log
    });
    return folder;
}
ssize_t write(int descriptor, const void* data, size_t count) {
    return written(descriptor, data, count, -1, [&](const void* from, std::size_t bytes, off_t) {
        return NEXT(write)(descriptor, from, bytes);
    });
}
ssize_t pwrite(int descriptor, const void* data, size_t count, off_t offset) {
    return written(descriptor, data, count, offset,
                   [&](const void* from, std::size_t bytes, off_t at) {
                       return NEXT(pwrite)(descriptor, from, bytes, at);
                   });
}
ssize_t pwrite64(int descriptor, const void* data, size_t count, off64_t offset) {
    return written(descriptor, data, count, offset,
                   [&](const void* from, std::size_t bytes, off_t at) {
                       return NEXT(pwrite64)(descriptor, from, bytes, at);
                   });
}
ssize_t writev(int descriptor, const iovec* parts, int count) {
    if (state().folder.empty() || open_file(descriptor) == nullptr)
        return NEXT(writev)(descriptor, parts, count);
    std::string all;
    for (int i = 0; i < count; ++i)
        all.append(static_cast<const char*>(parts[i].iov_base), parts[i].iov_len);
    return ::write(descriptor, all.data(), all.size());
}
size_t fwrite(const void* data, size_t size, size_t count, FILE* stream) {
    if (state().folder.empty() || open_file(::fileno(stream)) == nullptr)
        return NEXT(fwrite)(data, size, count, stream);
    ::fflush(stream);
    const ssize_t done = ::write(::fileno(stream), data, size * count);
    return done < 0 ? 0 : static_cast<std::size_t>(done) / (size == 0 ? 1 : size);
}
ssize_t read(int descriptor, void* data, size_t count) {
    if (!state().folder.empty()) {
        const Guard guard(state().mutex);
        const OpenFile* file = open_file(descriptor);
        if (file != nullptr && fails(Call::read, file->path)) return -1;
    }
    return NEXT(read)(descriptor, data, count);
}
ssize_t pread(int descriptor, void* data, size_t count, off_t offset) {
    if (!state().folder.empty()) {
        const Guard guard(state().mutex);
        const OpenFile* file = open_file(descriptor);
        if (file != nullptr && fails(Call::read, file->path)) return -1;
    }
    return NEXT(pread)(descriptor, data, count, offset);
}
int fsync(int descriptor) {
    return on_descriptor(Call::sync, descriptor, 0, [&] { return NEXT(fsync)(descriptor); });
}
int fdatasync(int descriptor) {
    return on_descriptor(Call::sync, descriptor, 0, [&] { return NEXT(fdatasync)(descriptor); });
}
int ftruncate(int descriptor, off_t length) {
    return on_descriptor(Call::truncate, descriptor, length,
                         [&] { return NEXT(ftruncate)(descriptor, length); });
}
int ftruncate64(int descriptor, off64_t length) {
    return on_descriptor(Call::truncate, descriptor, length,
                         [&] { return NEXT(ftruncate64)(descriptor, length); });
}
int fallocate(int descriptor, int mode, off_t offset, off_t count) {
    return on_descriptor(Call::allocate, descriptor, 0,
                         [&] { return NEXT(fallocate)(descriptor, mode, offset, count); });
}
int fallocate64(int descriptor, int mode, off64_t offset, off64_t count) {
    return on_descriptor(Call::allocate, descriptor, 0,
                         [&] { return NEXT(fallocate64)(descriptor, mode, offset, count); });
}
int close(int descriptor) {
    return closed(descriptor, [&] { return NEXT(close)(descriptor); });
}
int fclose(FILE* stream) {
    return closed(::fileno(stream), [&] { return NEXT(fclose)(stream); });
}
int rename(const char* from, const char* to) noexcept {
    return on_path(Call::rename, from, to, [&] { return NEXT(rename)(from, to); });
}
int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
    return on_path(Call::rename, from, to,
                   [&] { return NEXT(renameat)(from_folder, from, to_folder, to); });
}
int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
    return on_path(Call::rename, from, to,
                   [&] { return NEXT(renameat2)(from_folder, from, to_folder, to, flags); });
}
int link(const char* from, const char* to) noexcept {
    return on_path(Call::link, from, to, [&] { return NEXT(link)(from, to); });
}
int unlink(const char* path) noexcept {
    return on_path(Call::remove, path, nullptr, [&] { return NEXT(unlink)(path); });
}
int unlinkat(int folder, const char* path, int flags) noexcept {
    return on_path(Call::remove, path, nullptr,
                   [&] { return NEXT(unlinkat)(folder, path, flags); });
}
int remove(const char* path) noexcept {
    return on_path(Call::remove, path, nullptr, [&] { return NEXT(remove)(path); });
}
int rmdir(const char* path) noexcept {
    return on_path(Call::remove, path, nullptr, [&] { return NEXT(rmdir)(path); });
}
int mkdir(const char* path, mode_t mode) noexcept {
    return on_path(Call::folder, path, nullptr, [&] { return NEXT(mkdir)(path, mode); });
}

}  // extern "C"
