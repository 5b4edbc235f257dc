// --set: the input's first line names a model, every further line is one key.path=VALUE.

#include <sstream>

#include "models/registry.h"
#include "read_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    std::istringstream lines{std::string(fuzz::as_text(data, size))};
    std::string model;
    std::getline(lines, model);
    if (find_model(model) == nullptr) return -1;
    std::vector<std::string> settings;
    for (std::string line; std::getline(lines, line);) settings.push_back(line);
    fuzz::read_scene_text(
        "[model]\nname = \"" + model + "\"\n[grid]\nnx = 16\nny = 16\n[run]\nsteps = 8\n",
        settings);
    return 0;
}
