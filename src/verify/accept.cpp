#include "verify/accept.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "base/error.h"
#include "files/input_file.h"
#include "shards/slurm_script.h"
#include "verify/case_selection.h"
#include "verify/got_records.h"
#include "verify/kept_records.h"
#include "verify/record_choice.h"
#include "verify/results_folder.h"

namespace fumon {

namespace {

/// A case whose picture is taken over.
struct Accepted {
    std::size_t suite;
    const BaselineCase* one;
    GotPicture got;
    std::string record;  ///< see record_name()
};

Accepted find_accepted(const VerificationOptions& options, const std::vector<Suite>& suites,
                       const std::string& name) {
    VerificationOptions asked;
    asked.names = {name};
    const std::vector<ChosenCase> chosen = chosen_cases(asked, suites);
    if (chosen.empty()) throw InputError(fmt::format("no case is named \"{}\"", name));
    if (chosen.size() > 1) {
        throw InputError(fmt::format("several cases are named \"{}\"; name one baseline, or {}/{}",
                                     name, suites[chosen.front().suite].name, name));
    }
    const Baseline& baseline = suites[chosen.front().suite].baseline;
    const BaselineCase& one = baseline.cases[chosen.front().number];
    if (!one.fault.empty()) throw InputError(one.fault);
    GotPicture got = find_got_picture(last_results(options), baseline.file, one.name);
    std::string record =
        record_to_write(baseline, one, got.record.environment, options.this_environment);
    return {chosen.front().suite, &one, std::move(got), std::move(record)};
}

}  // namespace

int accept_results(const VerificationOptions& options, std::vector<Suite>& suites) {
    for (const Suite& suite : suites) {
        if (!suite.fault.empty()) throw InputError(suite.fault);
    }
    std::vector<Accepted> all;
    all.reserve(options.accepts.size());
    for (const std::string& name : options.accepts)
        all.push_back(find_accepted(options, suites, name));
    std::vector<ChosenCase> chosen;
    chosen.reserve(all.size());
    for (const Accepted& one : all) {
        chosen.push_back({one.suite, static_cast<std::size_t>(
                                         one.one - suites[one.suite].baseline.cases.data())});
    }
    claim_records(options, suites, chosen);
    for (const Accepted& accepted : all) {
        Baseline& baseline = suites[accepted.suite].baseline;
        const BaselineRecords before = all_records(baseline);
        const auto found = baseline.records.find(accepted.record);
        std::string what = "recorded";
        if (found != baseline.records.end()) what = changes(found->second, accepted.got.record);
        baseline.records[accepted.record] = accepted.got.record;
        if (accepted.one->picture)
            keep_picture(baseline, accepted.record, read_input_file(accepted.got.file));
        write_lock(baseline, before, true);
        baseline.unlocked = false;
        if (!options.quietly()) {
            fmt::print("{:<8} {} {}: {}\n", what.empty() ? "kept" : "accepted",
                       suites[accepted.suite].name, accepted.record,
                       what.empty() ? "as recorded" : what);
        }
    }
    return all_is_well;
}

std::string accept_command(const std::string& baseline, const std::string& name,
                           const std::string& folder) {
    std::string command =
        fmt::format("fumon verify {} --accept {}", shell_word(baseline), shell_word(name));
    if (folder != usual_results) command += " -o " + shell_word(folder);
    return command;
}

}  // namespace fumon
