#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/data_files.h"
#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "files/input_file.h"
#include "film/beds/results_text.h"
#include "film/beds/stored_beds.h"
#include "gallery/gallery_page.h"
#include "outputs/output_claims.h"
#include "run/still.h"
#include "run/terminal/progress.h"
#include "run/terminal/work_options.h"
#include "scene/overlay_keys.h"
#include "web/page_run.h"
#include "web/run_page.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct GalleryOptions {
    std::vector<std::string> from;
    std::string folder = "gallery";
    std::string title = "Landforms";
    bool shipped = false;
    bool pages = false;
    bool force = false;
};

void declare(CLI::App& command, GalleryOptions& options) {
    command.add_option(
        "FROM", options.from,
        "folders of runs, pictures and films that fumon made and of NetCDF results, or "
        "such files");
    command.add_option("-o,--output", options.folder, "the folder for the gallery")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_option("--title", options.title, "what stands above it")->capture_default_str();
    command.add_flag("--shipped", options.shipped, "the pictures of the scenes that fumon ships");
    command.add_flag("--pages", options.pages,
                     "for each run that stored beds a page that turns and plays it, as "
                     "fumon export makes it");
    add_force(command, options.force);
    add_examples(command,
                 {{"fumon gallery out -o gallery", "of all runs and files below out"},
                  {"fumon gallery out --pages -o gallery", "with runs that one can turn"},
                  {"fumon gallery --shipped -o shipped", "of the scenes that fumon ships"}},
                 "DIR/index.html opens in any browser, without a network; to pass the gallery on, "
                 "copy the folder.");
}

/// The pictures of the shipped scenes, which come with the documentation.
fs::path shipped_pictures() {
    if (const auto folder = find_document("scenes/pictures")) return *folder;
    throw InputError(
        "fumon gallery --shipped: the pictures of the shipped scenes are not installed "
        "(share/doc/fumon/scenes/pictures, of the package fumon-pictures); name the folder with "
        "them");
}

bool is_own_gallery(const fs::path& folder) {
    const fs::path page = folder / "index.html";
    std::error_code fault;
    constexpr std::size_t head = 512;
    return fs::is_regular_file(page, fault) &&
           start_of_input_file(page, head).find(own_gallery_mark) != std::string::npos;
}

struct MadePage {
    fs::path to;
    std::string text;
};

/// The page of an item's run; none, with a remark, where it stored no beds or they cannot be drawn.
std::optional<MadePage> made_page(const GalleryItem& item, const fs::path& to, bool own,
                                  OutputClaims& claims) {
    std::optional<PageRun> run;
    const auto attempt = [&](const auto& make) {
        try {
            make();
            return true;
        } catch (const InputError& fault) {
            remark(fmt::format("{}: no page to turn: {}\n", item.name, fault.what()));
            return false;
        }
    };
    if (!attempt([&] { run = stored_page_run(item.run.string(), 0, {}); }) || !run)
        return std::nullopt;
    claims.reads(run->files);
    claims.check(to, own);
    WorkOptions work;
    if (makes_no_remarks()) work.verbosity = Verbosity::quiet;
    MadePage page{to, {}};
    if (!attempt([&] { page.text = page_file(*run, {}, work); })) return std::nullopt;
    return page;
}

/// A picture of the last record of results.
void draw_results(const fs::path& results, const fs::path& picture) {
    WorkOptions work;
    work.verbosity = Verbosity::quiet;
    work.settings = {"image.width=1280", "image.height=720"};
    const StoredBeds beds = StoredBeds::of_files(results.string(), 0, work.settings);
    const std::size_t last = beds.beds().size() - 1;
    const SharedSnapshot snapshot = beds.snapshot(last);
    Scene scene = beds.scene();
    const std::vector<MeasuredRows> rows = beds.measurements(plotted_columns(scene));
    stand_on_drawn_ground(scene.view, beds.first(), *snapshot);
    Progress progress(work.verbosity, static_cast<std::int64_t>(snapshot->bed.size()));
    draw_still({scene, beds.inputs(), rows[last], results_text(beds)}, beds.first(), *snapshot,
               picture.string(), work, progress);
}

int perform(const GalleryOptions& options) {
    std::vector<fs::path> from{options.from.begin(), options.from.end()};
    if (options.shipped) from.push_back(shipped_pictures());
    if (from.empty())
        throw InputError("fumon gallery: FROM is missing; try `fumon gallery --help`");
    std::vector<std::string> faults;
    std::vector<GalleryItem> items = gallery_items(from, faults);
    for (const std::string& fault : faults) remark(fault + "\n");
    const fs::path folder = options.folder;
    check_output_folder(folder, "the gallery");

    struct Written {
        fs::path to;
        const GalleryFile* file;
    };
    const std::vector<GalleryFile> furniture = gallery_furniture();
    std::vector<Written> all;
    all.reserve(furniture.size());
    for (const GalleryFile& file : furniture) all.push_back({folder / file.name, &file});
    for (const GalleryItem& item : items) {
        for (const auto* files : {&item.files, &item.plots})
            for (const GalleryFile& file : *files)
                all.push_back({folder / "files" / file.name, &file});
    }
    const bool own = is_own_gallery(folder);
    OutputClaims claims(options.force);
    for (const Written& written : all) {
        claims.reads(written.file->source);
        claims.reads(written.file->results);
    }
    for (const Written& written : all) claims.check(written.to, own);
    claims.check(folder / "index.html", own);
    std::vector<MadePage> pages;
    for (GalleryItem& item : items) {
        if (!options.pages || item.run.empty()) continue;
        const std::string name = item.name + ".html";
        if (auto made = made_page(item, folder / "files" / name, own, claims)) {
            item.page = name;
            pages.push_back(*std::move(made));
        }
    }
    const std::string page = gallery_page(options.title, items);

    std::error_code fault;
    fs::create_directories(folder / "files", fault);
    if (fault)
        throw Error(fmt::format("cannot make the folder {}: {}", folder.string(), fault.message()));
    for (const auto& [to, file] : all) {
        if (!file->results.empty()) {
            draw_results(file->results, to);
        } else if (file->source.empty()) {
            write_file(to, file->text);
        } else {
            copy_whole(file->source, to);
        }
    }
    for (const MadePage& made : pages) write_file(made.to, made.text);
    write_file(folder / "index.html", page);
    remark(
        fmt::format("{}: {} pictures and films\n", (folder / "index.html").string(), items.size()));
    return 0;
}

}  // namespace

Command gallery_command() {
    return make_command<GalleryOptions>(
        "gallery", "make a folder for a browser of films, pictures, plots and their parameters",
        declare, perform);
}

}  // namespace fumon
