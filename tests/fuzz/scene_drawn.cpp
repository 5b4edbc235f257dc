// Scenes that are taken and have a small grid: the smallest picture of their first bed.

#include "draw_small.h"
#include "read_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const auto scene = fuzz::read_small_scene(data, size);
    if (!scene) return -1;
    fuzz::taken([&] { fuzz::draw_small(*scene, make_initial_bed(*scene)); });
    return 0;
}
