#pragma once

#include <unistd.h>

#include "base/error.h"

namespace fumon::python {

/// The process in which something with threads was made. A fork copies the thing and not its
/// threads.
class Process {
  public:
    /// Whether this still is that process.
    [[nodiscard]] bool is_this() const { return process_ == getpid(); }

    /// Throws Error in a fork of that process.
    void check() const {
        if (is_this()) return;
        throw Error(
            "this process was forked from one in which fumon had begun this work, and threads do "
            "not follow a fork; begin it in the child, or let multiprocessing start processes by "
            "\"spawn\"");
    }

  private:
    pid_t process_ = getpid();
};

}  // namespace fumon::python
