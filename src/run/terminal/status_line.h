#pragma once

#include <string>

#include "base/stopwatch.h"

namespace fumon {

enum class Verbosity { quiet, normal, verbose };

/// Progress on standard error: one line that is rewritten on a terminal, a plain line now and then
/// elsewhere, and messages above it. Used by one thread.
class StatusLine {
  public:
    explicit StatusLine(Verbosity verbosity);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// Whether it is time to show it again; counted from the last time or from restart().
    [[nodiscard]] bool due() const;
    void show(const std::string& text);
    void restart();

    /// Prints a message above the progress line.
    void note(const std::string& text);     ///< unless quiet
    void verbose(const std::string& text);  ///< only when verbose
    void error(const std::string& text);    ///< always

    /// Clears the progress line.
    void clear();

  private:
    Verbosity verbosity_;
    bool live_;
    Stopwatch since_shown_;
    bool open_ = false;
};

}  // namespace fumon
