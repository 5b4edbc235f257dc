#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/examples.h"
#include "run/inputs/shipped_scenes.h"
#include "scene/json.h"

namespace fumon {

namespace {

struct ScenesOptions {
    bool as_json = false;
};

void declare(CLI::App& command, ScenesOptions& options) {
    command.add_flag("--json", options.as_json, "as JSON");
    add_examples(command, {{"fumon scenes", ""},
                           {"fumon new dunes-barchans", "print one, to be edited"},
                           {"fumon run dunes-barchans -o out/barchans", "run one as it is"},
                           {"fumon figure sudo-2002-06 -o out/figures", "make one of figures/"}});
}

int perform(const ScenesOptions& options) {
    const std::vector<ShippedScene> all = shipped_scenes(shipped_folders);
    if (options.as_json) {
        auto json = nlohmann::ordered_json::array();
        for (const ShippedScene& scene : all) {
            json.push_back(
                {{"name", scene.name}, {"title", scene.title}, {"file", scene.file.string()}});
        }
        std::fputs((json_text(json, 2) + "\n").c_str(), stdout);
        return 0;
    }
    std::size_t width = 0;
    for (const ShippedScene& scene : all) width = std::max(width, scene.name.size());
    for (const ShippedScene& scene : all)
        fmt::print("{:<{}}  {}\n", scene.name, width, scene.title);
    return 0;
}

}  // namespace

Command scenes_command() {
    return make_command<ScenesOptions>(
        "scenes", "list the scenes, figures and films that fumon ships", declare, perform);
}

}  // namespace fumon
