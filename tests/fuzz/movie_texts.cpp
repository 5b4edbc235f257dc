// What an MP4 movie says of its own making.

#include "fuzz_input.h"
#include "mp4_mutation.h"
#include "picture/movie.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const fuzz::MemoryFile file(fuzz::as_text(data, size));
    fuzz::taken([&] {
        if (!is_movie(file.path())) return;
        for (const auto& [keyword, text] : read_movie_texts(file.path())) {
            if (keyword.empty()) fuzz::broken_promise("a text has a keyword", text);
        }
    });
    return 0;
}
