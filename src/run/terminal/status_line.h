#pragma once

#include <string>

#include "base/stopwatch.h"

namespace fumon {

class JobWatch;

enum class Verbosity { quiet, normal, verbose };

/// Progress on standard error: one line that is rewritten on a terminal, a plain line now and then
/// elsewhere, and messages above it. Used by one thread.
class StatusLine {
  public:
    /// `watch` hears all messages, too; it outlives this.
    explicit StatusLine(Verbosity verbosity, JobWatch* watch = nullptr);
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

    /// Who watches the job; nullptr: nobody may.
    [[nodiscard]] JobWatch* watch() const { return watch_; }

  private:
    Verbosity verbosity_;
    JobWatch* watch_;
    bool live_;
    Stopwatch since_shown_;
    bool open_ = false;
};

}  // namespace fumon
