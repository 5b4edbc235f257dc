#include "base/platform.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <system_error>

#ifdef __APPLE__
#include <mach-o/dyld.h>
#include <mach/mach.h>
#else
#include <sys/auxv.h>
#endif

namespace fumon::platform {

namespace {

bool begins_as_one(std::string_view name, const std::vector<std::string_view>& prefixes) {
    return std::ranges::any_of(prefixes,
                               [&](std::string_view prefix) { return name.starts_with(prefix); });
}

}  // namespace

std::filesystem::path file_with(const void* address) {
    Dl_info found{};
    if (dladdr(address, &found) == 0 || found.dli_fname == nullptr) return {};
    std::error_code ignored;
    return std::filesystem::canonical(found.dli_fname, ignored);
}

#ifdef __APPLE__  // written from Apple's documentation, never tried: see the guide's page on
                  // platforms

std::filesystem::path program_file() {
    std::uint32_t size = 0;
    _NSGetExecutablePath(nullptr, &size);
    std::string path(size, '\0');
    if (_NSGetExecutablePath(path.data(), &size) != 0) return {};
    std::error_code ignored;
    return std::filesystem::canonical(path.c_str(), ignored);
}

std::size_t longest_thread_name() {
    return 63;
}

void name_this_thread(const std::string& name) {
    pthread_setname_np(name.c_str());
}

double cpu_seconds_of_threads(const std::vector<std::string_view>& name_prefixes) {
    thread_act_array_t threads = nullptr;
    mach_msg_type_number_t count = 0;
    if (task_threads(mach_task_self(), &threads, &count) != KERN_SUCCESS) return 0.0;
    double total = 0.0;
    for (mach_msg_type_number_t n = 0; n < count; ++n) {
        std::array<char, 64> name{};
        pthread_t thread = pthread_from_mach_thread_np(threads[n]);
        if (thread != pthread_t{}) pthread_getname_np(thread, name.data(), name.size());
        thread_basic_info_data_t info{};
        mach_msg_type_number_t length = THREAD_BASIC_INFO_COUNT;
        const bool known =
            begins_as_one(name.data(), name_prefixes) &&
            thread_info(threads[n], THREAD_BASIC_INFO, reinterpret_cast<thread_info_t>(&info),
                        &length) == KERN_SUCCESS;
        if (known) {
            total += info.user_time.seconds + info.system_time.seconds +
                     1e-6 * (info.user_time.microseconds + info.system_time.microseconds);
        }
        mach_port_deallocate(mach_task_self(), threads[n]);
    }
    vm_deallocate(mach_task_self(), reinterpret_cast<vm_address_t>(threads),
                  count * sizeof(thread_act_t));
    return total;
}

long long unit_of_peak_memory() {
    return 1;
}

bool counts_memory() {
    return false;
}

#else

namespace {

/// From the scheduler's nanoseconds, or, on kernels without them, from the clock ticks.
double cpu_seconds_of_task(const std::filesystem::path& task) {
    double nanoseconds = 0.0;
    if (std::ifstream(task / "schedstat") >> nanoseconds) return 1e-9 * nanoseconds;
    std::string line;
    std::getline(std::ifstream(task / "stat"), line);
    std::istringstream fields(line.substr(std::min(line.size(), line.rfind(')') + 1)));
    std::string skipped;
    constexpr int fields_before_user_time = 11;  // after the name in parentheses, see proc(5)
    for (int field = 0; field < fields_before_user_time; ++field) fields >> skipped;
    double user_ticks = 0.0;
    double system_ticks = 0.0;
    fields >> user_ticks >> system_ticks;
    return (user_ticks + system_ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

std::filesystem::path program_file() {
    std::error_code ignored;
    auto file = std::filesystem::read_symlink("/proc/self/exe", ignored);
    if (!file.empty()) return file;
    // Without /proc, as in a bare change of root: what the kernel was told to execute.
    const auto* const executed = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
    if (executed == nullptr) return {};
    return std::filesystem::canonical(executed, ignored);
}

std::size_t longest_thread_name() {
    return 15;
}

void name_this_thread(const std::string& name) {
    pthread_setname_np(pthread_self(), name.c_str());
}

double cpu_seconds_of_threads(const std::vector<std::string_view>& name_prefixes) {
    double total = 0.0;
    std::error_code gone;  // threads may end while we look
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", gone)) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        if (begins_as_one(name, name_prefixes)) total += cpu_seconds_of_task(task.path());
    }
    return total;
}

long long unit_of_peak_memory() {
    return 1024;
}

bool counts_memory() {
    const int file = ::open("/proc/sys/vm/overcommit_memory", O_RDONLY | O_CLOEXEC);
    char mode = '0';
    if (file >= 0) {
        if (::read(file, &mode, 1) != 1) mode = '0';
        ::close(file);
    }
    return mode == '2';
}

#endif

}  // namespace fumon::platform
