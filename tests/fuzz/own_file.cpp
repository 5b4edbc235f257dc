// Files that stand where an output would: are they fumon's own?

#include "outputs/own_file.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fumon::fuzz::MemoryFile file(fumon::fuzz::as_text(data, size));
    fumon::is_made_by_fumon(file.path());
    return 0;
}
