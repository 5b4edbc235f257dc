#include "scene/scene.h"

namespace fumon {

std::string Scene::at(const std::string& key) const {
    const auto found = locations.find(key);
    if (found != locations.end()) return found->second + ": ";
    return source.empty() ? std::string{} : source + ": ";
}

bool Scene::set_on_command_line(const std::string& key) const {
    const auto found = locations.find(key);
    return found != locations.end() &&
           (found->second.starts_with("--set ") || found->second.starts_with("--over ") ||
            found->second == python_place);
}

}  // namespace fumon
