#include "verify/kept_records.h"

#include <fmt/format.h>

#include <system_error>

#include "base/error.h"
#include "files/atomic_file.h"

namespace fumon {

void keep_picture(const Baseline& baseline, const std::string& record, std::string_view png) {
    const std::filesystem::path file = baseline.picture_of(record);
    std::error_code fault;
    std::filesystem::create_directories(file.parent_path(), fault);
    if (fault) {
        throw Error(
            fmt::format("cannot make {}: {}", file.parent_path().string(), fault.message()));
    }
    write_file(file, png);
}

BaselineRecords all_records(const Baseline& baseline) {
    BaselineRecords all = baseline.records;
    all.insert(baseline.orphans.begin(), baseline.orphans.end());
    return all;
}

bool write_lock(const Baseline& baseline, const BaselineRecords& before, bool partly) {
    const std::string now =
        lock_text(partly ? all_records(baseline) : baseline.records, LockOwner::verify);
    if (now == lock_text(before, LockOwner::verify) && !baseline.unlocked) return false;
    write_file(baseline.lock(), now);
    if (baseline.unlocked) write_file(baseline.file, baseline.head);
    return true;
}

}  // namespace fumon
