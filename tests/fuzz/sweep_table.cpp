// The measurements of runs, joined into a sweep's table: the input is one run's and, behind a zero
// byte, another's.

#include "sweep/sweep_table.h"

#include "files/input_file.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const std::string_view input = fuzz::as_text(data, size);
    const std::size_t end = std::min(input.find('\0'), input.size());
    const fuzz::MemoryFile one(input.substr(0, end));
    const fuzz::MemoryFile other(input.substr(std::min(end + 1, input.size())));
    static const auto table =
        std::filesystem::path("/dev/shm") / ("fumon-fuzz-" + std::to_string(::getpid()) + ".csv");
    try {
        write_table(table, {"run", "key"},
                    {{{"1", "=a,b"}, one.path()}, {{"2", "c"}, other.path()}});
    } catch (const Error&) {
        return 0;  // no header
    }
    const std::string text = read_input_file(table);
    if (!text.starts_with("run,key,")) fuzz::broken_promise("a sweep's table has its keys", text);
    std::filesystem::remove(table);
    return 0;
}
