// Film files: the reader, and the frames of what it takes.

#include "film/film_read.h"
#include "film/timeline.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    Film film;
    const auto read = [&] { film = parse_film(fuzz::as_text(data, size), "film.toml", {}, false); };
    if (!fuzz::taken(read, fuzz::RefusalLines::many)) return -1;
    const Timeline timeline(film);
    if (timeline.frames() < 1) fuzz::broken_promise("a film has a frame", "");
    for (const std::int64_t frame : {std::int64_t{0}, timeline.frames() / 2, timeline.frames() - 1})
        if (timeline.at(frame).empty()) fuzz::broken_promise("a frame shows something", "");
    return 0;
}
