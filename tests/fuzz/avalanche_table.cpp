// Tables of avalanches.

#include "files/avalanche_table.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    fuzz::taken([&] { parse_avalanches({"avalanches.csv", fuzz::as_text(data, size)}); });
    return 0;
}
