#include "verify/verification.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/stopwatch.h"
#include "files/atomic_file.h"
#include "files/hash.h"
#include "outputs/output_claims.h"
#include "picture/junit.h"
#include "picture/png.h"
#include "run/drawing.h"
#include "run/terminal/interrupt.h"
#include "scene/json.h"
#include "scene/scene_files.h"
#include "verify/verify_case.h"
#include "verify/verify_page.h"

namespace fumon {

namespace {

CaseDefaults defaults_of(const VerificationOptions& options) {
    return options.update ? CaseDefaults::of_today : CaseDefaults::as_recorded;
}

namespace fs = std::filesystem;

/// A baseline and what its part of the output folder is called.
struct Suite {
    Baseline baseline;
    std::string name;
};

fs::path recorded_in(const Baseline& baseline) {
    return baseline.unlocked ? baseline.file : baseline.lock();
}

/// Reads all baselines and their scenes before anything is drawn, so that a mistake is found at
/// once.
std::vector<Suite> read_suites(const VerificationOptions& options) {
    std::vector<Suite> suites;
    std::set<std::string> names;
    for (const std::string& file : options.baselines) {
        Suite suite{read_baseline(file), fs::path(file).stem().string()};
        for (int n = 2; !names.insert(suite.name).second; ++n)
            suite.name = fmt::format("{}-{}", fs::path(file).stem().string(), n);
        for (const BaselineCase& one : suite.baseline.cases)
            scene_of(suite.baseline, one, options.trust, defaults_of(options));
        if (!suite.baseline.orphans.empty() && !options.update) {
            throw InputError(
                fmt::format("{}: recorded.{} belongs to no case; bring its case back, or let "
                            "`fumon verify --update` remove what is recorded",
                            recorded_in(suite.baseline).string(), suite.baseline.orphans.front()));
        }
        if (suite.baseline.unlocked && !options.update && !options.quietly()) {
            fmt::print(stderr,
                       "{}: what is recorded stands in the baseline, as before version 0.2; "
                       "`fumon verify --update` moves it into {}\n",
                       file, suite.baseline.lock().string());
        }
        suites.push_back(std::move(suite));
    }
    return suites;
}

/// Claims a lock and pictures to be recorded; they are fumon's where something is recorded.
void claim_records(const Baseline& baseline, OutputClaims& updates) {
    if (baseline.unlocked) updates.writes(baseline.file, true);
    updates.writes(baseline.lock(), !baseline.records.empty() || !baseline.orphans.empty());
    for (const BaselineCase& one : baseline.cases) {
        if (!one.picture) continue;
        const fs::path file = baseline.picture_of(one);
        check_output_folder(file.parent_path(), "the pictures");
        updates.check(file, baseline.records.contains(one.name));
    }
}

/// Claims what is going to be written. A baseline and the pictures that it keeps are read, and
/// replaced only where they are what is to be updated.
OutputClaims claim_outputs(const VerificationOptions& options, const std::vector<Suite>& suites) {
    OutputClaims claims(options.force);
    OutputClaims updates(options.force);
    for (const Suite& suite : suites) {
        claims.reads(suite.baseline.file);
        claims.reads(suite.baseline.lock());
        for (const BaselineCase& one : suite.baseline.cases) {
            const Scene scene = scene_of(suite.baseline, one, options.trust, defaults_of(options));
            for (OutputClaims* both : {&claims, &updates}) {
                both->reads(scene.source);
                both->reads(scene_files(scene));
            }
            if (one.picture) claims.reads(suite.baseline.picture_of(one));
            if (!one.ignore.mask.empty())
                claims.reads(suite.baseline.file.parent_path() / one.ignore.mask);
        }
    }
    if (options.update) {
        for (const Suite& suite : suites) claim_records(suite.baseline, updates);
    }
    std::error_code fault;
    if (!options.update || fs::exists(options.folder, fault))
        check_output_folder(options.folder, "the pictures");
    if (!options.junit.empty()) claims.writes(options.junit);
    return claims;
}

bool any_pinned(const std::vector<Suite>& suites) {
    return std::any_of(suites.begin(), suites.end(), [](const Suite& suite) {
        const auto& records = suite.baseline.records;
        return std::any_of(records.begin(), records.end(),
                           [](const auto& named) { return named.second.environment.pinned; });
    });
}

const char* word_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::as_recorded:
            return "ok";
        case Outcome::differs:
            return "DIFFERS";
        case Outcome::missing:
            return "MISSING";
        case Outcome::failed:
            return "FAILED";
        case Outcome::wrong_input:
            return "WRONG";
    }
    return "";
}

class Verification {
  public:
    Verification(const VerificationOptions& options, std::vector<Suite> suites)
        : options_(options),
          suites_(std::move(suites)),
          claims_(claim_outputs(options, suites_)),
          page_(options.folder, claims_) {
        for (const Suite& suite : suites_) {
            for (const BaselineCase& one : suite.baseline.cases)
                page_.check(suite.name, one.name, claims_);
        }
        work_ = options.work;
        work_.pinned = work_.pinned || any_pinned(suites_);
        if (work_.verbosity == Verbosity::normal) work_.verbosity = Verbosity::quiet;
        prepare_drawing(work_);
        if (const std::string why = why_processor_is_not_pinned(work_);
            !why.empty() && !options_.quietly())
            fmt::print(stderr, "{}: {}\n",
                       options_.update ? "recorded as not pinned" : "the portable tier compares",
                       why);
    }

    int run() {
        page_.forget();
        for (Suite& suite : suites_) {
            const std::string before = lock_text(suite.baseline.records, LockOwner::verify);
            for (const BaselineCase& one : suite.baseline.cases) {
                page_.forget(suite.name, one.name);
                const Stopwatch watch;
                JunitCase looked_at{suite.baseline.file.string(), one.name, {}};
                look_at(suite, one, looked_at);
                if (signal_ != 0) return stop();
                looked_at.seconds = watch.seconds();
                annotations_.push_back({one.place, one.name, looked_at.verdict});
                cases_.push_back(std::move(looked_at));
            }
            if (options_.update) rewrite(suite, before);
        }
        page_.finish();
        if (!options_.junit.empty()) write_file(options_.junit, junit_xml(cases_, began_));
        return conclude();
    }

  private:
    /// Draws a case and judges it: what comes of it, and the hashes of the pixels.
    void look_at(Suite& suite, const BaselineCase& one, JunitCase& result) {
        const auto recorded = suite.baseline.records.find(one.name);
        if (recorded != suite.baseline.records.end())
            result.expected_pixels = hex(recorded->second.fingerprint.pixels);
        try {
            const DrawnCase drawn =
                draw_case(suite.baseline, one, options_.trust, defaults_of(options_), work_);
            signal_ = drawn.signal;
            if (signal_ != 0) return;
            result.got_pixels = hex(drawn.record.fingerprint.pixels);
            result.verdict = options_.update ? accept(suite, one, drawn) : check(suite, one, drawn);
        } catch (const Error& fault) {
            const bool wrong = dynamic_cast<const InputError*>(&fault) != nullptr;
            result.verdict = {wrong ? Outcome::wrong_input : Outcome::failed, fault.what()};
            tell(word_of(result.verdict.outcome), suite, one, result.verdict.finding);
            if (!options_.update) page_.add(suite.name, one.name, result.verdict);
        }
    }

    Verdict check(const Suite& suite, const BaselineCase& one, const DrawnCase& drawn) {
        const auto found = suite.baseline.records.find(one.name);
        const BaselineRecord* record =
            found == suite.baseline.records.end() ? nullptr : &found->second;
        std::optional<Image> expected;
        if (record != nullptr)
            expected = recorded_picture(suite.baseline, one, *record, drawn.ignored);
        const Image* kept = expected ? &*expected : nullptr;
        Verdict verdict = judge(one, record, drawn.record, drawn.image, kept, drawn.ignored);
        if (verdict.outcome != Outcome::as_recorded || !options_.quietly())
            tell(word_of(verdict.outcome), suite, one, verdict.finding);
        if (verdict.outcome != Outcome::as_recorded)
            page_.add(suite.name, one.name, verdict, drawn.image, record, kept, drawn.ignored);
        return verdict;
    }

    Verdict accept(Suite& suite, const BaselineCase& one, const DrawnCase& drawn) {
        const auto found = suite.baseline.records.find(one.name);
        const bool fresh = found == suite.baseline.records.end();
        const std::string changed = fresh ? "" : changes(found->second, drawn.record);
        suite.baseline.records[one.name] = drawn.record;
        if (one.picture) keep_picture(suite.baseline, one, drawn);
        if (fresh) {
            tell("new", suite, one, "recorded; look at it before you keep it");
        } else if (!changed.empty()) {
            tell("changed", suite, one, changed);
        } else if (!options_.quietly()) {
            tell("kept", suite, one, "as recorded");
        }
        return {Outcome::as_recorded, fresh ? "recorded" : changed};
    }

    static void keep_picture(const Baseline& baseline, const BaselineCase& one,
                             const DrawnCase& drawn) {
        const fs::path file = baseline.picture_of(one);
        const auto bytes = encode_png(drawn.image, screen_dots_per_inch, own_text());
        std::error_code fault;
        fs::create_directories(file.parent_path(), fault);
        if (fault)
            throw Error(
                fmt::format("cannot make {}: {}", file.parent_path().string(), fault.message()));
        write_file(file, bytes);
    }

    void rewrite(Suite& suite, const std::string& before) const {
        for (const std::string& name : suite.baseline.orphans) {
            if (options_.as_json) break;
            fmt::print("{:<8} {} {}: it has no case any more\n", "removed", suite.name, name);
        }
        const std::string after = lock_text(suite.baseline.records, LockOwner::verify);
        const Baseline& baseline = suite.baseline;
        if (after != before || !baseline.orphans.empty() || baseline.unlocked)
            write_file(baseline.lock(), after);
        if (!baseline.unlocked) return;
        write_file(baseline.file, baseline.head);
        if (!options_.as_json)
            fmt::print("{:<8} {}: what is recorded, into {}\n", "moved", suite.name,
                       baseline.lock().string());
    }

    void tell(const char* word, const Suite& suite, const BaselineCase& one,
              const std::string& text) const {
        if (options_.as_json) return;
        fmt::print("{:<8} {} {}: {}\n", word, suite.name, one.name, text);
        std::fflush(stdout);
    }

    int stop() {
        page_.finish();
        return exit_status_of_signal(signal_);
    }

    [[nodiscard]] std::size_t count(Outcome outcome) const {
        return static_cast<std::size_t>(
            std::count_if(cases_.begin(), cases_.end(),
                          [&](const JunitCase& one) { return one.verdict.outcome == outcome; }));
    }

    [[nodiscard]] int conclude() const {
        const std::size_t good = count(Outcome::as_recorded);
        report_to_service();
        if (options_.as_json) {
            if (options_.format != ReportFormat::gitlab) print_json();
        } else if (!options_.update && !options_.quietly()) {
            fmt::print("{} of {} as recorded{}{}\n", good, cases_.size(),
                       page_.has_cases() ? "; see " : "",
                       page_.has_cases() ? page_.file().string() : "");
        }
        if (count(Outcome::wrong_input) > 0) return 2;
        return good == cases_.size() ? 0 : 1;
    }

    void report_to_service() const {
        const fs::path checkout = checkout_folder(options_.format);
        if (options_.format == ReportFormat::gitlab)
            std::fputs(gitlab_report(annotations_, checkout).c_str(), stdout);
        if (options_.format != ReportFormat::github) return;
        std::fputs(github_annotations(annotations_, checkout).c_str(), stdout);
        add_to_github_summary(
            github_summary(annotations_, page_.has_cases() ? page_.file() : fs::path()));
    }

    void print_json() const {
        nlohmann::ordered_json json;
        json["as_recorded"] = count(Outcome::as_recorded);
        json["page"] = page_.has_cases() ? nlohmann::ordered_json(page_.file().string()) : nullptr;
        json["cases"] = nlohmann::ordered_json::array();
        for (const JunitCase& one : cases_) {
            json["cases"].push_back({{"baseline", one.suite},
                                     {"name", one.name},
                                     {"outcome", name_of(one.verdict.outcome)},
                                     {"finding", one.verdict.finding},
                                     {"seconds", one.seconds}});
        }
        std::fputs((json_text(json, 2) + "\n").c_str(), stdout);
    }

    const VerificationOptions& options_;
    std::vector<Suite> suites_;
    OutputClaims claims_;
    VerifyPage page_;
    WorkOptions work_;
    std::vector<JunitCase> cases_;
    std::vector<Annotation> annotations_;
    std::string began_ = fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(std::time(nullptr)));
    int signal_ = 0;
};

}  // namespace

int verify(const VerificationOptions& options) {
    if (!options.junit.empty()) check_ending(options.junit, "a JUnit report", junit_ending);
    try {
        return Verification(options, read_suites(options)).run();
    } catch (const InputError& fault) {
        if (options.format == ReportFormat::github) {
            for (const std::string& line : fault.lines())
                std::fputs(github_fault(line, checkout_folder(options.format)).c_str(), stdout);
        }
        throw;
    }
}

}  // namespace fumon
