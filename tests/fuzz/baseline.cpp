// Baselines of pictures under test.

#include "picture/baseline.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    std::string text;
    const auto read_and_write = [&text](std::string_view bytes) {
        const fuzz::MemoryFile file(bytes);
        return fuzz::taken([&] { text = baseline_text(read_baseline(file.path())); });
    };
    if (!read_and_write(fuzz::as_text(data, size))) return 0;
    const std::string written = text;
    if (!read_and_write(written) || text != written)
        fuzz::broken_promise("a written baseline reads back the same", written);
    return 0;
}
