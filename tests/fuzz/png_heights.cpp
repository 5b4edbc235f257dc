// Terrain in grey PNG images.

#include "files/terrain/png_heights.h"

#include "fuzz_input.h"
#include "png_mutation.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    fuzz::taken([&] { parse_png_heights(fuzz::as_text(data, size), "terrain.png", {0.0, 100.0}); });
    return 0;
}
