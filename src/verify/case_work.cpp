#include "verify/case_work.h"

#include <new>
#include <string>
#include <utility>

#include "base/cancellation.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "files/hash.h"
#include "run/terminal/interrupt.h"
#include "verify/record_choice.h"

namespace fumon {

namespace {

class CaseWork {
  public:
    CaseWork(const VerificationOptions& options, const Suite& suite, const BaselineCase& one,
             const WorkOptions& work)
        : options_(options), baseline_(suite.baseline), one_(one), work_(work) {}

    CaseResult result() const {
        const RecordChoice common = choose_record(baseline_, one_, {});
        std::string version = version_of(baseline_, one_, defaults_of(options_), common.name);
        DrawnCase drawn = draw(version);
        if (drawn.signal != 0) return stopped(drawn.signal);
        const RecordChoice choice = choose_record(baseline_, one_, drawn.record.environment);
        // What draws is known only now; its record may be another fumon's, with other defaults.
        if (const std::string now = version_of(baseline_, one_, defaults_of(options_), choice.name);
            now != version) {
            drawn = draw(now);
            if (drawn.signal != 0) return stopped(drawn.signal);
        }
        return options_.update ? renewed(drawn) : compared(drawn, choice);
    }

  private:
    [[nodiscard]] DrawnCase draw(const std::string& version) const {
        return draw_case(baseline_, one_, options_.trust, version, work_);
    }

    static CaseResult stopped(int signal) {
        CaseResult result = undrawn(Outcome::failed, "stopped");
        result.signal = signal;
        return result;
    }

    [[nodiscard]] CaseResult compared(const DrawnCase& drawn, const RecordChoice& choice) const {
        CaseResult result;
        result.got_pixels = hex(drawn.record.fingerprint.pixels);
        std::optional<Image> kept;
        try {
            if (choice.record != nullptr) {
                result.expected_pixels = hex(choice.record->fingerprint.pixels);
                kept =
                    recorded_picture(baseline_, one_, choice.name, *choice.record, drawn.ignored);
            }
            const Image* expected = kept ? &*kept : nullptr;
            result.verdict = judge(one_, choice.record, drawn.record, drawn.image, expected,
                                   choice.use, drawn.ignored);
            if (result.verdict.outcome != Outcome::as_recorded)
                result.pictures =
                    page_pictures(drawn.image, choice.record, expected, drawn.ignored);
        } catch (const InputError& fault) {
            result.verdict = {Outcome::wrong_input, fault.what()};
            result.pictures = page_pictures(drawn.image, nullptr, nullptr);
        }
        result.word = word_of(result.verdict.outcome);
        result.detail = result.verdict.finding;
        result.name =
            record_to_write(baseline_, one_, drawn.record.environment, options_.this_environment);
        result.got = drawn.record;
        return result;
    }

    [[nodiscard]] CaseResult renewed(const DrawnCase& drawn) const {
        CaseResult result;
        result.name =
            record_to_write(baseline_, one_, drawn.record.environment, options_.this_environment);
        const auto found = baseline_.records.find(result.name);
        const bool fresh = found == baseline_.records.end();
        const std::string changed = fresh ? "" : changes(found->second, drawn.record);
        if (!fresh) result.expected_pixels = hex(found->second.fingerprint.pixels);
        result.got_pixels = hex(drawn.record.fingerprint.pixels);
        result.got = drawn.record;
        if (one_.picture) result.kept = as_png(drawn.image);
        result.verdict = {Outcome::as_recorded, fresh ? "recorded" : changed};
        const std::string of = result.name == one_.name ? "" : result.name + ": ";
        result.word = fresh ? "new" : changed.empty() ? "kept" : "changed";
        result.detail = of + (fresh             ? "recorded; look at it before you keep it"
                              : changed.empty() ? "as recorded"
                                                : changed);
        return result;
    }

    const VerificationOptions& options_;
    const Baseline& baseline_;
    const BaselineCase& one_;
    const WorkOptions& work_;
};

/// What the record of a case says was expected, for a result without a picture.
std::string expected_pixels_of(const Baseline& baseline, const BaselineCase& one) {
    const RecordChoice common = choose_record(baseline, one, {});
    return common.record == nullptr ? "" : hex(common.record->fingerprint.pixels);
}

CaseResult result_of_work(const VerificationOptions& options, const Suite& suite,
                          const BaselineCase& one, const WorkOptions& work) {
    if (!one.fault.empty()) return undrawn(Outcome::wrong_input, one.fault);
    try {
        return CaseWork(options, suite, one, work).result();
    } catch (const InputError& fault) {
        return undrawn(Outcome::wrong_input, fault.what());
    } catch (const Error& fault) {
        return undrawn(Outcome::failed, fault.what());
    } catch (const Cancelled&) {
        CaseResult result = undrawn(Outcome::failed, "stopped");
        result.signal = interrupting_signal();
        return result;
    } catch (const std::bad_alloc&) {
        CaseResult result =
            undrawn(Outcome::failed, "out of memory; a smaller grid or picture needs less");
        result.needs_new_process = true;
        return result;
    } catch (const std::exception& fault) {
        return undrawn(Outcome::failed, std::string("unexpected: ") + fault.what());
    }
}

}  // namespace

CaseDefaults defaults_of(const VerificationOptions& options) {
    return options.update ? CaseDefaults::of_today : CaseDefaults::as_recorded;
}

CaseResult work_on_case(const VerificationOptions& options, const Suite& suite,
                        const BaselineCase& one, const WorkOptions& work) {
    const Stopwatch watch;
    CaseResult result = result_of_work(options, suite, one, work);
    if (result.expected_pixels.empty() && one.fault.empty())
        result.expected_pixels = expected_pixels_of(suite.baseline, one);
    result.seconds = watch.seconds();
    return result;
}

}  // namespace fumon
