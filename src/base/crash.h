#pragma once

namespace fumon {

/// From now on a crash of this process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) is told in a line
/// on standard error before it ends. Under a limit on memory (RLIMIT_AS, `ulimit -v`) it ends with
/// status 1: OpenGL drivers crash where memory ends, and cannot be kept from that. Otherwise it
/// ends as crashes do, with the signal. Sanitizers tell more themselves: in their builds this does
/// nothing.
void explain_crashes();

}  // namespace fumon
