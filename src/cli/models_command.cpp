#include <cstdio>

#include "cli/command.h"
#include "scene/describe.h"

namespace fumon {

Command models_command() {
    return {"models", "list the models", [](CLI::App&) -> std::function<int()> {
                return [] {
                    std::fputs(models_text().c_str(), stdout);
                    return 0;
                };
            }};
}

}  // namespace fumon
