#include <fmt/format.h>

#include <filesystem>

#include "base/error.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "run/terminal/interrupt.h"
#include "verify/verification.h"

namespace fumon {

namespace {

struct VerifyOptions {
    VerificationOptions asked;
    std::vector<std::string> words;  ///< baselines, and names of cases
    std::string shard;
    bool in_one_process = false;
};

void declare_choice(CLI::App& command, VerifyOptions& options) {
    VerificationOptions& asked = options.asked;
    command
        .add_option("BASELINE", options.words,
                    "baseline files (TOML), and names of cases, where not all are meant")
        ->required();
    command
        .add_option("-k", asked.patterns,
                    "cases whose name has this part, or matches it with * ? [ ]; with a slash "
                    "SUITE/NAME is held against it (repeatable)")
        ->type_name("PATTERN")
        ->allow_extra_args(false);
    command.add_option("--shard", options.shard, "compare one share of the cases: 1/4 … 4/4")
        ->type_name("N/OF");
}

void declare(CLI::App& command, VerifyOptions& options) {
    VerificationOptions& asked = options.asked;
    declare_choice(command, options);
    command
        .add_option("-o,--output", asked.folder,
                    "folder for the pictures that do not pass and index.html (default verify-out, "
                    "or a temporary folder where that cannot be written; not made if all pass)")
        ->type_name("DIR");
    auto* junit = command.add_option("--junit", asked.junit, "write JUnit XML, whatever happens")
                      ->type_name("FILE.xml");
    add_choice<ReportFormat>(
        command, "--format", asked.format,
        {{"github", ReportFormat::github}, {"gitlab", ReportFormat::gitlab}}, "github or gitlab",
        "github: annotations, and a job summary; gitlab: a Code Quality report, alone");
    auto* list = command.add_flag("--list", asked.list, "name the cases, and draw nothing");
    auto* update = command.add_flag("--update", asked.update,
                                    "record the pictures as they are now, and say what changed");
    auto* accept = command
                       .add_option("--accept", asked.accepts,
                                   "record the new picture of a case from the last results, "
                                   "without drawing (repeatable)")
                       ->type_name("CASE")
                       ->allow_extra_args(false)
                       ->excludes(update)
                       ->excludes(junit)
                       ->excludes(list);
    command.get_option("--shard")->excludes(update)->excludes(accept);
    list->excludes(update);
    command.add_flag("--this-environment", asked.this_environment,
                     "with --update or --accept: record for the environment alone that the case "
                     "names and this is");
    command.add_flag("--no-isolate", options.in_one_process,
                     "draw in this process and not in a child, for a debugger; a crash ends all");
    add_force(command, asked.force);
    command.add_flag(
        "--trust", asked.trust,
        "lift the limits on what baselines of unknown origin may ask for, and tell what is "
        "wrong in files that they name");
    add_thread_options(command, asked.work);
    add_drawing_options(command, asked.work);
    command.add_flag("--json", asked.as_json, "print what was found as JSON")->excludes(accept);
    add_examples(
        command,
        {{"fumon verify --update --pinned baseline.toml", "records; commit the file"},
         {"fumon verify baseline.toml", "compares, pinned as it was recorded"},
         {"fumon verify baseline.toml map -k 'winter*'", "some cases alone"},
         {"fumon verify baseline.toml --accept map", "takes the new picture of one over"},
         {"fumon verify baseline.toml --format github", "in a job of GitHub Actions"},
         {"fumon verify baseline.toml --format gitlab > quality.json", "in a job of GitLab"},
         {"fumon verify baseline.toml --json", "for a program"}},
        "A baseline has a line a picture:\n"
        "  [cases]\n"
        "  map = {scene = \"dunes.toml\", step = 500, settings = [\"camera.projection=map\"]}\n"
        "\n"
        "The state's hash must be the recorded one. Where what draws is pinned and the same, "
        "so must the\npixels (strict); elsewhere (portable) the thumbnail must be within "
        "thumbnail_difference (0.5 grey\nlevels) and, with picture = true, every 8 x 8 "
        "tile's SSIM at least tile_ssim (0.95). ignore = "
        "[[x, y, width, height], \"time\"] and ignore_mask\n= \"mask.png\" leave out boxes, "
        "overlays and what is white, at most 30 % of a picture.\n"
        "Exit status, the highest that occurred: 0 all as recorded, 1 pictures differ or are not "
        "recorded,\n2 wrong input, 3 a case could not be drawn, or something not written, or a "
        "signal stopped it.");
}

/// Baselines are files or end in .toml; other words are names of cases.
void sort_words(const std::vector<std::string>& words, VerificationOptions& asked) {
    for (const std::string& word : words) {
        std::error_code fault;
        const bool is_file =
            word.ends_with(".toml") || std::filesystem::is_regular_file(word, fault);
        (is_file ? asked.baselines : asked.names).push_back(word);
    }
    if (!asked.baselines.empty()) return;
    throw InputError(
        fmt::format("fumon verify: \"{}\" is not a file; name a baseline (TOML), then its cases",
                    words.front()));
}

int perform(const VerifyOptions& options) {
    const InterruptGuard guard;
    VerificationOptions asked = options.asked;
    sort_words(options.words, asked);
    if (!options.shard.empty()) asked.shard = read_shard(options.shard);
    asked.isolate = !options.in_one_process;
    if (asked.this_environment && !asked.update && asked.accepts.empty()) {
        throw InputError("fumon verify: --this-environment works only with --update or --accept");
    }
    if (!asked.accepts.empty() && !(asked.names.empty() && asked.patterns.empty())) {
        throw InputError(
            "fumon verify: --accept takes the names of cases itself; repeat --accept for each "
            "case");
    }
    if (asked.as_json && asked.format != ReportFormat::lines)
        throw InputError("fumon verify: give either --json or --format, not both");
    asked.as_json = asked.as_json || asked.format == ReportFormat::gitlab;  // no lines beside it
    return verify(asked);
}

}  // namespace

Command verify_command() {
    return make_command<VerifyOptions>(
        "verify", "check that pictures are still as recorded, with a page of those that are not",
        declare, perform);
}

}  // namespace fumon
