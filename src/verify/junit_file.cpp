#include "verify/junit_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "files/atomic_file.h"

namespace fumon {

JunitFile::JunitFile(std::string file, OutputClaims& claims)
    : file_(std::move(file)),
      began_(fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(std::time(nullptr)))) {
    if (file_.empty()) return;
    check_ending(file_, "a JUnit report", junit_ending);
    claims.writes(file_);
    std::error_code fault;
    if (!std::filesystem::is_regular_file(file_, fault)) return;  // /dev/stdout stays
    std::filesystem::remove(resolved_link(file_), fault);
    if (fault) throw Error(fmt::format("cannot remove {}: {}", file_, fault.message()));
}

void JunitFile::write(const std::vector<JunitCase>& cases) {
    if (file_.empty()) return;
    write_file(file_, junit_xml(cases, began_));
    written_ = true;
}

void JunitFile::write_fault(Outcome outcome, const std::string& fault) noexcept {
    if (written_) return;
    try {
        write({{"fumon verify", "start", {outcome, fault}}});
    } catch (const std::exception& refused) {
        std::fprintf(stderr, "%s\n", refused.what());
    }
}

}  // namespace fumon
