#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fumon {

/// A manual page in roff, and the name of its file: "fumon-run.1".
struct ManPage {
    std::string file;
    std::string text;
};

/// By which such a page is known again: how its first line begins.
inline constexpr const char* own_man_page_mark = ".\\\" Written by fumon ";

/// The pages of the program and of each of its commands, from what --help tells, and that of scenes
/// and films, from what describe tells. The first is the program's.
std::vector<ManPage> man_pages(const CLI::App& app);

}  // namespace fumon
