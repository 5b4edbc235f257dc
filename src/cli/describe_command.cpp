#include <cstdio>
#include <string>

#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "film/script/film_keys.h"
#include "foreign/open_run.h"
#include "scene/describe.h"

namespace fumon {

namespace {

struct DescribeOptions {
    std::string what;
    bool as_json = false;
    ForeignQuery foreign;
};

void declare(CLI::App& command, DescribeOptions& options) {
    command.add_option("WHAT", options.what,
                       "a section or a key of scenes or films, a model, or scene, figure, overlay, "
                       "film or all; nothing: one page on all; or the results of another model "
                       "(NetCDF, or 'PATTERN*' of files): what of them is recognised, as what");
    command.add_flag("--json", options.as_json, "as JSON (of everything where WHAT is left out)");
    add_foreign_options(command, options.foreign);
    add_examples(command,
                 {{"fumon describe", "every section with the names of its keys"},
                  {"fumon describe camera", "the keys of a section"},
                  {"fumon describe look.palette", "one key"},
                  {"fumon describe sand", "the keys of a model"},
                  {"fumon describe dunes --json", "the same for a program"}},
                 "`fumon describe flood.nc` tells what the results of another model hold.");
}

/// What is said of a part of films alone; empty where it is none.
std::string film_description(const DescribeOptions& options) {
    const std::string part = options.what == "film" ? "" : options.what;
    const std::string text = describe_film(part);
    return text.empty() || !options.as_json ? text : describe_film_json(part);
}

std::string description(const DescribeOptions& options) {
    if (options.what == "film") return film_description(options);
    if (options.what.empty() && !options.as_json) return describe_summary();
    try {
        return options.as_json ? describe_json(options.what) : describe_text(options.what);
    } catch (const InputError&) {
        std::string text = film_description(options);
        if (text.empty()) throw;
        return text;
    }
}

int perform(const DescribeOptions& options) {
    if (is_foreign_run(options.what)) {
        if (options.as_json) throw InputError("--json: belongs to keys; leave it out for a file");
        std::fputs(foreign_description(open_foreign_run(options.what, options.foreign)).c_str(),
                   stdout);
        return 0;
    }
    std::fputs(description(options).c_str(), stdout);
    return 0;
}

}  // namespace

Command describe_command() {
    return make_command<DescribeOptions>(
        "describe", "tell of scene keys: type, unit, range, default, role", declare, perform);
}

}  // namespace fumon
