#include <fmt/format.h>

#include <cstdio>

#include "cli/command.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "picture/compare.h"
#include "picture/png.h"

namespace fumon {

namespace {

struct CompareOptions {
    std::string first;
    std::string second;
    Likeness level = Likeness::same_to_the_eye;  ///< that passes
    std::string difference;                      ///< a PNG to write; empty: none
    bool force = false;
};

void declare(CLI::App& command, CompareOptions& options) {
    command.add_option("A", options.first, "a PNG file")->required();
    command.add_option("B", options.second, "another")->required();
    command.add_option("--diff", options.difference, "draw where they differ")
        ->type_name("FILE.png");
    add_force(command, options.force);
    add_choice<Likeness>(command, "--level", options.level,
                         {{"identical", Likeness::identical},
                          {"same", Likeness::same_to_the_eye},
                          {"close", Likeness::close}},
                         "identical, same or close",
                         "the least alike that passes: identical, same (default) or close");
    command.footer(likeness_help() +
                   "\nExit status: 0 at least --level, 1 less (other sizes too), 2 wrong input.");
}

void print(const Comparison& comparison) {
    fmt::print(
        "largest difference    {} of 255\n"
        "changed pixels        {} ({:.4g} %)\n"
        "mean difference       {:.4g}\n",
        comparison.largest, comparison.changed, 100.0 * comparison.changed_share, comparison.mean);
    fmt::print("smallest tile SSIM    {:.4f}", comparison.tiles.smallest);
    if (comparison.changed > 0)
        fmt::print(" (8 x 8 pixels at {}, {})", comparison.tiles.x, comparison.tiles.y);
    fmt::print("\nthumbnail difference  {:.3f}", comparison.thumbnail.largest);
    if (comparison.changed > 0)
        fmt::print(" (column {}, row {} of {} x {})", comparison.thumbnail.x,
                   comparison.thumbnail.y, Thumbnail::width, Thumbnail::height);
    fmt::print("\n");
}

void check_difference(const CompareOptions& options) {
    if (options.difference.empty()) return;
    check_ending(options.difference, "a picture", png_ending);
    OutputClaims claims(options.force);
    claims.reads(options.first);
    claims.reads(options.second);
    claims.writes(options.difference);
}

int perform(const CompareOptions& options) {
    check_difference(options);
    const Image first = read_png(options.first);
    const Image second = read_png(options.second);
    if (first.width != second.width || first.height != second.height) {
        fmt::print("{}: {} x {} against {} x {} pixels\n", name_of(Likeness::different),
                   first.width, first.height, second.width, second.height);
        return 1;
    }
    const Comparison comparison = compare(first, second);
    const Likeness found = likeness(comparison);
    print(comparison);
    fmt::print("{}\n", name_of(found));
    if (!options.difference.empty()) {
        write_file(options.difference,
                   encode_png(difference_picture(first, second), screen_dots_per_inch, own_text()));
    }
    return found >= options.level ? 0 : 1;
}

}  // namespace

Command compare_command() {
    return make_command<CompareOptions>("compare", "compare two pictures, and give a verdict",
                                        declare, perform);
}

}  // namespace fumon
