#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "run/terminal/work_options.h"

namespace fumon {

// Options that several commands have.

/// --threads, --quiet and --verbose.
void add_thread_options(CLI::App& command, WorkOptions& work);

/// --set, --threads, --quiet and --verbose.
void add_work_options(CLI::App& command, WorkOptions& work);

/// --gl and --pinned.
void add_drawing_options(CLI::App& command, WorkOptions& work);

/// --set, described by `help`.
void add_settings(CLI::App& command, std::vector<std::string>& settings, const char* help);

/// --force; by default described as the rule of OutputClaims.
CLI::Option* add_force(CLI::App& command, bool& force,
                       const char* help =
                           "replace files that fumon did not make, too (never "
                           "what is read)");

/// --heights of a PNG terrain.
void add_heights(CLI::App& command, std::string& heights);

/// An option that takes one of some words; `list` names them ("identical, same or close").
template <class Value>
void add_choice(CLI::App& command, const char* name, Value& value,
                const std::map<std::string, Value>& words, const char* list, const char* help) {
    command.add_option(name, value, help)
        ->type_name("NAME")
        ->transform(CLI::Transformer(words).description(""))
        ->check([list](const std::string& text) -> std::string {
            const bool was_known = text.size() == 1;  // an enumerator's number by now
            return was_known ? "" : fmt::format("it takes {}, not \"{}\"", list, text);
        });
}

}  // namespace fumon
