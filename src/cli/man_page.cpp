#include "cli/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "film/script/film_keys.h"
#include "scene/describe.h"

namespace fumon {

namespace {

/// A line of text as roff shows it.
std::string escaped(const std::string& line) {
    std::string text = line.starts_with('.') || line.starts_with('\'') ? "\\&" : "";
    for (const char letter : line) {
        if (letter == '\\') {
            text += "\\e";
        } else if (letter == '-') {
            text += "\\-";
        } else {
            text += letter;
        }
    }
    return text;
}

std::string head(const std::string& name, int section, const std::string& what) {
    std::string title = name;
    std::ranges::transform(title, title.begin(), [](unsigned char letter) {
        return static_cast<char>(std::toupper(letter));
    });
    return fmt::format("{}{}\n.TH {} {} \"{}\" \"fumon {}\" \"fumon\"\n.SH NAME\n{} \\- {}\n",
                       own_man_page_mark, FUMON_VERSION, escaped(title), section, FUMON_DATE,
                       FUMON_VERSION, escaped(name), escaped(what));
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// "-o, --output DIR".
std::string option_head(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames())
        names += (names.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames())
        names += (names.empty() ? "--" : ", --") + name;
    const bool takes_a_value = option.get_items_expected_max() > 0;
    const std::string value = takes_a_value ? option.get_type_name() : "";
    return names + (value.empty() ? "" : " " + value);
}

std::string options_part(const CLI::App& command) {
    std::string arguments;
    std::string options;
    for (const CLI::Option* option : command.get_options()) {
        const bool positional = option->get_lnames().empty() && option->get_snames().empty();
        const std::string name = positional ? option->get_name() : option_head(*option);
        (positional ? arguments : options) +=
            fmt::format(".TP\n.B {}\n{}\n", escaped(name), escaped(option->get_description()));
    }
    return (arguments.empty() ? "" : ".SH ARGUMENTS\n" + arguments) +
           (options.empty() ? "" : ".SH OPTIONS\n" + options);
}

std::string synopsis(const CLI::App& command, const std::string& name) {
    std::string words;
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_lnames().empty() || !option->get_snames().empty()) continue;
        std::string word = option->get_name();
        if (option->get_items_expected_max() > 1) word += "...";
        words += option->get_required() ? " " + word : " [" + word + "]";
    }
    return fmt::format(".SH SYNOPSIS\n.B {}\n[OPTIONS]{}\n", escaped(name), escaped(words));
}

/// Examples and notes, as they stand under the options.
std::string footer_part(const CLI::App& command) {
    std::string text;
    bool in_examples = false;
    const auto open = [&](bool examples) {
        if (in_examples != examples) text += examples ? ".EX\n" : ".EE\n";
        in_examples = examples;
    };
    std::string heading = ".SH NOTES\n";
    for (const std::string& line : lines_of(command.get_footer())) {
        if (line == "Examples:") {
            text += ".SH EXAMPLES\n";
            continue;
        }
        if (line.empty()) continue;
        open(line.starts_with("  "));
        if (in_examples) {
            text += escaped(line) + "\n";
        } else {
            text += heading.empty() ? ".br\n" : heading;
            heading.clear();
            text += escaped(line) + "\n";
        }
    }
    open(false);
    return text;
}

/// What describe tells: keys at two spaces, what they mean at six, their words at eight.
std::string keys_part(const std::string& description) {
    std::string text;
    for (const std::string& line : lines_of(description)) {
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
        const std::string rest = line.substr(indent);
        if (rest.empty()) continue;
        if (indent == 0) {
            const std::size_t end = std::min(rest.find_first_of("(:,."), rest.size());
            const std::string first = rest.substr(0, rest.find_last_not_of(' ', end - 1) + 1);
            text += rest.starts_with("Keys of")
                        ? fmt::format(".SH {}\n{}\n", escaped(first), escaped(rest))
                        : escaped(rest) + "\n";
        } else if (indent == 2) {
            const std::size_t gap = rest.find("  ");
            const std::size_t end = gap == std::string::npos ? rest.find(' ') : gap;
            const std::size_t next = std::min(rest.find_first_not_of(' ', end), rest.size());
            text += fmt::format(".TP\n.B {}\n{}\n", escaped(rest.substr(0, end)),
                                escaped(rest.substr(next)));
        } else {
            text += ".br\n" + escaped(rest) + "\n";
        }
    }
    return text;
}

ManPage command_page(const CLI::App& command) {
    const std::string name = "fumon-" + command.get_name();
    return {name + ".1", head(name, 1, command.get_description()) +
                             synopsis(command, "fumon " + command.get_name()) +
                             options_part(command) + footer_part(command) +
                             ".SH SEE ALSO\n.BR fumon (1),\n.BR fumon\\-scene (5)\n"};
}

ManPage program_page(const CLI::App& app) {
    std::string text = head("fumon", 1, "simulate and draw landforms of sand and water");
    text += ".SH SYNOPSIS\n.B fumon\nCOMMAND [OPTIONS]\n.SH DESCRIPTION\n";
    for (const std::string& line : lines_of(app.get_description())) text += escaped(line) + "\n";
    text += ".SH COMMANDS\n";
    for (const CLI::App* command : app.get_subcommands({})) {
        text += fmt::format(".TP\n.BR {} (1)\n{}\n", escaped("fumon-" + command->get_name()),
                            escaped(command->get_description()));
    }
    return {"fumon.1",
            text + options_part(app) + footer_part(app) + ".SH SEE ALSO\n.BR fumon\\-scene (5)\n"};
}

ManPage scene_page() {
    std::string text = head("fumon-scene", 5, "files of scenes and films, their sections and keys");
    text +=
        ".SH DESCRIPTION\nA scene is a TOML file: [section] lines, and key = value lines under "
        "them. "
        "N counts the items of a list, as the [[overlay]] sections of a scene, from 0.\n";
    return {"fumon-scene.5", text + keys_part(describe_text("all")) + keys_part(describe_film()) +
                                 ".SH SEE ALSO\n.BR fumon\\-describe (1),\n.BR fumon\\-new (1)\n"};
}

}  // namespace

std::vector<ManPage> man_pages(const CLI::App& app) {
    std::vector<ManPage> pages{program_page(app)};
    for (const CLI::App* command : app.get_subcommands({})) pages.push_back(command_page(*command));
    pages.push_back(scene_page());
    return pages;
}

}  // namespace fumon
