#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "cli/command.h"
#include "cli/examples.h"

namespace fumon {

namespace {

int perform(const CLI::App& app, const std::string& asked) {
    if (asked.empty()) {
        // App::help() would be that of the command that was given, of this one.
        std::fputs(app.get_formatter()
                       ->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal)
                       .c_str(),
                   stdout);
        return 0;
    }
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
        if (names.back() != asked) continue;
        std::fputs(command->help(app.get_name()).c_str(), stdout);
        return 0;
    }
    throw InputError("fumon help: there is no command \"" + asked + "\"; " +
                     suggestion(asked, names));
}

}  // namespace

Command help_command() {
    return {"help", "print the help of fumon or of a command",
            [](CLI::App& command) -> std::function<int()> {
                const auto asked = std::make_shared<std::string>();
                command.add_option("COMMAND", *asked, "a command (default: fumon itself)");
                add_examples(command, {{"fumon help run", "as `fumon run --help`"}});
                return [&command, asked] { return perform(*command.get_parent(), *asked); };
            }};
}

}  // namespace fumon
