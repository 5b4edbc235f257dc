#include "run/terminal/crash.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "base/error.h"
#include "base/platform.h"
#include "files/active_library.h"
#include "gl/functions.h"

namespace fumon {

namespace {

volatile std::sig_atomic_t allocation_failed = 0;

#ifndef FUMON_SANITIZED

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
std::array<char, 1 << 16> spare_stack;

extern "C" void report_crash(int signal) {
    if (const char* library_line = active_library_line()) {
        [[maybe_unused]] const ssize_t written =
            ::write(STDERR_FILENO, library_line, std::strlen(library_line));
        ::_exit(could_not_work);
    }
    for (std::size_t i = 0; i < crashes.size(); ++i) {
        if (crashes[i].signal != signal) continue;
        [[maybe_unused]] const ssize_t written =
            ::write(STDERR_FILENO, lines[i].data(), lines[i].size());
    }
    if (memory_is_limited) ::_exit(could_not_work);
}

void note_memory_exhaustion() {
    allocation_failed = 1;
    gl::abandon_drivers();
    throw std::bad_alloc();
}

[[noreturn]] void report_out_of_memory() {
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, out_of_memory.data(), out_of_memory.size());
    ::_exit(could_not_work);
}

/// Functions that promise to throw nothing ask for memory, too.
[[noreturn]] void report_end_cause() {
    if (allocation_failed != 0) report_out_of_memory();
    std::abort();
}

#ifdef __GLIBC__
/// HDF5 ends the program where it finds no memory to begin.
void report_library_exit(int status, void* /*nothing*/) {
    constexpr int of_library = -1;
    if (status == of_library) report_out_of_memory();
}
#endif

#endif

}  // namespace

bool memory_exhausted() {
    return allocation_failed != 0;
}

void install_crash_reports() {
#ifndef FUMON_SANITIZED
    std::set_new_handler(note_memory_exhaustion);
    std::set_terminate(report_end_cause);
#ifdef __GLIBC__
    ::on_exit(report_library_exit, nullptr);
#endif
    rlimit memory{};
    const bool has_limit = ::getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY;
    memory_is_limited = has_limit || platform::counts_memory();
    const std::string limit =
        has_limit ? fmt::format("under a limit of {} MB on its memory", memory.rlim_cur / 1'000'000)
                  : "on a system that grants no more memory than it has";
    stack_t stack{};  // for the main thread, whose own may be used up
    stack.ss_sp = spare_stack.data();
    stack.ss_size = spare_stack.size();
    ::sigaltstack(&stack, nullptr);
    for (std::size_t i = 0; i < crashes.size(); ++i) {
        lines[i] = memory_is_limited
                       ? fmt::format(
                             "fumon: crashed ({}) {}, as OpenGL drivers and other libraries do "
                             "where memory ends; raise the limit (ulimit -v) or make the picture "
                             "smaller\n",
                             crashes[i].name, limit)
                       : fmt::format(
                             "fumon: crashed ({}); please report it with the command and "
                             "the scene. Files under their final names are whole\n",
                             crashes[i].name);
        struct sigaction action {};
        action.sa_handler = report_crash;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
        ::sigaction(crashes[i].signal, &action, nullptr);
    }
#endif
}

}  // namespace fumon
