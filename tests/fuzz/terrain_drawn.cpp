// ESRI ASCII grids that are taken and small: the smallest picture of each, on a table, over
// endless ground and as a map.

#include <array>

#include "draw_small.h"
#include "files/terrain/esri_ascii.h"
#include "scene/read.h"

namespace {

using namespace fumon;

/// A way to look at a terrain.
const std::array<Scene, 3>& looks() {
    static const auto scene = [](const char* lines) {
        return parse_scene(lines, "scene.toml", "");
    };
    // A periodic bed repeats over endless ground; the plain around another takes 1 GB.
    static const std::array all{
        scene("model.name = \"static\"\nlook.ground = \"table\""),
        scene("model.name = \"sand\"\nrun.steps = 1\nlook.ground = \"endless\""),
        scene("model.name = \"static\"\ncamera.projection = \"map\"")};
    return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t most_cells = 1024;
    const Scene& look = looks()[size % looks().size()];
    fuzz::taken([&] {
        Terrain terrain = parse_esri_ascii({"terrain.asc", fuzz::as_text(data, size)});
        if (terrain.heights.size() > most_cells) return;
        InitialBed initial;
        initial.bed = terrain.heights;
        initial.nodata = terrain.nodata;
        initial.scale = {terrain.dx, terrain.dy, 1.0, true};
        fuzz::draw_small(look, initial);
    });
    return 0;
}
