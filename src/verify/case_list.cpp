#include "verify/case_list.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "scene/json.h"
#include "verify/case_selection.h"

namespace fumon {

int list_cases(const VerificationOptions& options, const std::vector<Suite>& suites) {
    int status = all_is_well;
    const auto refuse = [&](const std::string& fault) {
        fmt::print(stderr, "{}\n", fault);
        status = input_is_wrong;
    };
    for (const Suite& suite : suites) {
        if (!suite.fault.empty()) refuse(suite.fault);
    }
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const ChosenCase& at : chosen_cases(options, suites)) {
        const Baseline& baseline = suites[at.suite].baseline;
        const BaselineCase& one = baseline.cases[at.number];
        if (!one.fault.empty()) refuse(one.fault);
        json.push_back({{"baseline", baseline.file.string()},
                        {"name", one.name},
                        {"scene", one.scene},
                        {"recorded", baseline.records.contains(one.name)}});
        if (!options.as_json) fmt::print("{} {}\n", baseline.file.string(), one.name);
    }
    if (options.as_json) std::fputs((json_text(json, 2) + "\n").c_str(), stdout);
    return status;
}

}  // namespace fumon
