#include "support/preload/counted_calls.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace fumon::test {

namespace {

const char* setting(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// Whether an operation can fail for want of space.
bool takes_space(Call call) {
    return call == Call::create || call == Call::write || call == Call::allocate ||
           call == Call::folder;
}

}  // namespace

CallState& state() {
    static CallState* const made = [] {
        auto* now = new CallState;
        now->error = EIO;
        now->folder = setting("FUMON_CALLS_FOLDER");
        now->fail = std::atoll(setting("FUMON_CALLS_FAIL"));
        if (*setting("FUMON_CALLS_ERRNO") != '\0')
            now->error = std::atoi(setting("FUMON_CALLS_ERRNO"));
        now->lasting = *setting("FUMON_CALLS_LASTING") == '1';
        now->report = &now->none;
        const auto open_raw = [](const char* file, long flags) {
            return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, file, flags, 0600));
        };
        if (*setting("FUMON_CALLS_REPORT") != '\0') {
            const int file = open_raw(setting("FUMON_CALLS_REPORT"), O_RDWR | O_CREAT | O_CLOEXEC);
            void* at = MAP_FAILED;
            if (file >= 0 && ::syscall(SYS_ftruncate, file, sizeof(CallReport)) == 0)
                at = ::mmap(nullptr, sizeof(CallReport), PROT_READ | PROT_WRITE, MAP_SHARED, file,
                            0);
            if (at != MAP_FAILED) now->report = static_cast<CallReport*>(at);
            ::syscall(SYS_close, file);
        }
        if (*setting("FUMON_CALLS_LOG") != '\0')
            now->log =
                open_raw(setting("FUMON_CALLS_LOG"), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC);
        return now;
    }();
    return *made;
}

std::string absolute(const char* path) {
    std::string whole = path;
    if (whole.empty() || whole.front() != '/') {
        std::vector<char> here(4096);
        if (::getcwd(here.data(), here.size()) == nullptr) return whole;
        whole = std::string(here.data()) + "/" + whole;
    }
    std::vector<std::string> parts;
    std::size_t at = 0;
    while (at < whole.size()) {
        const std::size_t end = std::min(whole.find('/', at), whole.size());
        const std::string part = whole.substr(at, end - at);
        at = end + 1;
        if (part == "..") {
            if (!parts.empty()) parts.pop_back();
        } else if (!part.empty() && part != ".") {
            parts.push_back(part);
        }
    }
    std::string result;
    for (const std::string& part : parts) result += "/" + part;
    return result;
}

bool is_inside(const std::string& path) {
    const std::string& folder = state().folder;
    return !folder.empty() && path.starts_with(folder) &&
           (path.size() == folder.size() || path[folder.size()] == '/');
}

bool fails(Call call, const std::string& path) {
    CallState& now = state();
    if (call == Call::remove && now.report->failed == 0) return false;
    const std::int64_t number = ++now.report->calls;
    if (now.fail == 0 || number < now.fail) return false;
    const bool can = now.error != ENOSPC || takes_space(call);
    if (number == now.fail ? !can : !can || !now.lasting) return false;
    if (now.report->failed == 0) {
        now.report->failed = number;
        std::snprintf(now.report->what, sizeof now.report->what, "%s %s", name_of(call),
                      path.c_str() + std::min(path.size(), now.folder.size()));
    }
    errno = now.error;
    return true;
}

void log(Call call, const std::string& path, const std::string& other, std::int64_t file,
         std::int64_t offset, const void* data, std::size_t count) {
    CallState& now = state();
    if (now.log < 0) return;
    const auto relative = [&](const std::string& name) {
        return name.size() > now.folder.size() ? name.substr(now.folder.size() + 1) : std::string();
    };
    const std::string entry =
        entry_of({call, relative(path), relative(other), file, offset,
                  std::string(static_cast<const char*>(data), data == nullptr ? 0 : count),
                  static_cast<std::int64_t>(count)});
    ::syscall(SYS_write, now.log, entry.data(), entry.size());
}

OpenFile* open_file(int descriptor) {
    const auto found = state().files.find(descriptor);
    return found == state().files.end() ? nullptr : &found->second;
}

}  // namespace fumon::test
