#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "support/preload/call_log.h"
#include "support/program.h"

namespace fumon::test {

/// How a program's file operations are made to fail.
struct Disturbance {
    std::int64_t call = 0;  ///< the number of the one that fails, from 1; 0: none does
    int error = EIO;
    bool lasting = false;       ///< all later ones fail, too
    std::filesystem::path log;  ///< gets all operations that change something; empty: none
};

struct Disturbed {
    Ended ended;
    CallReport report;
};

/// Runs fumon in a folder, with failing operations on files in that folder (support/preload).
inline Disturbed disturbed_fumon(const std::vector<std::string>& words,
                                 const std::filesystem::path& folder,
                                 const Disturbance& disturbance) {
    const ScratchFolder scratch;
    const std::filesystem::path report = scratch / "report";
    std::vector<std::string> environment{
        "LD_PRELOAD=" FUMON_FAILING_CALLS,
        "FUMON_CALLS_FOLDER=" + std::filesystem::canonical(folder).string(),
        "FUMON_CALLS_REPORT=" + report.string(),
        "FUMON_CALLS_FAIL=" + std::to_string(disturbance.call),
        "FUMON_CALLS_ERRNO=" + std::to_string(disturbance.error),
        "FUMON_CALLS_LASTING=" + std::string(disturbance.lasting ? "1" : "0")};
    if (!disturbance.log.empty())
        environment.push_back("FUMON_CALLS_LOG=" + disturbance.log.string());
    Disturbed done;
    done.ended = fumon(words, folder, environment);
    const std::string bytes = read_text(report);
    if (bytes.size() == sizeof done.report)
        std::memcpy(&done.report, bytes.data(), sizeof done.report);
    return done;
}

/// Whether every case is to be tried rather than a sample: FUMON_ALL_FAILURES=1.
inline bool tries_all_failures() {
    const char* all = std::getenv("FUMON_ALL_FAILURES");
    return all != nullptr && std::string(all) == "1";
}

}  // namespace fumon::test
