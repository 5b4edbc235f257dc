#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "picture/compare.h"
#include "picture/png.h"
#include "picture/stills/picture_file.h"
#include "scene/json.h"

namespace fumon {

namespace {

struct CompareOptions {
    std::string first;
    std::string second;
    Likeness level = Likeness::same_to_the_eye;  ///< that passes
    std::string difference;                      ///< a PNG to write; empty: none
    bool force = false;
    bool as_json = false;
};

void declare(CLI::App& command, CompareOptions& options) {
    command.add_option("A", options.first, "a PNG, JPEG or WebP file")->required();
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
    command.add_flag("--json", options.as_json, "as JSON");
    add_examples(command,
                 {{"fumon compare before.png after.png", ""},
                  {"fumon compare before.png after.png --diff where.png --level close", ""},
                  {"fumon compare before.png after.png --json", "for a program"}},
                 likeness_help() +
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

std::string as_json(const CompareOptions& options, const std::optional<Comparison>& comparison,
                    Likeness found) {
    nlohmann::ordered_json json;
    json["first"] = options.first;
    json["second"] = options.second;
    json["likeness"] = name_of(found);
    json["passes"] = comparison && found >= options.level;
    json["same_size"] = comparison.has_value();
    if (comparison) {
        json["largest_difference"] = comparison->largest;
        json["changed_pixels"] = comparison->changed;
        json["changed_share"] = comparison->changed_share;
        json["mean_difference"] = comparison->mean;
        json["smallest_tile_ssim"] = comparison->tiles.smallest;
        json["thumbnail_difference"] = comparison->thumbnail.largest;
    }
    return json_text(json, 2) + "\n";
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
    const Image first = read_picture(options.first);
    const Image second = read_picture(options.second);
    if (first.width != second.width || first.height != second.height) {
        const std::string text =
            options.as_json
                ? as_json(options, std::nullopt, Likeness::different)
                : fmt::format("{}: {} x {} against {} x {} pixels\n", name_of(Likeness::different),
                              first.width, first.height, second.width, second.height);
        if (options.as_json || !makes_no_remarks()) std::fputs(text.c_str(), stdout);
        return 1;
    }
    const Comparison comparison = compare(first, second);
    const Likeness found = likeness(comparison);
    if (options.as_json) {
        std::fputs(as_json(options, comparison, found).c_str(), stdout);
    } else if (!makes_no_remarks()) {
        print(comparison);
        fmt::print("{}\n", name_of(found));
    }
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
