#include "cli/remark.h"

#include "base/standard_error.h"

namespace fumon {

namespace {

bool quiet = false;

}  // namespace

void make_no_remarks() {
    quiet = true;
}

bool makes_no_remarks() {
    return quiet;
}

void remark(const std::string& text) {
    if (!quiet) print_to_stderr(text);
}

void add_quiet(CLI::App& command) {
    command.add_flag_callback("-q,--quiet", make_no_remarks, "print errors only");
}

}  // namespace fumon
