// Baselines of pictures under test, as people write them and as older ones hold their records.

#include "picture/baseline.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fumon;
    Baseline baseline;
    const auto read = [&baseline](std::string_view bytes) {
        const fuzz::MemoryFile file(bytes);
        return fuzz::taken([&] { baseline = read_baseline(file.path()); });
    };
    if (!read(fuzz::as_text(data, size))) return 0;
    const std::string lock = lock_text(baseline.records, LockOwner::verify);
    const std::string head = baseline.head;
    if (!read(head) || baseline.head != head || !baseline.records.empty())
        fuzz::broken_promise("what people wrote reads back without its records", head);
    std::string again;
    const fuzz::MemoryFile file(lock);
    if (!fuzz::taken([&] {
            again = lock_text(read_lock(file.path(), LockOwner::verify), LockOwner::verify);
        }) ||
        again != lock)
        fuzz::broken_promise("a written lock reads back the same", lock);
    return 0;
}
