// run.json: which files of a folder are a run's own.

#include "fuzz_input.h"
#include "run/run_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const fuzz::MemoryFile file(fuzz::as_text(data, size));
    const RunFiles listed = listed_files(file.path());
    for (const char* name :
         {"frames/frame_000002.png", "movie_frames/frame_1000000.png", "beds/bed_00000010.asc",
          "beds/bed_00000010.prj.part", "beds/bed_100000000.nc"})
        (void)listed.contains(name);
    for (const char* name :
         {"../scene.toml", "notes.txt", "beds/bed_10.asc", "frames/frame_1.png"}) {
        if (listed.contains(name) && !listed.files.contains(name))
            fuzz::broken_promise("a run's files are called as a run calls its own", name);
    }
    return 0;
}
