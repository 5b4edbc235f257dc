#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "picture/verdict.h"

namespace fumon {

/// How `fumon verify` says what it found, besides its lines.
enum class ReportFormat {
    lines,
    github,  ///< annotations of GitHub Actions, and a job summary
    gitlab,  ///< GitLab's Code Quality report instead of the lines
};

/// A case that was looked at, and where its baseline says so.
struct Annotation {
    std::string place;  ///< "file:line:column"
    std::string name;
    Verdict verdict;
};

/// The folder from which a format counts its paths: the checkout's, as the CI service's environment
/// names it; empty where it does not.
std::filesystem::path checkout_folder(ReportFormat format);

/// A workflow command `::error file=…,line=…,col=…,title=…::…` for each case that does not pass, a
/// line each. Files under `checkout` are named from there. GitHub's documentation, "Workflow
/// commands": "%", line ends and, in properties, ":" and "," are written as %25, %0D, %0A, %3A,
/// %2C.
std::string github_annotations(std::span<const Annotation> cases,
                               const std::filesystem::path& checkout);

/// The same for one line "file:line:column: what", or without a place, as faults have it.
std::string github_fault(const std::string& line, const std::filesystem::path& checkout);

/// Markdown: how many pictures are as recorded, and a table of those that are not, of at most 1 MiB
/// as GitHub takes it. `page` shows them; empty: there is none.
std::string github_summary(std::span<const Annotation> cases, const std::filesystem::path& page);

/// Adds a text to the file that GITHUB_STEP_SUMMARY names, if there is one. Throws Error where it
/// cannot be written.
void add_to_github_summary(const std::string& text);

/// GitLab's Code Quality report: a JSON array with an object for each case that does not pass, with
/// description, check_name, fingerprint (of file, case and outcome), severity and location.
std::string gitlab_report(std::span<const Annotation> cases, const std::filesystem::path& checkout);

}  // namespace fumon
