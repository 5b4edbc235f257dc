#include <cstdio>

#include "cli/command.h"
#include "cli/examples.h"
#include "scene/describe.h"

namespace fumon {

namespace {

struct ModelsOptions {
    bool as_json = false;
};

void declare(CLI::App& command, ModelsOptions& options) {
    command.add_flag("--json", options.as_json, "as JSON");
    add_examples(command, {{"fumon models", ""}, {"fumon describe sand", "the keys of one"}});
}

int perform(const ModelsOptions& options) {
    std::fputs((options.as_json ? models_json() : models_text()).c_str(), stdout);
    return 0;
}

}  // namespace

Command models_command() {
    return make_command<ModelsOptions>("models", "list the models", declare, perform);
}

}  // namespace fumon
