#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/error.h"
#include "base/nearest_name.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/man_page.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "outputs/output_claims.h"
#include "run/run_folder.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct ManOptions {
    std::string page;    ///< "run", "scene"; empty: the program's
    std::string folder;  ///< where all pages are written; empty: one to standard output
    bool force = false;
};

/// "run" of "fumon-run.1".
std::string short_name(const ManPage& page) {
    const std::string stem = fs::path(page.file).stem().string();
    constexpr std::string_view prefix = "fumon-";
    return stem.starts_with(prefix) ? stem.substr(prefix.size()) : stem;
}

void write_all(const std::vector<ManPage>& pages, const ManOptions& options) {
    check_output_folder(options.folder, "the manual pages");
    const OutputClaims claims(options.force);
    for (const ManPage& page : pages) {
        const fs::path file = fs::path(options.folder) / page.file;
        std::error_code fault;
        const std::string_view mark = own_man_page_mark;
        claims.check(file, fs::is_regular_file(file, fault) &&
                               start_of_input_file(file, mark.size()) == mark);
    }
    make_folder(options.folder);
    for (const ManPage& page : pages) write_file(fs::path(options.folder) / page.file, page.text);
}

int perform(const CLI::App& app, const ManOptions& options) {
    const std::vector<ManPage> pages = man_pages(app);
    if (!options.folder.empty()) {
        write_all(pages, options);
        return 0;
    }
    std::vector<std::string> names;
    for (const ManPage& page : pages) {
        names.push_back(short_name(page));
        if (names.back() != (options.page.empty() ? "fumon" : options.page)) continue;
        std::fputs(page.text.c_str(), stdout);
        return 0;
    }
    throw InputError(fmt::format("fumon man: there is no page \"{}\"; {}", options.page,
                                 suggestion(options.page, names)));
}

}  // namespace

Command man_command() {
    return {"man", "print a manual page: of fumon, of a command, of scenes",
            [](CLI::App& command) -> std::function<int()> {
                const auto options = std::make_shared<ManOptions>();
                command.add_option("PAGE", options->page,
                                   "a command, or scene (default: fumon itself)");
                command
                    .add_option("-o,--output", options->folder,
                                "write all pages into this folder: fumon.1, fumon-run.1 …")
                    ->type_name("DIR");
                add_force(command, options->force);
                add_examples(command, {{"fumon man run | man -l -", "read a page"},
                                       {"fumon man scene | man -l -", "every key of scenes"},
                                       {"fumon man -o man", "write all pages"}});
                return [&command, options] { return perform(*command.get_parent(), *options); };
            }};
}

}  // namespace fumon
