#include "run/status_line.h"

#include <unistd.h>

#include <cstdio>

#include "base/tell.h"

namespace fumon {

namespace {

constexpr std::chrono::milliseconds between_live_lines{200};
constexpr std::chrono::seconds between_log_lines{10};

}  // namespace

StatusLine::StatusLine(Verbosity verbosity)
    : verbosity_(verbosity), live_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() {
    clear();
}

bool StatusLine::due() const {
    if (verbosity_ == Verbosity::quiet) return false;
    const auto since = Clock::now() - shown_;
    return live_ ? since >= between_live_lines : since >= between_log_lines;
}

void StatusLine::show(const std::string& text) {
    restart();
    if (live_) {
        tell("\r\033[K" + text);
        open_ = true;
    } else {
        tell(text + "\n");
    }
    std::fflush(stderr);
}

void StatusLine::restart() {
    shown_ = Clock::now();
}

void StatusLine::note(const std::string& text) {
    if (verbosity_ != Verbosity::quiet) error(text);
}

void StatusLine::verbose(const std::string& text) {
    if (verbosity_ == Verbosity::verbose) error(text);
}

void StatusLine::error(const std::string& text) {
    clear();
    tell(text + "\n");
}

void StatusLine::clear() {
    if (!open_) return;
    tell("\r\033[K");
    std::fflush(stderr);
    open_ = false;
}

}  // namespace fumon
