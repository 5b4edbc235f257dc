#include "run/terminal/status_line.h"

#include <unistd.h>

#include <cstdio>

#include "base/standard_error.h"
#include "run/terminal/job_watch.h"

namespace fumon {

namespace {

constexpr double live_line_interval_s = 0.2;  // seconds
constexpr double log_line_interval_s = 10.0;

}  // namespace

StatusLine::StatusLine(Verbosity verbosity, JobWatch* watch)
    : verbosity_(verbosity), watch_(watch), live_(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() {
    clear();
}

bool StatusLine::due() const {
    if (verbosity_ == Verbosity::quiet) return false;
    return since_shown_.seconds() >= (live_ ? live_line_interval_s : log_line_interval_s);
}

void StatusLine::show(const std::string& text) {
    restart();
    if (live_) {
        print_to_stderr("\r\033[K" + text);
        open_ = true;
    } else {
        print_to_stderr(text + "\n");
    }
    std::fflush(stderr);
}

void StatusLine::restart() {
    since_shown_ = {};
}

void StatusLine::note(const std::string& text) {
    if (verbosity_ != Verbosity::quiet) {
        error(text);
    } else if (watch_ != nullptr) {
        watch_->message(text);
    }
}

void StatusLine::verbose(const std::string& text) {
    if (verbosity_ == Verbosity::verbose) error(text);
}

void StatusLine::error(const std::string& text) {
    clear();
    print_to_stderr(text + "\n");
    if (watch_ != nullptr) watch_->message(text);
}

void StatusLine::clear() {
    if (!open_) return;
    print_to_stderr("\r\033[K");
    std::fflush(stderr);
    open_ = false;
}

}  // namespace fumon
