#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/folder_lock.h"
#include "outputs/output_claims.h"
#include "paper/figure_files.h"
#include "paper/figure_make.h"
#include "paper/figure_page.h"
#include "press/journal_check.h"
#include "run/inputs/scene_argument.h"
#include "run/run_folder.h"
#include "run/terminal/interrupt.h"

namespace fumon {

namespace {

struct FigureOptions {
    std::vector<std::string> scenes;
    std::string folder;
    std::string runs;  ///< the folder of finished runs; empty: "runs" in the figures' folder
    bool force = false;
    bool check = false;  ///< whether to say what a journal would send back
    WorkOptions work;
};

void declare(CLI::App& command, FigureOptions& options) {
    command.add_option("SCENE", options.scenes, "scene files with [[figure.panel]] sections")
        ->required();
    command.add_option("-o,--output", options.folder, "the folder for the figures")
        ->type_name("DIR");
    command
        .add_option("--runs", options.runs,
                    "where finished runs are kept and looked for (default: DIR/runs)")
        ->type_name("FOLDER");
    command.add_flag("--check", options.check,
                     "say what figure.journal, or nearly any journal, would send back; without -o "
                     "nothing is made");
    add_force(command, options.force);
    add_work_options(command, options.work);
    add_drawing_options(command, options.work);
    add_examples(
        command,
        {{"fumon figure sudo-2002-06 -o out/figures", "a figure that fumon ships"},
         {"fumon figure scenes/figures/*.toml -o out/figures", "many, which share their runs"},
         {"fumon figure my.toml --check --set figure.journal=nature",
          "what the journal would send back"}},
        "DIR/NAME.pdf, .svg and .png are the figure, DIR/NAME.caption.txt says how it was made, "
        "DIR/NAME-a-1.csv is\nthe data of panel (a), curve 1. Runs that are there already are not "
        "made again.\n"
        "Exit status: 0 done, 1 --check found something, 2 wrong input, 3 some runs or figures "
        "failed, 130/143 interrupted "
        "(finished runs are kept).");
}

namespace fs = std::filesystem;

/// For which time another program, putting its figures into the same folder, is waited for.
constexpr std::chrono::seconds lock_timeout{10};

/// A figure and the texts that it was read from.
struct PlannedFigure {
    FigureSources sources;
    FigurePlan plan;
};

/// False when interrupted.
bool plan_all(const FigureOptions& options, const RunStore* store,
              std::vector<PlannedFigure>& figures, FigureRuns& runs) {
    std::map<std::string, std::string> files;  // of names
    for (const std::string& given : options.scenes) {
        const std::string file = scene_argument(given);
        PlannedFigure figure;
        auto plan = plan_figure(file, options.work.settings, figure.sources, runs, store);
        if (!plan) return false;
        figure.plan = std::move(*plan);
        const auto [other, is_new] = files.emplace(figure.plan.name, file);
        if (!is_new) {
            throw InputError(fmt::format("{}: would write the same files as {}; rename one", file,
                                         other->second));
        }
        figures.push_back(std::move(figure));
    }
    return true;
}

/// Says what a journal would send back of a figure; 1 where that is something. `page`: as it was
/// made; nullptr where it was not.
int report_findings(const FigurePlan& plan, const Page* page) {
    const std::vector<std::string> findings = journal_findings(plan, page);
    for (const std::string& finding : findings) fmt::print("{}\n", finding);
    fmt::print("{}: {}\n", plan.file, journal_verdict(plan, findings.size()));
    return findings.empty() ? 0 : 1;
}

int make_figure(const PlannedFigure& figure, const FigureRuns& runs, const RunStore& store,
                const FigureOptions& options, const OutputClaims& claims, StatusLine& status) {
    const FigurePlan& plan = figure.plan;
    const FigurePage page =
        figure_page(plan, runs, store, {options.work.backend, options.work.threads});
    std::vector<std::string> notes = plan.notes;
    notes.insert(notes.end(), page.warnings.begin(), page.warnings.end());
    const std::vector<WholeFile> files =
        figure_files(plan, figure.sources, page, options.folder, notes);
    make_folder(options.folder);
    const FolderLock lock(options.folder, lock_timeout);
    claim_figure(plan, options.folder, claims);
    write_files(files);
    for (const std::string& note : notes) status.note(fmt::format("{}: {}", plan.file, note));
    status.note(fmt::format("{}.{}", (fs::path(options.folder) / plan.name).string(),
                            fmt::join(plan.scene.figure.formats, ", .")));
    return options.check ? report_findings(plan, &page.page) : 0;
}

/// Claims the files of all figures; none may replace what any of them is made from.
OutputClaims claim_figures(const FigureOptions& options,
                           const std::vector<PlannedFigure>& figures) {
    OutputClaims claims(options.force);
    for (const PlannedFigure& figure : figures) {
        for (const SourceText& text : figure.sources.all()) claims.reads(text.path);
        for (const InputFile& input : figure.plan.inputs) claims.reads(input.path);
    }
    std::error_code fault;
    if (!fs::exists(options.folder, fault) && !fault) return claims;
    if (fault)
        throw Error(fmt::format("cannot make the folder {}: {}", options.folder, fault.message()));
    const FolderLock lock(options.folder, lock_timeout);
    for (const PlannedFigure& figure : figures) claim_figure(figure.plan, options.folder, claims);
    return claims;
}

/// Of the scenes alone.
int check_scenes(const FigureOptions& options) {
    std::vector<PlannedFigure> figures;
    FigureRuns runs;
    StatusLine status(options.work.verbosity);
    if (!plan_all(options, nullptr, figures, runs)) return report_interrupted(status, {});
    int exit_status = 0;
    for (const PlannedFigure& figure : figures)
        exit_status = std::max(exit_status, report_findings(figure.plan, nullptr));
    return exit_status;
}

int perform(const FigureOptions& options) {
    const InterruptGuard guard;
    if (options.folder.empty()) {
        if (options.check) return check_scenes(options);
        throw InputError("--output is required: name the folder for the figures");
    }
    StatusLine status(options.work.verbosity);
    std::vector<PlannedFigure> figures;
    FigureRuns runs;
    const fs::path kept =
        options.runs.empty() ? fs::path(options.folder) / "runs" : fs::path(options.runs);
    check_output_folder(options.folder, "the figures");
    check_output_folder(kept, "the runs");
    const RunStore store(kept);
    if (!plan_all(options, &store, figures, runs)) return report_interrupted(status, {});
    const OutputClaims claims = claim_figures(options, figures);
    const std::vector<RunRecord> records = make_runs(runs, store, options.work, status);
    if (interrupting_signal() != 0) return report_interrupted(status, records);

    int exit_status = 0;
    for (const PlannedFigure& figure : figures) {
        if (interrupting_signal() != 0) return report_interrupted(status, records);
        try {
            if (const std::string missing = missing_run(figure.plan, runs, records);
                !missing.empty())
                throw Error(missing);
            exit_status =
                std::max(exit_status, make_figure(figure, runs, store, options, claims, status));
        } catch (const Error& failure) {
            status.error(failure.what());
            exit_status = std::max(exit_status, failure.exit_status());
        }
    }
    return exit_status;
}

}  // namespace

Command figure_command() {
    return make_command<FigureOptions>(
        "figure", "make a paper's figures: all their runs, pages, captions and data", declare,
        perform);
}

}  // namespace fumon
