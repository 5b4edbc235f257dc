#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "cite/methods_text.h"
#include "cite/reference_text.h"
#include "cite/scene_works.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/hash.h"
#include "run/inputs/scene_argument.h"
#include "scene/read.h"

namespace fumon {

namespace {

struct CiteOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> settings;
    std::string format = "text";
    bool methods = false;
};

void declare(CLI::App& command, CiteOptions& options) {
    command.add_option("SCENE", options.scenes, "scene files, or names of shipped scenes")
        ->required();
    add_word(command, "--format", options.format, {"text", "bibtex", "ris"},
             "of the reference list (default text)");
    command.add_flag("--methods", options.methods,
                     "a paragraph for a paper's methods for each scene, instead of references");
    add_settings(command, options.settings, "override a scene key");
    add_examples(command,
                 {{"fumon cite terada-barchans", "the works behind a scene"},
                  {"fumon cite my.toml other.toml --format bibtex > fumon.bib", "for LaTeX"},
                  {"fumon cite my.toml --methods", "model, sources, parameters and hash"}});
}

ReferenceFormat reference_format(const std::string& word) {
    if (word == "bibtex") return ReferenceFormat::bibtex;
    return word == "ris" ? ReferenceFormat::ris : ReferenceFormat::text;
}

int perform(const CiteOptions& options) {
    const std::vector<Override> overrides = read_settings(options.settings);
    std::string methods;
    std::vector<const Work*> works;
    for (const std::string& given : options.scenes) {
        const std::string file = scene_argument(given);
        const Scene scene = parse_scene(read_scene_text(file), overrides);
        if (options.methods) methods += methods_text(scene, hex(file_hash(file)));
        for (const CitedWork& cited : works_of(scene)) {
            if (std::ranges::find(works, cited.work) == works.end()) works.push_back(cited.work);
        }
    }
    const std::string text =
        options.methods ? methods : reference_list(works, reference_format(options.format));
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace

Command cite_command() {
    return make_command<CiteOptions>(
        "cite", "the works behind scenes: references (BibTeX, RIS) or a paragraph of methods",
        declare, perform);
}

}  // namespace fumon
