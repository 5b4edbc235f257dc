#include "verify/case_selection.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/nearest_name.h"

namespace fumon {

namespace {

/// "map", or "dunes/map".
bool is_called(const std::string& name, const Suite& suite, const BaselineCase& one) {
    return name == one.name || name == suite.name + "/" + one.name;
}

template <class Means>
void refuse_unknown(const std::vector<std::string>& words, const std::vector<Suite>& suites,
                    const char* what, const Means& means) {
    std::vector<std::string> known;
    for (const Suite& suite : suites) {
        if (!suite.fault.empty()) return;  // it may be one of its cases
        for (const BaselineCase& one : suite.baseline.cases) known.push_back(one.name);
    }
    for (const std::string& word : words) {
        const bool found = std::ranges::any_of(suites, [&](const Suite& suite) {
            return std::ranges::any_of(suite.baseline.cases, [&](const BaselineCase& one) {
                return means(word, suite, one);
            });
        });
        if (!found)
            throw InputError(fmt::format("{} \"{}\"; {}", what, word, suggestion(word, known)));
    }
}

}  // namespace

bool chooses(std::string_view pattern, const std::string& suite, const std::string& name) {
    const std::string held =
        pattern.find('/') == std::string_view::npos ? name : suite + "/" + name;
    if (pattern.find_first_of("*?[") == std::string_view::npos)
        return held.find(pattern) != std::string::npos;
    return ::fnmatch(std::string(pattern).c_str(), held.c_str(), 0) == 0;
}

std::vector<ChosenCase> chosen_cases(const VerificationOptions& options,
                                     const std::vector<Suite>& suites) {
    const auto by_pattern = [](const std::string& pattern, const Suite& suite,
                               const BaselineCase& one) {
        return chooses(pattern, suite.name, one.name);
    };
    refuse_unknown(options.names, suites, "no case is named", is_called);
    refuse_unknown(options.patterns, suites, "no case has a name like", by_pattern);
    const auto is_meant = [&](const Suite& suite, const BaselineCase& one) {
        const auto named = [&](const std::string& name) { return is_called(name, suite, one); };
        const auto like = [&](const std::string& word) { return by_pattern(word, suite, one); };
        return (options.names.empty() || std::ranges::any_of(options.names, named)) &&
               (options.patterns.empty() || std::ranges::any_of(options.patterns, like));
    };
    std::vector<ChosenCase> meant;
    for (std::size_t s = 0; s < suites.size(); ++s) {
        const std::vector<BaselineCase>& cases = suites[s].baseline.cases;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            if (is_meant(suites[s], cases[i])) meant.push_back({s, i});
        }
    }
    if (!options.shard) return meant;
    std::vector<ChosenCase> own;
    const auto of = static_cast<std::size_t>(options.shard->of);
    for (auto i = static_cast<std::size_t>(options.shard->number - 1); i < meant.size(); i += of)
        own.push_back(meant[i]);
    return own;
}

}  // namespace fumon
