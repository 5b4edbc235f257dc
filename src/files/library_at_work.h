#pragma once

namespace fumon {

/// While one lives, a crash of this thread is laid to a library that is known to crash where the
/// machine fails: it is told with this line, and the status is 1.
class LibraryAtWork {
  public:
    /// `line` must outlive it.
    explicit LibraryAtWork(const char* line);
    ~LibraryAtWork();
    LibraryAtWork(const LibraryAtWork&) = delete;
    LibraryAtWork& operator=(const LibraryAtWork&) = delete;
};

/// The line of the one that lives in this thread; none: nullptr. May be asked in a signal's
/// handler.
const char* line_of_library_at_work();

}  // namespace fumon
