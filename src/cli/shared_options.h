#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "cli/completion.h"
#include "foreign/foreign_run.h"
#include "run/terminal/status_line.h"
#include "run/terminal/work_options.h"
#include "shards/shard.h"

namespace fumon {

// Options that several commands have.

/// --threads, --quiet and --verbose.
void add_thread_options(CLI::App& command, WorkOptions& work);

/// --set, --threads, --quiet and --verbose.
void add_work_options(CLI::App& command, WorkOptions& work);

/// --gl and --pinned.
void add_drawing_options(CLI::App& command, WorkOptions& work);

/// --view and --port, of a job that can be watched in a browser.
struct WatchOptions {
    bool on = false;
    int port = 0;  ///< 0: any that is free
};
void add_watch_options(CLI::App& command, WatchOptions& watch);

/// --set, described by `help`.
void add_settings(CLI::App& command, std::vector<std::string>& settings, const char* help);

/// --force; by default described as the rule of OutputClaims.
CLI::Option* add_force(CLI::App& command, bool& force,
                       const char* help =
                           "replace files that fumon did not make, too (never "
                           "what is read)");

/// How some work is shared out among programs, as the command line says it.
struct ShardOptions {
    std::string shard;              ///< --shard as given; empty: all is done here
    bool merge = false;             ///< what the shards have made is put together
    std::int64_t slurm_shards = 0;  ///< a job script of so many shards is printed; 0: none
};

/// --shard, --merge and --slurm; `merged` says what --merge makes.
void add_shard_options(CLI::App& command, ShardOptions& options, const char* merged);

/// Which share of some work this program does.
struct Share {
    std::optional<Shard> shard;  ///< none: all of it
    bool of_mpirun = false;      ///< by mpirun, unasked: whoever ends last puts the shares together
};

/// The share that the command line, or else mpirun, asks for. A program that mpirun started takes,
/// unless --threads says otherwise, as many threads as it has processors to itself, and the first
/// one says what happens: `merged` is what the last one does. Throws InputError as read_shard().
Share share_of(const ShardOptions& options, WorkOptions& work, StatusLine& status,
               const char* merged);

/// --heights of a PNG terrain.
void add_heights(CLI::App& command, std::string& heights);

/// --field, --time-pattern, --time-unit and --cell-size of results of other models.
void add_foreign_options(CLI::App& command, ForeignQuery& query);

/// --colour, of what colours the ground.
void add_colour(CLI::App& command, std::string& colour);

/// Throws InputError where standard output is a terminal, which `what` ("the picture is a PNG
/// file") tells nothing and may upset; `example` is a file that may take it.
void refuse_terminal(const char* what, const char* example);

/// What is wrong with a text that should be a number from `low` to `high`; empty where nothing is.
std::string number_fault(const std::string& text, bool whole, double low, double high);

/// What is wrong with a text that should be one of some words; empty where nothing is.
std::string word_fault(const std::string& text, const std::vector<std::string>& words);

/// An option that takes a number from `low` to `high`, whole where `value` is.
template <class Value>
CLI::Option* add_number(CLI::App& command, const char* name, Value& value, double low, double high,
                        const char* help) {
    constexpr bool real =
        std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>;
    return command.add_option(name, value, help)->check([low, high](const std::string& text) {
        return number_fault(text, !real, low, high);
    });
}

/// An option that takes one of some words.
CLI::Option* add_word(CLI::App& command, const char* name, std::string& value,
                      const std::vector<std::string>& words, const char* help);

/// An option that takes one of some words; `list` names them ("identical, same or close").
template <class Value>
void add_choice(CLI::App& command, const char* name, Value& value,
                const std::map<std::string, Value>& words, const char* list, const char* help) {
    std::vector<std::string> known;
    known.reserve(words.size());
    for (const auto& word : words) known.push_back(word.first);
    command.add_option(name, value, help)
        ->type_name("NAME")
        ->transform(CLI::Transformer(words).description("").name(words_as_name(known)))
        ->check([list](const std::string& text) -> std::string {
            const bool was_known = text.size() == 1;  // an enumerator's number by now
            return was_known ? "" : fmt::format("it takes {}, not \"{}\"", list, text);
        });
}

}  // namespace fumon
