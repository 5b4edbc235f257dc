#include "base/thread_clock.h"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace fumon {

namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

rusage usage_of_process() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage;
}

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

void name_this_thread(const std::string& name) {
    constexpr std::size_t longest = 15;  // the kernel's limit
    pthread_setname_np(pthread_self(), name.substr(0, longest).c_str());
}

double cpu_seconds_of_threads(const std::vector<std::string_view>& name_prefixes) {
    double total = 0.0;
    std::error_code gone;  // threads may end while we look
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", gone)) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        const bool wanted =
            std::any_of(name_prefixes.begin(), name_prefixes.end(),
                        [&](std::string_view prefix) { return name.starts_with(prefix); });
        if (!wanted) continue;
        total += cpu_seconds_of_task(task.path());
    }
    return total;
}

double cpu_seconds_of_process() {
    const rusage usage = usage_of_process();
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

long long peak_memory_bytes() {
    constexpr long long bytes_per_unit = 1024;  // Linux counts in KiB
    return usage_of_process().ru_maxrss * bytes_per_unit;
}

}  // namespace fumon
