#include "picture/junit.h"

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
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
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\" time=\"{:.3f}\"",
                       cases.size(), failures, errors, seconds);
}

std::string case_xml(const JunitCase& one) {
    const std::string finding = markup_text(one.verdict.finding);
    const std::string inside =
        is_failure(one)
            ? fmt::format("<failure message=\"{0}\">{0}</failure>", finding)
            : (is_error(one) ? fmt::format("<error message=\"{0}\">{0}</error>", finding)
                             : fmt::format("<system-out>{}</system-out>", finding));
    return fmt::format(
        "    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n      {}\n    </testcase>\n",
        markup_text(std::filesystem::path(one.suite).stem().string()), markup_text(one.name),
        one.seconds, inside);
}

}  // namespace

std::string junit_xml(const std::vector<JunitCase>& cases) {
    std::string xml = fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{} {}>\n",
                                  own_junit_mark, totals(cases));
    for (std::size_t begin = 0; begin < cases.size();) {
        std::size_t end = begin;
        while (end < cases.size() && cases[end].suite == cases[begin].suite) ++end;
        const auto suite = std::span(cases).subspan(begin, end - begin);
        xml += fmt::format("  <testsuite name=\"{}\" {}>\n", markup_text(suite.front().suite),
                           totals(suite));
        for (const JunitCase& one : suite) xml += case_xml(one);
        xml += "  </testsuite>\n";
        begin = end;
    }
    return xml + "</testsuites>\n";
}

}  // namespace fumon
