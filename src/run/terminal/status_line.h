#pragma once

#include <string>

#include "base/stopwatch.h"

namespace fumon {

enum class Verbosity { quiet, normal, verbose };

/// Standard error while something is under way: one live line on a terminal, a plain line now and
/// then elsewhere, and lasting lines above it. Used by one thread.
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

    /// A lasting line, above the live one.
    void note(const std::string& text);     ///< unless quiet
    void verbose(const std::string& text);  ///< only when verbose
    void error(const std::string& text);    ///< always

    /// Takes the live line away.
    void clear();

  private:
    Verbosity verbosity_;
    bool live_;
    Stopwatch since_shown_;
    bool open_ = false;
};

}  // namespace fumon
