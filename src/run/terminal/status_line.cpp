#include "run/terminal/status_line.h"

#include <unistd.h>

#include <cstdio>

#include "base/tell.h"

namespace fumon {

namespace {

constexpr double between_live_lines = 0.2;  // seconds
constexpr double between_log_lines = 10.0;

}  // namespace

StatusLine::StatusLine(Verbosity verbosity)
    : verbosity_(verbosity), live_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() {
    clear();
}

bool StatusLine::due() const {
    if (verbosity_ == Verbosity::quiet) return false;
    return since_shown_.seconds() >= (live_ ? between_live_lines : between_log_lines);
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
    since_shown_ = {};
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
