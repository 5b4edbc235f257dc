// --over and --seeds: the input's first line is an axis, the second one names seeds.

#include "sweep/sweep_axis.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    const std::string text(fuzz::as_text(data, size));
    const std::size_t end = text.find('\n');
    fuzz::taken([&] {
        const SweepAxis axis = read_axis(text.substr(0, end), "--over 1");
        if (axis.keys.empty() || axis.values.empty() ||
            axis.values.size() > static_cast<std::size_t>(most_runs))
            fuzz::broken_promise("an axis has keys and values", text);
    });
    if (end == std::string::npos) return 0;
    fuzz::taken([&] {
        const SeedRange seeds = read_seeds(text.substr(end + 1), 1);
        if (seeds.count() < 1 || seeds.count() > most_runs)
            fuzz::broken_promise("seeds are some and not too many", text);
    });
    return 0;
}
