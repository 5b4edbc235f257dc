#include "verify/annotations.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.h"
#include "files/hash.h"
#include "scene/json.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// A place taken apart; line and column are 0 where there are none.
struct Located {
    std::string file;
    int line = 0;
    int column = 0;
};

/// The number after the last colon, which is cut off with it; 0 where there is none.
int cut_number(std::string_view& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) return 0;
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [at, fault] = std::from_chars(text.data() + colon + 1, end, number);
    if (fault != std::errc() || at != end || number < 1) return 0;
    text = text.substr(0, colon);
    return number;
}

std::string from_checkout(const fs::path& file, const fs::path& checkout) {
    if (checkout.empty()) return file.lexically_normal().generic_string();
    std::error_code fault;
    const fs::path whole = fs::weakly_canonical(file, fault);
    const fs::path root = fs::weakly_canonical(checkout, fault);
    const fs::path inside = whole.lexically_relative(root);
    if (fault || inside.empty() || *inside.begin() == "..")
        return file.lexically_normal().generic_string();
    return inside.generic_string();
}

Located located(std::string_view place, const fs::path& checkout) {
    Located found;
    found.column = cut_number(place);
    found.line = cut_number(place);
    found.file = from_checkout(std::string(place), checkout);
    return found;
}

/// Where the fault of a case lies: what the finding of wrong input begins with, else the case.
std::string_view place_of(const Annotation& one) {
    if (one.verdict.outcome != Outcome::wrong_input) return one.place;
    const std::string_view finding = one.verdict.finding;
    const std::string_view head = finding.substr(0, finding.find(": "));
    std::string_view left = head;
    const int column = cut_number(left);
    const int line = cut_number(left);
    return line > 0 && column > 0 ? head : std::string_view(one.place);
}

std::string with(std::string_view text, std::string_view letters, const char* const* instead) {
    std::string written;
    for (const char letter : text) {
        const std::size_t at = letters.find(letter);
        if (at == std::string_view::npos) {
            written += letter;
        } else {
            written += instead[at];
        }
    }
    return written;
}

/// As the value of a workflow command.
std::string command_value(std::string_view text) {
    static constexpr const char* instead[] = {"%25", "%0D", "%0A"};
    return with(text, "%\r\n", instead);
}

std::string command_property(std::string_view text) {
    static constexpr const char* instead[] = {"%25", "%0D", "%0A", "%3A", "%2C"};
    return with(text, "%\r\n:,", instead);
}

std::string command(const Located& place, const std::string& title, const std::string& text) {
    std::string properties = fmt::format("file={}", command_property(place.file));
    if (place.line > 0) properties += fmt::format(",line={}", place.line);
    if (place.column > 0) properties += fmt::format(",col={}", place.column);
    return fmt::format("::error {},title={}::{}\n", properties, command_property(title),
                       command_value(text));
}

/// In a cell of a table.
std::string markdown(std::string_view text) {
    static constexpr const char* instead[] = {"\\\\", "\\|",  "\\`",  "\\*",   "\\_", "\\[",
                                              "\\]",  "&lt;", "&gt;", "&amp;", " ",   " "};
    return with(text, "\\|`*_[]<>&\r\n", instead);
}

bool passes(const Annotation& one) {
    return one.verdict.outcome == Outcome::as_recorded;
}

const char* severity(Outcome outcome) {
    if (outcome == Outcome::differs) return "major";
    return outcome == Outcome::missing ? "minor" : "critical";
}

}  // namespace

fs::path checkout_folder(ReportFormat format) {
    const char* folder =
        std::getenv(format == ReportFormat::gitlab ? "CI_PROJECT_DIR" : "GITHUB_WORKSPACE");
    return folder == nullptr ? "" : folder;
}

std::string github_annotations(std::span<const Annotation> cases, const fs::path& checkout) {
    std::string text;
    for (const Annotation& one : cases) {
        if (passes(one)) continue;
        text += command(located(place_of(one), checkout),
                        fmt::format("{}: {}", one.name, name_of(one.verdict.outcome)),
                        one.verdict.finding);
    }
    return text;
}

std::string github_fault(const std::string& line, const fs::path& checkout) {
    // "file:line:column: what", whose file may hold colons, too.
    for (std::size_t end = line.find(": "); end != std::string::npos;
         end = line.find(": ", end + 1)) {
        const Located place = located(std::string_view(line).substr(0, end), checkout);
        if (place.line == 0 || place.column == 0) continue;
        return command(place, "fumon verify", line.substr(end + 2));
    }
    return fmt::format("::error title=fumon verify::{}\n", command_value(line));
}

std::string github_summary(std::span<const Annotation> cases, const fs::path& page) {
    constexpr std::size_t most = 1'000'000;  // bytes; GitHub takes 1 MiB of a step
    const auto good = std::count_if(cases.begin(), cases.end(), passes);
    std::string text = fmt::format("## fumon verify: {} of {} as recorded\n\n", good, cases.size());
    if (static_cast<std::size_t>(good) == cases.size()) return text;
    text += "| picture | baseline | outcome | what was found |\n|---|---|---|---|\n";
    std::size_t left_out = 0;
    for (const Annotation& one : cases) {
        if (passes(one)) continue;
        const std::string row =
            fmt::format("| {} | {} | **{}** | {} |\n", markdown(one.name), markdown(one.place),
                        name_of(one.verdict.outcome), markdown(one.verdict.finding));
        if (text.size() + row.size() > most) {
            ++left_out;
        } else {
            text += row;
        }
    }
    if (left_out > 0) text += fmt::format("\n… and {} more\n", left_out);
    if (!page.empty())
        text +=
            fmt::format("\nExpected, got and difference of each: {}\n", markdown(page.string()));
    return text;
}

void add_to_github_summary(const std::string& text) {
    const char* file = std::getenv("GITHUB_STEP_SUMMARY");
    if (file == nullptr || *file == '\0') return;
    std::ofstream summary(file, std::ios::binary | std::ios::app);
    summary << text << std::flush;
    if (!summary) throw Error(fmt::format("{}: the job summary cannot be written", file));
}

std::string gitlab_report(std::span<const Annotation> cases, const fs::path& checkout) {
    nlohmann::ordered_json report = nlohmann::ordered_json::array();
    for (const Annotation& one : cases) {
        if (passes(one)) continue;
        const Located place = located(place_of(one), checkout);
        const std::string outcome = name_of(one.verdict.outcome);
        nlohmann::ordered_json issue;
        issue["description"] = fmt::format("{}: {}", one.name, one.verdict.finding);
        issue["check_name"] = "fumon-verify/" + outcome;
        issue["fingerprint"] =
            hex(text_hash(fmt::format("{}\n{}\n{}", place.file, one.name, outcome)));
        issue["severity"] = severity(one.verdict.outcome);
        issue["location"] = {{"path", place.file}, {"lines", {{"begin", std::max(place.line, 1)}}}};
        report.push_back(std::move(issue));
    }
    return json_text(report, 2) + "\n";
}

}  // namespace fumon
