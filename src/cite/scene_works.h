#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cite/work.h"
#include "scene/scene.h"

namespace fumon {

/// A work and what a scene takes from it.
struct CitedWork {
    const Work* work = nullptr;
    std::string what;  ///< "plants", "flux between cells"
};

/// The works behind the model, options, palettes and shipped data of a scene, each once, those of
/// the model first.
std::vector<CitedWork> works_of(const Scene& scene);

/// Where a key's value makes a scene cite a work: the table that works_of() follows.
struct CitingRule {
    std::string_view work;
    std::string_view model;  ///< of the scene; empty: any
    std::string_view key;    ///< empty: always
    std::string_view value;  ///< as TOML has it
    std::string_view what;
};
std::vector<CitingRule> citing_rules();

}  // namespace fumon
