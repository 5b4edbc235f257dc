// Palettes.

#include "render/colour/palette.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    fuzz::taken([&] { parse_palette(fuzz::as_text(data, size), "palette.txt"); });
    return 0;
}
