#include "picture/junit.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <span>

#include "picture/markup.h"

namespace fumon {

namespace {

bool is_failure(const JunitCase& one) {
    return one.verdict.outcome == Outcome::differs || one.verdict.outcome == Outcome::missing;
}

bool is_error(const JunitCase& one) {
    return one.verdict.outcome == Outcome::failed || one.verdict.outcome == Outcome::wrong_input;
}

/// The attributes that a suite and all suites together have.
std::string totals(std::span<const JunitCase> cases) {
    std::size_t failures = 0;
    std::size_t errors = 0;
    double seconds = 0.0;
    for (const JunitCase& one : cases) {
        failures += is_failure(one) ? 1U : 0U;
        errors += is_error(one) ? 1U : 0U;
        seconds += one.seconds;
    }
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", cases.size(),
                       failures, errors, seconds);
}

/// "sub/pictures.toml" as "sub.pictures".
std::string class_name(const std::string& suite) {
    std::string name;
    const std::filesystem::path path(suite);
    for (const auto& part : path.parent_path().lexically_normal().relative_path()) {
        if (part == "." || part == ".." || part.empty()) continue;
        name += part.string() + ".";
    }
    return name + path.stem().string();
}

/// The class names of suites, each its own.
std::map<std::string, std::string> class_names(const std::vector<JunitCase>& cases) {
    std::map<std::string, std::string> names;
    std::set<std::string> taken;
    for (const JunitCase& one : cases) {
        if (names.contains(one.suite)) continue;
        const std::string wanted = class_name(one.suite);
        std::string name = wanted;
        for (int number = 2; !taken.insert(name).second; ++number)
            name = fmt::format("{}-{}", wanted, number);
        names.emplace(one.suite, name);
    }
    return names;
}

std::string case_xml(const JunitCase& one, const std::string& class_name) {
    const std::string finding = markup_text(one.verdict.finding);
    std::string inside = fmt::format("<system-out>{}</system-out>", finding);
    if (is_failure(one) || is_error(one))
        inside = fmt::format("<{0} type=\"{1}\" message=\"{2}\">{2}</{0}>",
                             is_failure(one) ? "failure" : "error", name_of(one.verdict.outcome),
                             finding);
    return fmt::format(
        "    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n      {}\n    </testcase>\n",
        markup_text(class_name), markup_text(one.name), one.seconds, inside);
}

std::string properties_xml(std::span<const JunitCase> suite) {
    std::string xml;
    const auto add = [&](const JunitCase& one, const char* which, const std::string& hash) {
        if (hash.empty()) return;
        xml += fmt::format("      <property name=\"{}.{}-pixels-sha256\" value=\"{}\"/>\n",
                           markup_text(one.name), which, markup_text(hash));
    };
    for (const JunitCase& one : suite) {
        add(one, "expected", one.expected_pixels);
        add(one, "got", one.got_pixels);
    }
    return xml.empty() ? "" : "    <properties>\n" + xml + "    </properties>\n";
}

}  // namespace

std::string junit_xml(const std::vector<JunitCase>& cases, const std::string& timestamp) {
    std::string xml = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{} {}>\n",
                                  own_junit_mark, totals(cases));
    const auto names = class_names(cases);
    for (std::size_t begin = 0; begin < cases.size();) {
        std::size_t end = begin;
        while (end < cases.size() && cases[end].suite == cases[begin].suite) ++end;
        const auto suite = std::span(cases).subspan(begin, end - begin);
        const std::string& file = suite.front().suite;
        xml += fmt::format("  <testsuite name=\"{}\" {} skipped=\"0\" timestamp=\"{}\">\n",
                           markup_text(file), totals(suite), markup_text(timestamp));
        xml += properties_xml(suite);
        for (const JunitCase& one : suite) xml += case_xml(one, names.at(file));
        xml += "  </testsuite>\n";
        begin = end;
    }
    return xml + "</testsuites>\n";
}

}  // namespace fumon
