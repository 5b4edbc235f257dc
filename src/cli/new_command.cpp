#include <fmt/format.h>

#include <cstdio>

#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "outputs/output_claims.h"
#include "run/inputs/shipped_scenes.h"

namespace fumon {

namespace {

struct NewOptions {
    std::string name;
    std::string output;  ///< empty: standard output
    bool force = false;
};

void declare(CLI::App& command, NewOptions& options) {
    command
        .add_option("NAME", options.name,
                    "a scene that fumon ships (`fumon scenes`), or a word of its name")
        ->required();
    command.add_option("-o,--output", options.output, "the file (default: standard output)")
        ->type_name("FILE.toml");
    add_force(command, options.force, "replace the file that is there");
    add_examples(
        command,
        {{"fumon new barchans > my.toml", "a scene to edit"},
         {"fumon new figures/sudo-2002-06 -o figure.toml", "a figure"},
         {"fumon new films/barchans -o film.toml", "a film"}},
        "Its comments come with it, and the files that it reads are named where they lie.");
}

int perform(const NewOptions& options) {
    const std::vector<ShippedScene> meant = matching_scenes(options.name);
    const std::string text = relocatable_text(meant.front());
    if (options.output.empty() || options.output == "-") {
        std::fputs(text.c_str(), stdout);
    } else {
        check_ending(options.output, "a scene", scene_ending);
        OutputClaims claims(options.force);
        claims.reads(meant.front().file);
        claims.writes(options.output);
        write_file(options.output, text);
    }
    if (meant.size() > 1) {
        std::string others;
        for (std::size_t k = 1; k < meant.size(); ++k)
            others += (others.empty() ? "" : ", ") + meant[k].name;
        remark(fmt::format("this is {}; there are also {}\n", meant.front().name, others));
    }
    return 0;
}

}  // namespace

Command new_command() {
    return make_command<NewOptions>("new", "print a scene that fumon ships, ready to be edited",
                                    declare, perform);
}

}  // namespace fumon
