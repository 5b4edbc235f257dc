#pragma once

namespace fumon {

/// While one lives, a crash of this thread is laid to a library that is known to crash where the
/// machine fails: it is told with this line, and the status is 1.
class ActiveLibrary {
  public:
    /// `line` must outlive it.
    explicit ActiveLibrary(const char* line);
    ~ActiveLibrary();
    ActiveLibrary(const ActiveLibrary&) = delete;
    ActiveLibrary& operator=(const ActiveLibrary&) = delete;
};

/// The line of the one that lives in this thread; none: nullptr. May be asked in a signal's
/// handler.
const char* active_library_line();

}  // namespace fumon
