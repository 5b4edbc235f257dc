#include "cite/methods_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "cite/reference_text.h"
#include "cite/scene_works.h"
#include "keys/key_value.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

std::string sources_of(const Scene& scene) {
    std::vector<std::string> parts;
    for (const CitedWork& cited : works_of(scene))
        parts.push_back(fmt::format("{} ({})", cited.what, short_citation(*cited.work)));
    return fmt::format("{}", fmt::join(parts, "; "));
}

/// "creep_rate = 0.2, …": parameters of the model whose value is not the default.
std::string parameters_of(const Scene& scene) {
    Scene read = scene;
    Scene usual = default_scene(scene.model.name);
    const KeyTable table = scene_keys(read);
    const KeyTable defaults = scene_keys(usual);
    std::vector<std::string> parts;
    for (const Key& key : table.keys()) {
        const Key* other = defaults.find(key.path);
        if (!key.path.starts_with("model.") || key.path == "model.name") continue;
        const std::string value = value_text(key);
        if (other != nullptr && value == value_text(*other)) continue;
        const std::string unit = key.notes.unit.empty() ? "" : fmt::format(" {}", key.notes.unit);
        parts.push_back(fmt::format("{} = {}{}", key.path.substr(6), value, unit));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string cells_of(const Scene& scene) {
    if (!scene.bed.file.empty())
        return fmt::format("the terrain {}",
                           std::filesystem::path(scene.bed.file).filename().string());
    std::string text = fmt::format("a grid of {} × {} cells", scene.grid.nx, scene.grid.ny);
    const std::vector<double>& size = scene.grid.cell_size;
    if (!size.empty()) text += fmt::format(" of {:g} m × {:g} m", size.front(), size.back());
    return text;
}

}  // namespace

std::string methods_text(const Scene& scene, const std::string& scene_hash) {
    std::string text = fmt::format(
        "Simulations were made with fumon {} (The fumon developers), model \"{}\", on {}, for {} "
        "steps.",
        FUMON_VERSION, scene.model.name, cells_of(scene), scene.run.steps);
    if (const std::string sources = sources_of(scene); !sources.empty())
        text += fmt::format(" Sources: {}.", sources);
    const std::string parameters = parameters_of(scene);
    text +=
        parameters.empty()
            ? " All parameters of the model have fumon's defaults."
            : fmt::format(" Parameters of the model other than fumon's defaults: {}.", parameters);
    return text +
           fmt::format(" Random seed {}; SHA-256 of the scene {}.\n", scene.seed, scene_hash);
}

}  // namespace fumon
