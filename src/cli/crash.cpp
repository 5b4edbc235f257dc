#include "cli/crash.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <string>

namespace fumon {

namespace {

struct Crash {
    int signal;
    const char* name;
};
constexpr std::array<Crash, 5> crashes{{{SIGSEGV, "segmentation fault"},
                                        {SIGBUS, "bus error"},
                                        {SIGFPE, "arithmetic fault"},
                                        {SIGILL, "illegal instruction"},
                                        {SIGABRT, "abort"}}};

// A handler may neither allocate nor format: all is ready before.
std::array<std::string, crashes.size()> lines;
bool memory_is_limited = false;

extern "C" void tell_crash(int signal) {
    for (std::size_t i = 0; i < crashes.size(); ++i) {
        if (crashes[i].signal != signal) continue;
        [[maybe_unused]] const ssize_t written =
            ::write(STDERR_FILENO, lines[i].data(), lines[i].size());
    }
    constexpr int failed_while_working = 1;
    if (memory_is_limited) ::_exit(failed_while_working);
}

}  // namespace

void explain_crashes() {
#ifndef FUMON_SANITIZED
    rlimit memory{};
    memory_is_limited = ::getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY;
    for (std::size_t i = 0; i < crashes.size(); ++i) {
        lines[i] = memory_is_limited
                       ? fmt::format(
                             "fumon: crashed ({}) under a limit of {} MB on its memory, "
                             "as OpenGL drivers do where memory ends; raise the limit "
                             "(ulimit -v) or make the picture smaller\n",
                             crashes[i].name, memory.rlim_cur / 1'000'000)
                       : fmt::format(
                             "fumon: crashed ({}); please report it with the command and "
                             "the scene. Files under their final names are whole\n",
                             crashes[i].name);
        struct sigaction action {};
        action.sa_handler = tell_crash;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        ::sigaction(crashes[i].signal, &action, nullptr);
    }
#endif
}

}  // namespace fumon
