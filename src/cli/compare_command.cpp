#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "picture/compare.h"
#include "picture/pixels/ignore_rules.h"
#include "picture/png.h"
#include "picture/stills/picture_file.h"
#include "picture/stills/same_picture_files.h"
#include "scene/json.h"

namespace fumon {

namespace {

struct CompareOptions {
    std::string first;
    std::string second;
    Likeness level = Likeness::same_to_the_eye;  ///< that passes
    std::string difference;                      ///< a PNG to write; empty: none
    std::vector<std::string> ignored_boxes;      ///< "X,Y,WIDTH,HEIGHT"
    std::string ignore_mask;                     ///< a PNG; empty: none
    bool force = false;
    bool as_json = false;
};

void declare(CLI::App& command, CompareOptions& options) {
    command.add_option("A", options.first, "a PNG, JPEG, WebP or TIFF file")->required();
    command.add_option("B", options.second, "another")->required();
    command.add_option("--diff", options.difference, "draw where they differ")
        ->type_name("FILE.png");
    add_force(command, options.force);
    command
        .add_option("--ignore", options.ignored_boxes,
                    "leave out a box of pixels from the upper left corner (may be repeated)")
        ->type_name("X,Y,WIDTH,HEIGHT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--ignore-mask", options.ignore_mask,
                    "leave out what is white in a PNG of the same size")
        ->type_name("FILE.png");
    add_choice<Likeness>(command, "--level", options.level,
                         {{"identical", Likeness::identical},
                          {"same", Likeness::same_to_the_eye},
                          {"close", Likeness::close}},
                         "identical, same or close",
                         "the least alike that passes: identical, same (default) or close");
    command.add_flag("--json", options.as_json, "as JSON");
    add_examples(
        command,
        {{"fumon compare before.png after.png", ""},
         {"fumon compare before.png after.png --diff where.png --level close", ""},
         {"fumon compare before.png after.png --ignore 0,0,320,24", "without a line of text"},
         {"fumon compare before.png after.png --json", "for a program"}},
        likeness_help() +
            fmt::format("\nAt most {:g} % of a picture may be left out; the picture of "
                        "differences has it hatched.",
                        100.0 * largest_ignored_share) +
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
    if (comparison.ignored > 0) {
        fmt::print("ignored pixels        {} ({:.4g} %)\n", comparison.ignored,
                   100.0 * comparison.ignored_share);
    }
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
        if (comparison->ignored > 0) {
            json["ignored_pixels"] = comparison->ignored;
            json["ignored_share"] = comparison->ignored_share;
        }
    }
    return json_text(json, 2) + "\n";
}

void check_difference(const CompareOptions& options) {
    if (options.difference.empty()) return;
    check_ending(options.difference, "a picture", png_ending);
    OutputClaims claims(options.force);
    claims.reads(options.first);
    claims.reads(options.second);
    if (!options.ignore_mask.empty()) claims.reads(options.ignore_mask);
    claims.writes(options.difference);
}

IgnoreRules rules_of(const CompareOptions& options) {
    IgnoreRules rules;
    for (const std::string& box : options.ignored_boxes) {
        try {
            rules.boxes.push_back(read_box(box));
        } catch (const InputError& fault) {
            throw placed("fumon compare: --ignore: ", fault);
        }
    }
    rules.mask = options.ignore_mask;
    return rules;
}

/// Says what was found; the exit status.
int conclude(const CompareOptions& options, const Comparison& comparison) {
    const Likeness found = likeness(comparison);
    if (options.as_json) {
        std::fputs(as_json(options, comparison, found).c_str(), stdout);
    } else if (!makes_no_remarks()) {
        print(comparison);
        fmt::print("{}\n", name_of(found));
    }
    return found >= options.level ? 0 : 1;
}

void write_difference(const CompareOptions& options, const Image& first, const Image& second,
                      const IgnoredPixels& ignored) {
    if (options.difference.empty()) return;
    write_file(options.difference, encode_png(difference_picture(first, second, ignored),
                                              screen_dots_per_inch, own_text()));
}

int perform(const CompareOptions& options) {
    check_difference(options);
    const IgnoreRules rules = rules_of(options);
    const bool same_files = !rules.any() && same_picture_files(options.first, options.second);
    if (same_files && options.difference.empty()) return conclude(options, Comparison{});
    const Image first = read_picture(options.first);
    const Image second = same_files ? first : read_picture(options.second);
    if (first.width != second.width || first.height != second.height) {
        const std::string text =
            options.as_json
                ? as_json(options, std::nullopt, Likeness::different)
                : fmt::format("{}: {} x {} against {} x {} pixels\n", name_of(Likeness::different),
                              first.width, first.height, second.width, second.height);
        if (options.as_json || !makes_no_remarks()) std::fputs(text.c_str(), stdout);
        return 1;
    }
    const IgnoredPixels ignored = ignored_pixels(rules, first, {});
    const int status = conclude(options, compare(first, second, ignored));
    write_difference(options, first, second, ignored);
    return status;
}

}  // namespace

Command compare_command() {
    return make_command<CompareOptions>("compare", "compare two pictures, and give a verdict",
                                        declare, perform);
}

}  // namespace fumon
