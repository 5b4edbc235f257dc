// What a picture says of its own making, and its pixels; the scene in it, where it is small, is
// drawn once more.

#include "run/picture_text.h"

#include "draw_small.h"
#include "png_mutation.h"
#include "read_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const fuzz::MemoryFile file(fuzz::as_text(data, size));
    PictureOrigin origin;
    if (fuzz::taken([&] { origin = read_origin(file.path()); })) {
        const auto scene = fuzz::read_small_scene(origin.scene);
        if (scene) fuzz::taken([&] { fuzz::draw_small(*scene, make_initial_bed(*scene)); });
    }
    fuzz::taken([&] { read_png(file.path()); });
    return 0;
}
