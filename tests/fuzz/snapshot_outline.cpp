// What the store of finished runs says of a run's snapshots.

#include "files/snapshot_outline.h"

#include "files/json_text.h"
#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    fuzz::taken([&] {
        try {
            const nlohmann::ordered_json json = parse_json(fuzz::as_text(data, size));
            constexpr std::int64_t most = 512;
            if (whole_number(json.at("nx")) > most || whole_number(json.at("ny")) > most) return;
            const Snapshot outline = read_outline(json);
            if (read_outline(outline_json(outline)).bed.size() != outline.bed.size())
                fuzz::broken_promise("an outline reads back the same", "");
        } catch (const nlohmann::json::exception&) {  // damaged
        }
    });
    return 0;
}
