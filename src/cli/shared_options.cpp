#include "cli/shared_options.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "cli/completion.h"
#include "shards/shard.h"

namespace fumon {

std::string number_fault(const std::string& text, bool whole, double low, double high) {
    const char* const end = text.data() + text.size();
    double value = 0.0;
    bool good = false;
    if (whole) {
        std::int64_t exact = 0;
        const auto read = std::from_chars(text.data(), end, exact);
        good = read.ec == std::errc{} && read.ptr == end;
        value = static_cast<double>(exact);
    } else {
        const auto read = std::from_chars(text.data(), end, value);
        good = read.ec == std::errc{} && read.ptr == end;
    }
    if (good && value >= low && value <= high) return {};
    return fmt::format("it takes a {} from {:g} to {:g}, not \"{}\"",
                       whole ? "whole number" : "number", low, high, text);
}

std::string word_fault(const std::string& text, const std::vector<std::string>& words) {
    if (std::ranges::find(words, text) != words.end()) return {};
    std::string list;
    for (std::size_t n = 0; n < words.size(); ++n)
        list += (n == 0 ? "" : n + 1 < words.size() ? ", " : " or ") + words[n];
    return fmt::format("it takes {}, not \"{}\"", list, text);
}

CLI::Option* add_word(CLI::App& command, const char* name, std::string& value,
                      const std::vector<std::string>& words, const char* help) {
    const CLI::Validator known([words](const std::string& text) { return word_fault(text, words); },
                               "", words_as_name(words));
    return command.add_option(name, value, help)->check(known);
}

void add_thread_options(CLI::App& command, WorkOptions& work) {
    constexpr double most_threads = 1024;
    add_number(command, "--threads", work.threads, 1, most_threads,
               "threads to compute with (default: one per processor)")
        ->type_name("N");
    auto* quiet = command.add_flag_callback(
        "-q,--quiet", [&work] { work.verbosity = Verbosity::quiet; }, "print errors only");
    command
        .add_flag_callback(
            "-v,--verbose", [&work] { work.verbosity = Verbosity::verbose; }, "say more")
        ->excludes(quiet);
}

void add_work_options(CLI::App& command, WorkOptions& work) {
    add_settings(command, work.settings, "override a scene key: --set key.path=VALUE (repeatable)");
    add_thread_options(command, work);
}

void add_drawing_options(CLI::App& command, WorkOptions& work) {
    add_choice<gl::Backend>(command, "--gl", work.backend,
                            {{"auto", gl::Backend::automatic},
                             {"osmesa", gl::Backend::osmesa},
                             {"egl", gl::Backend::egl}},
                            "auto, osmesa or egl",
                            "how to draw: auto, osmesa or egl (auto: OSMesa, else EGL)");
    command.add_flag("--pinned", work.pinned,
                     "draw the same pixels on every x86-64 processor (about a fifth slower)");
}

void add_settings(CLI::App& command, std::vector<std::string>& settings, const char* help) {
    command.add_option("--set", settings, help)->type_name("KEY=VALUE")->allow_extra_args(false);
}

CLI::Option* add_force(CLI::App& command, bool& force, const char* help) {
    return command.add_flag("--force", force, help);
}

void add_shard_options(CLI::App& command, ShardOptions& options, const char* merged) {
    auto* shard =
        command
            .add_option("--shard", options.shard,
                        "do one share of the work: 3/16, or slurm or mpi, which read it from "
                        "the job's environment")
            ->type_name("N/OF");
    auto* merge = command.add_flag("--merge", options.merge, merged)->excludes(shard);
    add_number(command, "--slurm", options.slurm_shards, 1, most_shards,
               "print a job script for sbatch: so many shards and their merge; does nothing else")
        ->type_name("SHARDS")
        ->excludes(shard)
        ->excludes(merge);
}

void add_heights(CLI::App& command, std::string& heights) {
    command.add_option("--heights", heights, "metres of black and white of a PNG terrain")
        ->type_name("LOW:HIGH");
}

}  // namespace fumon
