#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fumon {

/// What may stand where the cursor is.
struct Completion {
    std::vector<std::string> words;
    bool files = false;  ///< or the name of a file
};

/// Completes a command line: `words` are those after "fumon", the last one as far as it is typed.
/// Commands, options, the words that options take, scenes, models, keys and their values all come
/// from the tables that read them. Never throws InputError.
Completion completion(CLI::App& app, const std::vector<std::string>& words);

/// A validator's name that holds the words that an option takes, for the completion; and back.
std::string words_as_name(const std::vector<std::string>& words);
std::vector<std::string> words_of_option(CLI::Option& option);

/// The script that a shell ("bash", "zsh", "fish") reads; empty for any other.
std::string completion_script(const std::string& shell);

}  // namespace fumon
