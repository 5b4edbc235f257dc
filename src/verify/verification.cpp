#include "verify/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "run/drawing.h"
#include "scene/json.h"
#include "verify/accept.h"
#include "verify/case_list.h"
#include "verify/case_processes.h"
#include "verify/case_work.h"
#include "verify/got_records.h"
#include "verify/junit_file.h"
#include "verify/kept_records.h"
#include "verify/results_folder.h"
#include "verify/verify_page.h"

namespace fumon {

namespace {

/// The status of a program of which this is the only case.
int status_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::as_recorded:
            return all_is_well;
        case Outcome::differs:
        case Outcome::missing:
            return differs_from_expected;
        case Outcome::wrong_input:
            return input_is_wrong;
        case Outcome::failed:
            break;
    }
    return could_not_work;
}

bool any_pinned(const std::vector<Suite>& suites) {
    return std::ranges::any_of(suites, [](const Suite& suite) {
        return std::ranges::any_of(suite.baseline.records, [](const auto& named) {
            return named.second.environment.pinned;
        });
    });
}

class Verification {
  public:
    Verification(const VerificationOptions& options, std::vector<Suite>& suites,
                 std::vector<ChosenCase> chosen, const OutputClaims& claims, JunitFile& junit)
        : options_(options),
          suites_(suites),
          chosen_(std::move(chosen)),
          junit_(junit),
          results_(results_folder(options)),
          page_(results_.folder, claims) {
        for (const ChosenCase& at : chosen_) {
            if (good_record_name(case_at(at).name))
                page_.check(suite_at(at).name, case_at(at).name, claims);
        }
        if (options.update) claim_records(options, suites_, chosen_);
        work_ = options.work;
        work_.pinned = work_.pinned || any_pinned(suites_);
        if (work_.verbosity == Verbosity::normal) work_.verbosity = Verbosity::quiet;
        prepare_drawing(work_);
        if (const std::string why = why_processor_is_not_pinned(work_);
            !why.empty() && !options_.quietly()) {
            fmt::print(stderr, "{}: {}\n",
                       options_.update ? "recorded as not pinned" : "the portable tier compares",
                       why);
        }
    }

    int run() {
        page_.remove_old();
        for (const Suite& suite : suites_) {
            before_.push_back(all_records(suite.baseline));
            if (!suite.fault.empty()) take_fault(suite);
        }
        const auto work = [this](std::size_t number) {
            const ChosenCase& at = chosen_[number];
            return work_on_case(options_, suite_at(at), case_at(at), work_);
        };
        std::unique_ptr<CaseProcesses> processes;
        if (options_.isolate) processes = std::make_unique<CaseProcesses>(chosen_.size(), work);
        for (std::size_t number = 0; number < chosen_.size(); ++number) {
            CaseResult result = processes ? result_from(*processes) : work(number);
            if (result.signal != 0) {
                stop(number, result.signal);
                break;
            }
            take(chosen_[number], std::move(result));
        }
        processes.reset();
        if (options_.update) rewrite_locks();
        return conclude();
    }

  private:
    [[nodiscard]] Suite& suite_at(const ChosenCase& at) const { return suites_[at.suite]; }
    [[nodiscard]] const BaselineCase& case_at(const ChosenCase& at) const {
        return suite_at(at).baseline.cases[at.number];
    }

    static CaseResult result_from(CaseProcesses& processes) {
        try {
            return processes.next();
        } catch (const Error& fault) {
            return undrawn(Outcome::failed, fault.what());
        }
    }

    /// Of a baseline that cannot be read.
    void take_fault(const Suite& suite) {
        const CaseResult result = undrawn(Outcome::wrong_input, suite.fault);
        annotations_.push_back({suite.baseline.file.string() + ":1:1", "baseline", result.verdict});
        take(suite, "baseline", result);
    }

    void take(const ChosenCase& at, CaseResult result) {
        Suite& suite = suite_at(at);
        const BaselineCase& one = case_at(at);
        remove_old(suite, one.name);
        if (options_.update && result.got) {
            try {
                if (!result.kept.empty()) keep_picture(suite.baseline, result.name, result.kept);
                suite.baseline.records[result.name] = *result.got;
            } catch (const Error& fault) {
                result = undrawn(Outcome::failed, fault.what());
            }
        }
        annotations_.push_back({one.place, one.name, result.verdict});
        take(suite, one.name, result);
    }

    /// Takes away what earlier results have of a case.
    void remove_old(const Suite& suite, const std::string& name) {
        if (good_record_name(name)) attempt([&] { page_.remove_old(suite.name, name); });
    }

    /// Tells, and notes for the report and the page.
    void take(const Suite& suite, const std::string& name, const CaseResult& result) {
        const bool good = result.verdict.outcome == Outcome::as_recorded;
        const bool same = good && (result.word == "ok" || result.word == "kept");
        if (!options_.as_json && !(same && options_.quietly())) {
            fmt::print("{:<8} {} {}: {}\n", result.word, suite.name, name, result.detail);
            std::fflush(stdout);
        }
        cases_.push_back({suite.baseline.file.string(), name, result.verdict, result.seconds,
                          result.expected_pixels, result.got_pixels});
        if (!good && !options_.update) show(suite, name, result);
    }

    void show(const Suite& suite, const std::string& name, const CaseResult& result) {
        attempt([&] {
            page_.begin();
            report_temporary_folder();
        });
        const std::string file = suite.baseline.file.string();
        const std::string command =
            result.got ? accept_command(file, name, page_.folder().string()) : "";
        const bool shown =
            attempt([&] { page_.add(suite.name, name, result.verdict, result.pictures, command); });
        if (!shown || !result.got) return;
        attempt(
            [&] { page_.add_record(suite.name, name, got_record_text(file, name, *result.got)); });
    }

    void report_temporary_folder() {
        if (results_.why_temporary.empty()) return;
        fmt::print(stderr, "{}; results are in {}\n", results_.why_temporary,
                   page_.folder().string());
        results_.why_temporary.clear();
    }

    /// Does what may fail for want of disk, without an end to the rest; each reason is told once.
    template <class Writing>
    bool attempt(const Writing& writing) {
        try {
            writing();
            return true;
        } catch (const std::exception& fault) {
            could_not_write_ = true;
            if (reported_.insert(fault.what()).second) fmt::print(stderr, "{}\n", fault.what());
            return false;
        }
    }

    void stop(std::size_t number, int signal) {
        stopped_ = true;
        const std::string why = fmt::format("not compared: stopped by signal {} ({})", signal,
                                            signal == SIGINT ? "interrupt" : "terminate");
        fmt::print(stderr, "stopped by {}: {} of {} cases were not {}\n",
                   signal == SIGINT ? "an interrupt" : "a request to terminate",
                   chosen_.size() - number, chosen_.size(),
                   options_.update ? "recorded" : "compared");
        for (; number < chosen_.size(); ++number) {
            const Suite& suite = suite_at(chosen_[number]);
            const std::string& name = case_at(chosen_[number]).name;
            const CaseResult result = undrawn(Outcome::failed, why);
            annotations_.push_back({case_at(chosen_[number]).place, name, result.verdict});
            cases_.push_back({suite.baseline.file.string(), name, result.verdict});
            remove_old(suite, name);
            if (!options_.update) show(suite, name, result);
        }
    }

    void rewrite_locks() {
        const bool partly = !options_.names.empty() || !options_.patterns.empty() || stopped_;
        for (std::size_t s = 0; s < suites_.size(); ++s) {
            Baseline& baseline = suites_[s].baseline;
            const bool meant =
                std::ranges::any_of(chosen_, [&](const ChosenCase& at) { return at.suite == s; });
            if (!meant) continue;
            const bool moves = baseline.unlocked;
            if (!attempt([&] { write_lock(baseline, before_[s], partly); }) || options_.as_json)
                continue;
            for (const auto& [name, record] : baseline.orphans) {
                if (partly) break;
                fmt::print("{:<8} {} {}: it has no case any more\n", "removed", suites_[s].name,
                           name);
            }
            if (moves) {
                fmt::print("{:<8} {}: what is recorded, into {}\n", "moved", suites_[s].name,
                           baseline.lock().string());
            }
        }
    }

    /// Before the page, which may take all the room that is left.
    void write_report() {
        try {
            junit_.write(cases_);
        } catch (const Error& fault) {
            if (!page_.has_cases() || !page_.shares_disk_with(options_.junit)) throw;
            fmt::print(stderr, "{}; pictures are left out\n", fault.what());
            could_not_write_ = true;
            page_.drop_pictures();
            junit_.write(cases_);
        }
    }

    int conclude() {
        attempt([&] { write_report(); });
        const bool paged = page_.has_cases() && attempt([&] { page_.finish(); });
        const auto good = std::ranges::count_if(cases_, [](const JunitCase& one) {
            return one.verdict.outcome == Outcome::as_recorded;
        });
        const std::string page = paged ? page_.file().string() : "";
        attempt([&] { report_to_service(page); });
        if (options_.as_json) {
            if (options_.format != ReportFormat::gitlab) print_json(good, page);
        } else if (!options_.update && !options_.quietly()) {
            fmt::print("{} of {} as recorded{}{}\n", good, cases_.size(),
                       page.empty() ? "" : "; see ", page);
        }
        int status = stopped_ || could_not_write_ ? could_not_work : all_is_well;
        for (const JunitCase& one : cases_)
            status = std::max(status, status_of(one.verdict.outcome));
        return status;
    }

    void report_to_service(const std::string& page) const {
        const std::filesystem::path checkout = checkout_folder(options_.format);
        if (options_.format == ReportFormat::gitlab)
            std::fputs(gitlab_report(annotations_, checkout).c_str(), stdout);
        if (options_.format != ReportFormat::github) return;
        std::fputs(github_annotations(annotations_, checkout).c_str(), stdout);
        add_to_github_summary(github_summary(annotations_, page));
    }

    void print_json(std::ptrdiff_t good, const std::string& page) const {
        nlohmann::ordered_json json;
        json["as_recorded"] = good;
        json["page"] =
            page.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(page);
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
    std::vector<Suite>& suites_;
    std::vector<ChosenCase> chosen_;
    JunitFile& junit_;
    ResultsFolder results_;
    VerifyPage page_;
    WorkOptions work_;
    std::vector<BaselineRecords> before_;  ///< what the suites' locks hold
    std::vector<JunitCase> cases_;
    std::vector<Annotation> annotations_;  ///< of the same
    std::set<std::string> reported_;       ///< faults
    bool could_not_write_ = false;
    bool stopped_ = false;
};

/// Notes all that is read, so that no report or page replaces it.
OutputClaims claim_inputs(const VerificationOptions& options, const std::vector<Suite>& suites) {
    OutputClaims claims(options.force);
    for (const Suite& suite : suites) {
        const Baseline& baseline = suite.baseline;
        claims.reads(baseline.file);
        claims.reads(baseline.lock());
        for (const auto& [name, record] : baseline.records) claims.reads(baseline.picture_of(name));
        for (const BaselineCase& one : baseline.cases)
            if (one.picture) claims.reads(baseline.picture_of(one));
    }
    note_inputs(options, suites, claims);
    return claims;
}

int verify_suites(const VerificationOptions& options) {
    std::vector<Suite> suites = read_suites(options);
    if (options.list) return list_cases(options, suites);
    OutputClaims claims = claim_inputs(options, suites);
    JunitFile junit(options.junit, claims);
    try {
        if (!options.accepts.empty()) return accept_results(options, suites);
        std::vector<ChosenCase> chosen = chosen_cases(options, suites);
        return Verification(options, suites, std::move(chosen), claims, junit).run();
    } catch (const std::exception& fault) {
        const bool wrong = dynamic_cast<const InputError*>(&fault) != nullptr;
        junit.write_fault(wrong ? Outcome::wrong_input : Outcome::failed, fault.what());
        throw;
    }
}

}  // namespace

int verify(const VerificationOptions& options) {
    try {
        return verify_suites(options);
    } catch (const InputError& fault) {
        if (options.format == ReportFormat::github) {
            for (const std::string& line : fault.lines())
                std::fputs(github_fault(line, checkout_folder(options.format)).c_str(), stdout);
        }
        throw;
    }
}

}  // namespace fumon
