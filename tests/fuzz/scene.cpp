// Scene files: the reader alone.

#include "read_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fumon::fuzz::read_scene_text(std::string(fumon::fuzz::as_text(data, size)));
    return 0;
}
