

#include "base/error.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "run/terminal/interrupt.h"
#include "verify/verification.h"

namespace fumon {

namespace {

void declare(CLI::App& command, VerificationOptions& options) {
    command.add_option("BASELINE", options.baselines, "baseline files (TOML)")->required();
    command
        .add_option("-o,--output", options.folder,
                    "folder for the pictures that do not pass and index.html (default verify-out; "
                    "not made if all pass)")
        ->type_name("DIR");
    command.add_option("--junit", options.junit, "write JUnit XML")->type_name("FILE.xml");
    add_choice<ReportFormat>(
        command, "--format", options.format,
        {{"github", ReportFormat::github}, {"gitlab", ReportFormat::gitlab}}, "github or gitlab",
        "github: annotations, and a job summary; gitlab: a Code Quality report, alone");
    command.add_flag("--update", options.update,
                     "record the pictures as they are now, and say what changed");
    add_force(command, options.force);
    command.add_flag(
        "--trust", options.trust,
        "lift the limits on what baselines of unknown origin may ask for, and tell what is "
        "wrong in files that they name");
    add_thread_options(command, options.work);
    add_drawing_options(command, options.work);
    command.add_flag("--json", options.as_json, "print what was found as JSON");
    add_examples(
        command,
        {{"fumon verify --update --pinned baseline.toml", "records; commit the file"},
         {"fumon verify baseline.toml", "compares, pinned as it was recorded"},
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
        "overlays "
        "and what is white, at most 30 % of a picture.\n"
        "Exit status: 0 all as recorded, 1 something is not, 2 wrong input.");
}

int perform(const VerificationOptions& options) {
    if (options.as_json && options.format != ReportFormat::lines)
        throw InputError("fumon verify: --json and --format are two reports; keep one");
    const InterruptGuard guard;
    if (options.format != ReportFormat::gitlab) return verify(options);
    VerificationOptions alone = options;
    alone.as_json = true;  // no lines beside the report
    return verify(alone);
}

}  // namespace

Command verify_command() {
    return make_command<VerificationOptions>(
        "verify", "check that pictures are still as recorded, with a page of those that are not",
        declare, perform);
}

}  // namespace fumon
