#include "cli/commands.h"

// A command a line: COMMAND(name) is what name_command() of cli/name_command.cpp returns.
#define FUMON_COMMANDS(COMMAND) \
    COMMAND(run)                \
    COMMAND(sweep)              \
    COMMAND(figure)             \
    COMMAND(still)              \
    COMMAND(view)               \
    COMMAND(hop_law)            \
    COMMAND(film)               \
    COMMAND(gallery)            \
    COMMAND(render)             \
    COMMAND(again)              \
    COMMAND(measure)            \
    COMMAND(profile)            \
    COMMAND(export)             \
    COMMAND(orientation)        \
    COMMAND(fingerprint)        \
    COMMAND(compare)            \
    COMMAND(verify)             \
    COMMAND(check)              \
    COMMAND(cite)               \
    COMMAND(models)             \
    COMMAND(describe)           \
    COMMAND(scenes)             \
    COMMAND(new)                \
    COMMAND(completion)         \
    COMMAND(man)                \
    COMMAND(help)

namespace fumon {

#define FUMON_DECLARED(name) Command name##_command();
FUMON_COMMANDS(FUMON_DECLARED)
#undef FUMON_DECLARED

std::vector<Command> commands() {
#define FUMON_LISTED(name) name##_command(),
    return {FUMON_COMMANDS(FUMON_LISTED)};
#undef FUMON_LISTED
}

}  // namespace fumon
