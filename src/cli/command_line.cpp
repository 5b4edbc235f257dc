#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>

#include "base/cancellation.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/remark.h"
#include "cli/usage.h"
#include "run/build_identity.h"
#include "run/terminal/interrupt.h"
#include "vectors/target.h"

namespace fumon {

namespace {

constexpr const char* opening =
    "fumon simulates how wind and water shape sand and draws the result, without a display:\n"
    "a scene file goes in; frames, a movie and measurements come out.\n";

constexpr const char* examples =
    "Examples:\n"
    "  fumon run terada-barchans -o out/barchans                 frames, movie, measurements\n"
    "  fumon new barchans > my.toml                              a scene of your own, to edit\n"
    "  fumon run my.toml -o out/mine --set seed=2                a scene with one number changed\n"
    "  fumon sweep terada-barchans --seeds 10 -o out/seeds       many runs, one table\n"
    "  fumon figure sudo-2002-06 -o out/figures                  a paper's figure\n"
    "  fumon still terada-barchans --step 500 -o dunes.png       one picture of a run\n"
    "  fumon still terrain.asc -o terrain.png                    a terrain file of your own\n"
    "  fumon again dunes.png                                     the same picture from itself\n"
    "  fumon describe camera                                     the keys of a section\n\n"
    "Commands replace what fumon made, never what they read, and files of others only with "
    "--force.\n"
    "`fumon help COMMAND` says more about one command.\n";

/// All commands, and the body of the one that was given.
struct CommandLine {
    CLI::App app{opening, "fumon"};
    std::function<int()> chosen;

    CommandLine() {
        app.footer(examples);
        app.set_version_flag("--version", fmt::format("fumon {} (sources {})", FUMON_VERSION,
                                                      short_sources(this_build())));
        app.set_help_flag("-h,--help", "this help");
        app.require_subcommand(1);
        app.get_formatter()->column_width(34);
        for (const Command& command : commands()) {
            CLI::App& added = *app.add_subcommand(command.name, command.help);
            added.callback([this, body = command.declare(added)] { chosen = body; });
            if (added.get_option_no_throw("--quiet") == nullptr) add_quiet(added);
        }
    }
};

void check_standard_output() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    throw Error(
        fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments) {
    vectors::use_target_of_environment();
    CommandLine line;
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    int status = 0;
    try {
        line.app.parse(std::move(reversed));
        status = line.chosen();
    } catch (const CLI::Success& help) {
        line.app.exit(help);
    } catch (const CLI::ParseError& fault) {
        throw InputError(usage_fault(line.app, arguments, fault));
    } catch (const Cancelled&) {
        status = exit_status_of_signal(interrupting_signal());
    }
    check_standard_output();
    return status;
}

}  // namespace fumon
