#include "verify/suites.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <set>
#include <utility>

#include "base/error.h"
#include "scene/scene_files.h"
#include "verify/case_work.h"
#include "verify/kept_records.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

Suite read_suite(const std::string& file) {
    try {
        return {read_baseline(file, WrongCases::kept), fs::path(file).stem().string()};
    } catch (const std::exception& fault) {
        Suite suite;
        suite.baseline.file = file;
        suite.name = fs::path(file).stem().string();
        suite.fault = fault.what();
        return suite;
    }
}

void add_orphans(Baseline& baseline) {
    for (const auto& [name, record] : baseline.orphans) {
        BaselineCase one;
        one.name = name;
        one.fault = fmt::format(
            "{}: recorded.{} belongs to no case; restore its case, or remove the record with "
            "`fumon verify --update`",
            recorded_in(baseline).string(), name);
        baseline.cases.push_back(std::move(one));
    }
}

}  // namespace

fs::path recorded_in(const Baseline& baseline) {
    return baseline.unlocked ? baseline.file : baseline.lock();
}

std::vector<Suite> read_suites(const VerificationOptions& options) {
    std::vector<Suite> suites;
    std::set<std::string> names;
    for (const std::string& file : options.baselines) {
        Suite suite = read_suite(file);
        for (int n = 2; !names.insert(suite.name).second; ++n)
            suite.name = fmt::format("{}-{}", fs::path(file).stem().string(), n);
        if (!options.update) add_orphans(suite.baseline);
        if (suite.baseline.unlocked && !options.update && !options.quietly()) {
            fmt::print(stderr,
                       "{}: recorded values are in the baseline, as before version 0.2; `fumon "
                       "verify --update` moves them into {}\n",
                       file, suite.baseline.lock().string());
        }
        suites.push_back(std::move(suite));
    }
    return suites;
}

void note_inputs(const VerificationOptions& options, const std::vector<Suite>& suites,
                 OutputClaims& claims) {
    for (const Suite& suite : suites) {
        for (const BaselineCase& one : suite.baseline.cases) {
            if (!one.fault.empty()) continue;
            try {
                const Scene scene =
                    scene_of(suite.baseline, one, options.trust,
                             version_of(suite.baseline, one, defaults_of(options), one.name));
                claims.reads(scene.source);
                claims.reads(scene_files(scene));
                if (!one.ignore.mask.empty())
                    claims.reads(suite.baseline.file.parent_path() / one.ignore.mask);
            } catch (const std::exception&) {
                continue;
            }
        }
    }
}

void claim_records(const VerificationOptions& options, const std::vector<Suite>& suites,
                   const std::vector<ChosenCase>& chosen) {
    OutputClaims updates(options.force);
    note_inputs(options, suites, updates);
    std::set<std::size_t> claimed;
    for (const ChosenCase& at : chosen) {
        const Baseline& baseline = suites[at.suite].baseline;
        const BaselineCase& one = baseline.cases[at.number];
        if (claimed.insert(at.suite).second) {
            if (baseline.unlocked) updates.writes(baseline.file, true);
            updates.writes(baseline.lock(), !all_records(baseline).empty());
        }
        if (!one.picture || !one.fault.empty()) continue;
        check_output_folder(baseline.picture_of(one).parent_path(), "the pictures");
        std::vector<std::string> names{one.name};
        for (const std::string& environment : one.environments)
            names.push_back(record_name(one.name, environment));
        for (const std::string& name : names)
            updates.check(baseline.picture_of(name), baseline.records.contains(name));
    }
}

}  // namespace fumon
