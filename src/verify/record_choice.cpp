#include "verify/record_choice.h"

#include <fmt/format.h>

#include "base/error.h"

namespace fumon {

namespace {

const BaselineRecord* find(const Baseline& baseline, const std::string& name) {
    const auto found = baseline.records.find(name);
    return found == baseline.records.end() ? nullptr : &found->second;
}

}  // namespace

RecordChoice choose_record(const Baseline& baseline, const BaselineCase& one,
                           const RenderingEnvironment& here) {
    const NamedEnvironment* known = baseline.environment_of(one, here);
    if (known != nullptr) {
        const std::string name = record_name(one.name, known->name);
        if (const BaselineRecord* record = find(baseline, name))
            return {name, record, {"environment " + known->name, true}};
    }
    const std::string where = known != nullptr
                                  ? fmt::format("nothing recorded for environment {}", known->name)
                                  : std::string("in no known environment");
    if (const BaselineRecord* record = find(baseline, one.name))
        return {one.name, record, {one.environments.empty() ? "" : where, false}};
    for (const std::string& environment : one.environments) {
        const std::string name = record_name(one.name, environment);
        if (const BaselineRecord* record = find(baseline, name))
            return {name, record, {fmt::format("{}, by that of {}", where, environment), false}};
    }
    return {one.name, nullptr, {}};
}

std::string record_to_write(const Baseline& baseline, const BaselineCase& one,
                            const RenderingEnvironment& here, bool of_this_environment) {
    const NamedEnvironment* known = baseline.environment_of(one, here);
    if (known == nullptr) {
        if (!of_this_environment) return one.name;
        throw InputError(
            fmt::format("{}: cases.{} names no environment that matches this one ({}{}, drawn by "
                        "{}); describe it "
                        "in an [environment.NAME] and add NAME to `environments`",
                        one.place, one.name, here.renderer,
                        here.mesa_version.empty() ? "" : ", Mesa " + here.mesa_version,
                        drawn_by_software(here) ? "software" : "a GPU"));
    }
    const std::string name = record_name(one.name, known->name);
    return of_this_environment || find(baseline, name) != nullptr ? name : one.name;
}

}  // namespace fumon
