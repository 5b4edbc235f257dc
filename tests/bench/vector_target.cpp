// Linked into every benchmark: FUMON_VECTOR_TARGET chooses the vector target, as it does for fumon.

#include <cstdio>
#include <cstdlib>

#include "base/error.h"
#include "vectors/target.h"

namespace {

const bool chosen = [] {
    try {
        fumon::vectors::use_target_of_environment();
    } catch (const fumon::InputError& refusal) {
        std::fprintf(stderr, "%s\n", refusal.what());
        std::exit(2);
    }
    std::printf("vector target: %s\n", fumon::vectors::target().c_str());
    return true;
}();

}  // namespace
