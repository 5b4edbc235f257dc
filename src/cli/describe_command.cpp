#include <cstdio>
#include <string>

#include "cli/command.h"
#include "film/film_keys.h"
#include "scene/describe.h"

namespace fumon {

namespace {

struct DescribeOptions {
    std::string what;
    bool as_json = false;
};

void declare(CLI::App& command, DescribeOptions& options) {
    command.add_option(
        "WHAT", options.what,
        "\"scene\" (the keys of every scene), \"film\" or a model; nothing: all of scenes");
    command.add_flag("--json", options.as_json, "as JSON");
}

int perform(const DescribeOptions& options) {
    if (options.what == "film") {
        std::fputs((options.as_json ? describe_film_json() : describe_film()).c_str(), stdout);
        return 0;
    }
    const std::string text =
        options.as_json ? describe_json(options.what) : describe_text(options.what);
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace

Command describe_command() {
    return make_command<DescribeOptions>(
        "describe", "list scene keys with type, unit, default and range", declare, perform);
}

}  // namespace fumon
