

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
         {"fumon verify baseline.toml --json", "for a program"}},
        "A baseline has a line a picture:\n"
        "  [cases]\n"
        "  map = {scene = \"dunes.toml\", step = 500, settings = [\"camera.projection=map\"]}\n"
        "\n"
        "The state's hash must be the recorded one. Where what draws is pinned and the same, "
        "so must the\npixels (strict); elsewhere (portable) the thumbnail must be within "
        "thumbnail_difference (0.5 grey\nlevels) and, with picture = true, every 8 x 8 "
        "tile's SSIM at least tile_ssim (0.95).\n"
        "Exit status: 0 all as recorded, 1 something is not, 2 wrong input.");
}

int perform(const VerificationOptions& options) {
    const InterruptGuard guard;
    return verify(options);
}

}  // namespace

Command verify_command() {
    return make_command<VerificationOptions>(
        "verify", "check that pictures are still as recorded, with a page of those that are not",
        declare, perform);
}

}  // namespace fumon
