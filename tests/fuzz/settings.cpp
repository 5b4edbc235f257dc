// --set: the input's first line names a model, every further line is one key.path=VALUE.

#include <sstream>

#include "read_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream lines{std::string(fumon::fuzz::as_text(data, size))};
    std::string model;
    std::getline(lines, model);
    if (fumon::find_model(model) == nullptr) return -1;
    std::vector<std::string> settings;
    for (std::string line; std::getline(lines, line);) settings.push_back(line);
    fumon::fuzz::read_and_build(
        "[model]\nname = \"" + model + "\"\n[grid]\nnx = 16\nny = 16\n[run]\nsteps = 8\n",
        settings);
    return 0;
}
