#include "base/thread_clock.h"

#include <sys/resource.h>

#include "base/platform.h"

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

}  // namespace

void name_this_thread(const std::string& name) {
    platform::name_this_thread(name.substr(0, platform::longest_thread_name()));
}

double cpu_seconds_of_threads(const std::vector<std::string_view>& name_prefixes) {
    return platform::cpu_seconds_of_threads(name_prefixes);
}

double cpu_seconds_of_process() {
    const rusage usage = usage_of_process();
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

long long peak_memory_bytes() {
    return usage_of_process().ru_maxrss * platform::unit_of_peak_memory();
}

}  // namespace fumon
