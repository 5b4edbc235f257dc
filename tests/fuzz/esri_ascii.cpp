// ESRI ASCII grids.

#include "files/terrain/esri_ascii.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    Terrain terrain;
    const bool taken = fuzz::taken([&] {
        terrain = parse_esri_ascii({"terrain.asc", fuzz::as_text(data, size)});
    });
    if (!taken) return 0;
    const std::string text = esri_ascii(terrain.heights, terrain.nodata, terrain.dx, terrain.dy);
    const Terrain again = parse_esri_ascii({"again.asc", text});
    if (esri_ascii(again.heights, again.nodata, again.dx, again.dy) != text)
        fuzz::broken_promise("a written terrain reads back the same", text);
    return 0;
}
