#pragma once

namespace fumon {

/// From now on a crash of this process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) is reported in
/// one line on standard error before the process ends. Under a limit on memory (RLIMIT_AS, `ulimit
/// -v`) it ends with status 1: OpenGL drivers crash where memory ends, and cannot be kept from
/// that. Otherwise it ends as crashes do, with the signal. Sanitizers report more themselves; in
/// their builds this does nothing.
void explain_crashes();

}  // namespace fumon
