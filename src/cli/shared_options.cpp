#include "cli/shared_options.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <thread>

#include "base/error.h"
#include "cli/completion.h"
#include "cli/remark.h"

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

void add_watch_options(CLI::App& command, WatchOptions& watch) {
    auto* view = command.add_flag(
        "--view", watch.on,
        "show in a browser how far it is, with its pictures and a button that stops it; the "
        "address is printed");
    add_number(command, "--port", watch.port, 0, 65535,
               "with --view: to listen on (default: one that is free)")
        ->type_name("N")
        ->needs(view);
}

void add_thread_options(CLI::App& command, WorkOptions& work) {
    constexpr double most_threads = 1024;
    add_number(command, "--threads", work.threads, 1, most_threads,
               "threads to compute with (default: one per processor)")
        ->type_name("N");
    auto* quiet = command.add_flag_callback(
        "-q,--quiet",
        [&work] {
            work.verbosity = Verbosity::quiet;
            make_no_remarks();
        },
        "print errors only");
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
                     "draw the same pixels on every x86-64 processor with SSE4.1, of 2008 or later "
                     "(about a fifth slower)");
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
                        "the job's environment, or none (default: under mpirun the rank's, else "
                        "none)")
            ->type_name("N/OF");
    auto* merge = command.add_flag("--merge", options.merge, merged)->excludes(shard);
    add_number(command, "--slurm", options.slurm_shards, 1, most_shards,
               "print a job script for sbatch: so many shards and their merge; does nothing else")
        ->type_name("SHARDS")
        ->excludes(shard)
        ->excludes(merge);
}

void refuse_terminal(const char* what, const char* example) {
    if (::isatty(STDOUT_FILENO) == 0) return;
    throw InputError(fmt::format(
        "-o -: standard output is a terminal, and {}; name a file, or redirect the output (> {})",
        what, example));
}

Share share_of(const ShardOptions& options, WorkOptions& work, StatusLine& status,
               const char* merged) {
    if (options.shard == "none" || options.merge || options.slurm_shards > 0) return {};
    if (!options.shard.empty()) return {read_shard(options.shard), false};
    const std::optional<Rank> rank = rank_of_mpirun();
    if (!rank) return {};
    if (work.threads == 0) {
        const auto mine = static_cast<int>(std::thread::hardware_concurrency());
        const auto all = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN));
        work.threads = std::max(1, std::min(mine, all / rank->beside));
    }
    if (rank->shard.number == 1) {
        status.note(fmt::format(
            "mpirun has started {} programs: each does its share, and the last one to end {} "
            "(--shard none: each does all)",
            rank->shard.of, merged));
    }
    return {rank->shard, true};
}

void add_heights(CLI::App& command, std::string& heights) {
    command.add_option("--heights", heights, "metres of black and white of a PNG terrain")
        ->type_name("LOW:HIGH");
}

void add_foreign_options(CLI::App& command, ForeignQuery& query) {
    command
        .add_option("--field", query.fields,
                    "of another model's results: which variable or file is what, as depth=h, "
                    "bed=dem.tif or depth='wd*.asc' (repeatable); of bed, depth, level, u, v, qx, "
                    "qy, concentration")
        ->type_name("QUANTITY=NAME")
        ->allow_extra_args(false);
    command
        .add_option("--time-pattern", query.time_pattern,
                    "of the dates in the names of a series of rasters: '%Y-%m-%d'")
        ->type_name("PATTERN");
    command
        .add_option("--time-unit", query.time_unit,
                    "of the numbers in the names of a series of rasters, and of times without a "
                    "unit: s, min, h, d or yr")
        ->type_name("UNIT");
    add_number(command, "--cell-size", query.cell_size, 0.0, 1e6,
               "metres, of rasters that do not say theirs, and of the grid for triangles and "
               "polygons")
        ->type_name("METRES");
}

void add_colour(CLI::App& command, std::string& colour) {
    command
        .add_option("--colour", colour,
                    "what colours the ground: a field of the run or a variable of the file, or a "
                    "word of look.colour_by (height, slope, water-depth …)")
        ->type_name("NAME");
}

}  // namespace fumon
