#pragma once

#include <string_view>

namespace fumon {

/// What is said where memory ends.
inline constexpr std::string_view out_of_memory =
    "fumon: out of memory; a smaller grid or picture needs less\n";

/// From now on a crash of this process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) is reported in
/// one line on standard error before the process ends. Under a limit on memory (RLIMIT_AS, `ulimit
/// -v`), and where the system grants no more memory than it has, it ends with status 3: OpenGL
/// drivers, and some other libraries, crash where memory ends, and cannot be kept from that.
/// Otherwise it ends as crashes do, with the signal. Where memory ends in a function that may not
/// throw, out_of_memory is said and the status is 3. Sanitizers report more themselves; in their
/// builds this does nothing.
void install_crash_reports();

/// Whether a request for memory by `new` has failed since install_crash_reports().
bool memory_exhausted();

}  // namespace fumon
