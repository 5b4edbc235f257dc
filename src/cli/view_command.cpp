#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/command.h"
#include "cli/commands.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "files/terrain/terrain_format.h"
#include "film/beds/stored_still.h"
#include "outputs/output_claims.h"
#include "run/drawing.h"
#include "run/inputs/scene_argument.h"
#include "run/prepared_run.h"
#include "run/terminal/interrupt.h"
#include "scene/read.h"
#include "scene/scene_files.h"
#include "scene/terrain_scene.h"
#include "view/scene/dropped_terrain.h"
#include "view/scene/scene_pages.h"
#include "view/server/address_lines.h"
#include "view/server/http_server.h"
#include "view/subject/followed_subject.h"
#include "view/subject/stored_subject.h"
#include "view/sweep/sweep_pages.h"
#include "view/view_page.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

struct ViewArguments {
    std::string input;
    std::string heights;
    std::string save;
    int port = 0;
    ViewOptions options;
};

void declare(CLI::App& command, ViewArguments& arguments) {
    command
        .add_option("INPUT", arguments.input,
                    "a scene (.toml), the folder of a run or sweep, finished or not, or terrain: " +
                        terrain_titles())
        ->required();
    add_number(command, "--port", arguments.port, 0, 65535,
               "to listen on (default: one that is free)")
        ->type_name("N");
    command
        .add_option("--save", arguments.save,
                    "the folder that the page may save to; without it the browser keeps what is "
                    "saved")
        ->type_name("DIR");
    command.add_flag("--trust", arguments.options.trust,
                     "let the page ask for pictures and models of any size");
    add_heights(command, arguments.heights);
    add_force(command, arguments.options.force);
    add_work_options(command, arguments.options.work);
    add_drawing_options(command, arguments.options.work);
    add_examples(command,
                 {{"fumon view terada-barchans", "a scene, computed as far as you look"},
                  {"fumon view out/run", "the stored beds of a run, also while it goes on"},
                  {"fumon view out/creep", "the runs of a sweep, as a grid"},
                  {"fumon view terrain.asc --save pictures", "a terrain file of your own"}},
                 "It prints an address of this machine for your browser, and ends with Ctrl-C. "
                 "Nobody\nwithout that address sees or changes anything. Of a server the line "
                 "with ssh brings\nthe same address to your own machine.");
}

/// Of what has its results; nullptr for a scene and for terrain.
std::unique_ptr<ViewSubject> stored_results(const ViewArguments& arguments) {
    const WorkOptions& work = arguments.options.work;
    if (const std::optional<fs::path> run = run_folder_of(arguments.input)) {
        if (!arguments.heights.empty())
            throw InputError("--heights belongs to a PNG terrain, not to a run");
        if (is_unfinished_run(*run)) return followed_subject(*run, work.threads, work.settings);
        return stored_subject(*run, work.threads, work.settings);
    }
    std::error_code fault;
    if (fs::is_directory(arguments.input, fault)) {
        throw InputError(fmt::format(
            "{}: the folder holds no run (run.json) and no sweep (sweep.json); name the "
            "folder that `fumon run -o` was given, a scene or terrain",
            arguments.input));
    }
    return foreign_subject(arguments.input, work.threads, work.settings);
}

std::unique_ptr<Pages> scene_pages(const ViewArguments& arguments, const ViewOptions& options) {
    const bool scenic = is_scene_argument(arguments.input);
    if (scenic && !arguments.heights.empty())
        throw InputError("--heights belongs to a PNG terrain; in a scene write bed.heights");
    const std::string file =
        scenic ? scene_argument(arguments.input) : terrain_argument(arguments.input);
    const auto read = [file, scenic, heights = arguments.heights,
                       given = options.work.settings](const std::vector<std::string>& further) {
        std::vector<std::string> settings = given;
        settings.insert(settings.end(), further.begin(), further.end());
        return scenic ? read_scene(file, settings) : terrain_scene(file, heights, settings);
    };
    PreparedRun run = prepare_run(read({}), options.work.threads);
    if (!run.initial.note.empty()) remark(run.initial.note + "\n");
    std::vector<fs::path> files = scene_files(run.scene);
    files.emplace_back(file);
    return std::make_unique<ScenePages>(arguments.input, std::move(run), std::move(files), read,
                                        options);
}

std::unique_ptr<Pages> pages_of(const ViewArguments& arguments, const ViewOptions& given) {
    const ExitOnSignal nothing_is_written;
    ViewOptions options = given;
    if (is_sweep_folder(arguments.input)) {
        if (!arguments.heights.empty() || !options.work.settings.empty()) {
            throw InputError(
                fmt::format("{}: --heights and --set belong to a scene, a run or terrain, not to a "
                            "sweep",
                            arguments.input));
        }
        return std::make_unique<SweepPages>(arguments.input, options);
    }
    options.drops = true;
    std::unique_ptr<ViewSubject> subject = stored_results(arguments);
    std::unique_ptr<Pages> pages = subject
                                       ? std::make_unique<SubjectPages>(std::move(subject), options)
                                       : scene_pages(arguments, options);
    return std::make_unique<DroppedTerrain>(std::move(pages), options);
}

int perform(const ViewArguments& arguments) {
    const InterruptGuard guard;
    ViewOptions options = arguments.options;
    if (!arguments.save.empty()) {
        options.save = arguments.save;
        check_output_folder(options.save, "what the page saves");
    }
    prepare_drawing(options.work);
    const std::unique_ptr<Pages> pages = pages_of(arguments, options);
    if (!options.save.empty()) {
        std::error_code fault;
        fs::create_directories(options.save, fault);
        if (fault)
            throw Error(fmt::format("cannot make the folder {}: {}", options.save.string(),
                                    fault.message()));
    }
    const HttpServer server([&](const HttpRequest& request) { return pages->answer(request); },
                            arguments.port);
    std::fputs(address_lines(server).c_str(), stdout);
    std::fflush(stdout);
    // A terminal that is closed ends it too, but under nohup.
    if (std::signal(SIGHUP, request_stop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
    while (interrupting_signal() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    pages->cancel_all();
    return 0;
}

}  // namespace

Command view_command() {
    return make_command<ViewArguments>(
        "view", "look at a scene, run or terrain in a browser, and find camera and light", declare,
        perform);
}

}  // namespace fumon
