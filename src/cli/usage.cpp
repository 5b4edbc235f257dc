#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/nearest_name.h"

namespace fumon {

namespace {

std::vector<std::string> options_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

/// "--name" of "--name=value", "-x" of "-x…"; empty for what is no option, a negative number too.
std::string option_in(const std::string& argument) {
    if (argument.size() < 2 || argument.front() != '-') return {};
    if (argument.starts_with("--"))
        return argument.size() > 2 ? argument.substr(0, argument.find('=')) : "";
    return std::isalpha(static_cast<unsigned char>(argument[1])) != 0 ? argument.substr(0, 2) : "";
}

/// The first option that the command does not have, and what was meant; empty where there is none.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& arguments,
                           std::size_t first) {
    const std::vector<std::string> known = options_of(command);
    for (std::size_t n = first; n < arguments.size() && arguments[n] != "--"; ++n) {
        const std::string option = option_in(arguments[n]);
        if (option.empty() || std::ranges::find(known, option) != known.end()) continue;
        const std::string nearest = option.starts_with("--") ? nearest_name(option, known) : "";
        return nearest.empty()
                   ? fmt::format("{}: no such option", option)
                   : fmt::format("{}: no such option; did you mean \"{}\"?", option, nearest);
    }
    return {};
}

bool ends_with(const std::string& text, const std::string& end, std::string& before) {
    if (!text.ends_with(end)) return false;
    before = text.substr(0, text.size() - end.size());
    return true;
}

/// What CLI11 says of a fault, in other words.
std::string plain_words(const CLI::ParseError& fault) {
    const std::string text = fault.what();
    const std::string kind = fault.get_name();
    const std::string option = text.substr(0, text.find(':'));
    std::string one;
    if (text.find("not expected: ") !=
        std::string::npos)  // which lists them from the last to the first
        return fmt::format("\"{}\" is one too many", text.substr(text.rfind(' ') + 1));
    if (kind == "RequiredError" && ends_with(text, " is required", one)) return one + " is missing";
    if (kind == "ExcludesError" && text.find(" excludes ") != std::string::npos) {
        const std::size_t at = text.find(" excludes ");
        constexpr std::size_t length = 10;
        return fmt::format("{} and {} do not go together", text.substr(0, at),
                           text.substr(at + length));
    }
    if (kind == "RequiresError" && text.find(" requires ") != std::string::npos) {
        const std::size_t at = text.find(" requires ");
        constexpr std::size_t length = 10;
        return fmt::format("{} needs {} too", text.substr(0, at), text.substr(at + length));
    }
    if (kind == "ArgumentMismatch" && text.find("At Most") != std::string::npos)
        return option + " is given more than once";
    if (kind == "ArgumentMismatch" && ends_with(text, " missing", one))
        return fmt::format("{} takes {}, which is missing", option,
                           one.substr(one.find(" required ") + 10));
    return text;
}

}  // namespace

std::string usage_fault(const CLI::App& app, const std::vector<std::string>& arguments,
                        const CLI::ParseError& fault) {
    if (arguments.empty()) return "fumon: a command is missing; try `fumon --help`";
    const CLI::App* command = &app;
    std::vector<std::string> commands;
    for (const CLI::App* known : app.get_subcommands({})) {
        commands.push_back(known->get_name());
        if (known->get_name() == arguments.front()) command = known;
    }
    const bool named = command != &app;
    const std::string& first = arguments.front();
    if (!named && !first.starts_with("-"))
        return fmt::format("fumon: unknown command \"{}\"; {}", first, suggestion(first, commands));
    const std::string name = named ? "fumon " + first : "fumon";
    const std::string unknown = unknown_option(*command, arguments, named ? 1 : 0);
    if (unknown.ends_with('?')) return fmt::format("{}: {}", name, unknown);
    if (!unknown.empty()) return fmt::format("{}: {}; try `{} --help`", name, unknown, name);
    if (!named) return "fumon: a command is missing; try `fumon --help`";
    return fmt::format("{}: {}; try `{} --help`", name, plain_words(fault), name);
}

}  // namespace fumon
