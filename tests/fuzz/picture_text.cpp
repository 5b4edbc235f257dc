// What a picture says of its own making, and its pixels.

#include "run/picture_text.h"

#include "fuzz_input.h"
#include "png_mutation.h"
#include "scene/read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const fuzz::MemoryFile file(fuzz::as_text(data, size));
    PictureOrigin origin;
    if (fuzz::taken([&] { origin = read_origin(file.path()); }))
        fuzz::taken([&] { parse_scene(origin.scene, "picture.png", ""); },
                    fuzz::RefusalLines::many);
    fuzz::taken([&] { read_png(file.path()); });
    return 0;
}
