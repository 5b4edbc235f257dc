#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/terminal/work_options.h"
#include "shards/shard.h"
#include "verify/annotations.h"

namespace fumon {

/// What `fumon verify` is asked.
struct VerificationOptions {
    std::vector<std::string> baselines;
    std::vector<std::string> names;     ///< of the cases that are meant; none: all
    std::vector<std::string> patterns;  ///< likewise, see chooses()
    std::string folder;  ///< of results; empty: verify-out, or a temporary one (ResultsFolder)
    std::string junit;   ///< a file of JUnit XML; empty: none
    std::optional<Shard> shard;  ///< of the cases meant, every so-manieth
    std::vector<std::string>
        accepts;                    ///< cases whose new picture of the last results is taken over
    bool list = false;              ///< tell the cases, and draw nothing
    bool update = false;            ///< record instead of comparing
    bool this_environment = false;  ///< record for the environment alone in which this runs
    bool isolate = true;            ///< draw in a child process (CaseProcesses)
    bool force = false;             ///< replace files of others, too
    bool trust = false;             ///< what the baselines name, without limits
    bool as_json = false;           ///< what is found is printed as JSON alone
    ReportFormat format = ReportFormat::lines;
    WorkOptions work;

    [[nodiscard]] bool quietly() const { return work.verbosity == Verbosity::quiet; }
};

/// Draws every chosen case of the baselines and compares it with its record (or records it), saying
/// on standard output what it finds. A case that cannot be drawn, whatever the reason, is an error
/// of its own, and so is a baseline that cannot be read: the others are compared, and the report
/// and the page tell of all. Returns the highest ExitStatus that occurred: a signal is
/// could_not_work. Throws InputError where what is asked cannot be, Error where nothing can be
/// written; the JUnit report tells that, too.
int verify(const VerificationOptions& options);

}  // namespace fumon
