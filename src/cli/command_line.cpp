#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <map>

#include "base/error.h"
#include "base/nearest_name.h"
#include "cli/commands.h"
#include "scene/describe.h"

namespace fumon {

namespace {

constexpr const char* opening =
    "fumon simulates how wind and water shape sand, and draws it: a scene file in, a shaded\n"
    "time-lapse out, without a display.\n";

constexpr const char* examples =
    "Try:\n"
    "  fumon run scenes/terada-barchans.toml -o out/barchans     frames, movie, measurements\n"
    "  fumon run SCENE -o DIR --set model.creep_rate=0.2         change one number\n"
    "  fumon sweep SCENE --over model.creep_rate=0.1:0.5:5 --seeds 10 -o DIR   many runs, one "
    "table\n"
    "  fumon figure scenes/figures/sudo-2002-06.toml -o out/figures   a paper's figure\n"
    "  fumon still SCENE --step 500 -o dunes.png                 one picture of a run\n"
    "  fumon still terrain.asc -o terrain.png                    a terrain file of your own\n"
    "  fumon again dunes.png                                     the same picture from itself\n"
    "  fumon describe sand                                       every key of a model\n"
    "\n"
    "`fumon COMMAND --help` tells more of one command.\n";

void add_drawing_options(CLI::App& command, WorkOptions& work) {
    const std::map<std::string, gl::Backend> backends{{"auto", gl::Backend::automatic},
                                                      {"osmesa", gl::Backend::osmesa},
                                                      {"egl", gl::Backend::egl}};
    command
        .add_option("--gl", work.backend,
                    "how to draw: auto, osmesa or egl (auto: OSMesa, else EGL)")
        ->type_name("NAME")
        ->transform(CLI::Transformer(backends).description(""))
        ->check([](const std::string& text) -> std::string {
            return text.size() == 1 ? ""
                                    : fmt::format("it takes auto, osmesa or egl, not \"{}\"", text);
        });
    command.add_flag("--pinned", work.pinned,
                     "draw the same pixels on every x86-64 processor (about a fifth slower)");
}

void add_thread_options(CLI::App& command, WorkOptions& work) {
    command
        .add_option("--threads", work.threads,
                    "threads to compute with (default: one per processor)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    auto* quiet = command.add_flag_callback(
        "-q,--quiet", [&work] { work.verbosity = Verbosity::quiet; }, "say nothing but errors");
    command
        .add_flag_callback(
            "-v,--verbose", [&work] { work.verbosity = Verbosity::verbose; }, "say more")
        ->excludes(quiet);
}

void add_work_options(CLI::App& command, WorkOptions& work) {
    command
        .add_option("--set", work.settings,
                    "override a scene key: --set key.path=VALUE (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    add_thread_options(command, work);
}

/// All commands with the variables that their options fill.
struct CommandLine {
    CLI::App app{opening, "fumon"};
    RunOptions run;
    SweepOptions sweep;
    FigureOptions figure;
    StillOptions still;
    HopLawOptions hop_law;
    AgainOptions again;
    MeasureOptions measure;
    FingerprintOptions fingerprint;
    CompareOptions compare;
    VerifyOptions verify;
    std::vector<std::string> checked;
    std::vector<std::string> check_settings;
    std::string described;
    bool as_json = false;
    std::function<int()> chosen;

    CommandLine() {
        app.footer(examples);
        app.set_version_flag("--version", std::string("fumon " FUMON_VERSION));
        app.set_help_flag("-h,--help", "this help");
        app.require_subcommand(1);
        app.get_formatter()->column_width(34);
        add_run();
        add_sweep();
        add_figure();
        add_still();
        add_hop_law();
        add_again();
        add_measure();
        add_fingerprint();
        add_compare();
        add_verify();
        add_check();
        add_listings();
    }

  private:
    CLI::App& add(const char* name, const char* help, std::function<int()> body) {
        CLI::App* command = app.add_subcommand(name, help);
        command->callback([this, body = std::move(body)] { chosen = body; });
        return *command;
    }

    void add_run() {
        CLI::App& command =
            add("run", "run a scene: frames, movie, measurements and manifest into a folder",
                [this] { return run_command(run); });
        command.add_option("SCENE", run.scene, "a scene file (TOML)");
        auto* folder = command.add_option("-o,--output", run.folder, "the folder for the run")
                           ->type_name("DIR");
        auto* force =
            command.add_flag("--force", run.force, "replace the run that the folder holds");
        command
            .add_option("--resume", run.resume,
                        "go on with the run in this folder from its checkpoint (no SCENE needed)")
            ->type_name("DIR")
            ->excludes(folder)
            ->excludes(force);
        command
            .add_option("--checkpoint-every", run.checkpoint_every,
                        "minutes between checkpoints (default 10; 0: none)")
            ->type_name("MINUTES")
            ->check(CLI::Range(0.0, 1e6).description(""));
        add_work_options(command, run.work);
        add_drawing_options(command, run.work);
        command.footer(
            "Exit status: 0 done, 1 failed, 2 wrong input, 130/143 interrupted (what was made is "
            "kept).");
    }

    void add_sweep() {
        CLI::App& command =
            add("sweep", "run a scene many times, over values and seeds: one table of measurements",
                [this] { return sweep_command(sweep); });
        command.add_option("SCENE", sweep.scene, "a scene file (TOML)")->required();
        command
            .add_option("--over", sweep.over,
                        "vary a key: --over key=v1,v2 or key=low:high:count (repeatable: all "
                        "combinations; default: the scene's sweep.over)")
            ->type_name("KEY=VALUES")
            ->allow_extra_args(false);
        command
            .add_option("--seeds", sweep.seeds,
                        "runs of each combination: how many seeds, from the scene's own on, or "
                        "first:last (default: the scene's sweep.seeds)")
            ->type_name("N");
        command.add_option("-o,--output", sweep.folder, "the folder for the sweep")
            ->type_name("DIR")
            ->required();
        command.add_flag("--force", sweep.force, "replace the sweep that the folder holds");
        add_work_options(command, sweep.work);
        command.footer(
            "  fumon sweep SCENE --over model.creep_rate=0.1:0.5:5 --seeds 10 -o out/creep\n"
            "  fumon sweep SCENE --over bed.file=a.asc,b.asc --over run.steps=100,200 -o out/beds\n"
            "  fumon sweep SCENE --over grid.nx+grid.ny=64,128 -o out/sizes    keys that go "
            "together\n"
            "\n"
            "DIR/sweep.csv has a row a run and measured step, DIR/runs.csv a row a run, DIR/runs "
            "each run's own files.\n"
            "The same command goes on where it was stopped; with more values or seeds it runs only "
            "those.\n"
            "Exit status: 0 done, 1 some runs failed, 2 wrong input, 130/143 interrupted (finished "
            "runs are kept).");
    }

    void add_figure() {
        CLI::App& command =
            add("figure", "make a paper's figures: all their runs, pages, captions and data",
                [this] { return figure_command(figure); });
        command.add_option("SCENE", figure.scenes, "scene files with [[figure.panel]] sections")
            ->required();
        command.add_option("-o,--output", figure.folder, "the folder for the figures")
            ->type_name("DIR")
            ->required();
        command
            .add_option("--runs", figure.runs,
                        "where finished runs are kept and looked for (default: DIR/runs)")
            ->type_name("FOLDER");
        add_work_options(command, figure.work);
        add_drawing_options(command, figure.work);
        command.footer(
            "  fumon figure scenes/figures/*.toml -o out/figures\n"
            "\n"
            "DIR/NAME.pdf, .svg and .png are the figure, DIR/NAME.caption.txt says how it was "
            "made, "
            "DIR/NAME-a-1.csv is\nthe data of panel (a), curve 1. Runs that are there already are "
            "not made again.\n"
            "Exit status: 0 done, 1 some runs or figures failed, 2 wrong input, 130/143 "
            "interrupted "
            "(finished runs are kept).");
    }

    void add_still() {
        CLI::App& command = add("still", "one picture: of a step of a scene, or of a terrain file",
                                [this] { return still_command(still); });
        command
            .add_option("INPUT", still.input,
                        "a scene (.toml), an ESRI ASCII grid, a NetCDF file or a grey PNG")
            ->required();
        command.add_option("-o,--output", still.output, "the picture (PNG)")
            ->type_name("FILE.png")
            ->required();
        auto* step =
            command.add_option("--step", still.step, "of which step (default: the run's last)")
                ->type_name("N")
                ->check(CLI::Range(0.0, 9e18).description(""));
        command.add_option("--time", still.time, "of which time, in the model's unit")
            ->type_name("T")
            ->check(CLI::Range(0.0, 9e18).description(""))
            ->excludes(step);
        command
            .add_option("--heights", still.heights, "metres of black and white of a PNG terrain")
            ->type_name("LOW:HIGH");
        add_work_options(command, still.work);
        add_drawing_options(command, still.work);
        command.footer(
            "A look of your own: --set camera.azimuth=160 --set sun.elevation=15 --set "
            "image.width=3840 …\n"
            "(`fumon describe scene` lists every key).");
    }

    void add_hop_law() {
        CLI::App& command = add("hop-law",
                                "fly grains in computed air, fit how far they hop, and write the "
                                "sand scene that hops so",
                                [this] { return hop_law_command(hop_law); });
        command.add_option("SCENE", hop_law.scene, "a scene of the model airflow")->required();
        command.add_option("-o,--output", hop_law.output, "the sand scene to write")
            ->type_name("LAW.toml")
            ->required();
        command
            .add_option("--form", hop_law.form,
                        "of the law: exponential (default), linear, table or slope")
            ->type_name("NAME")
            ->check(CLI::IsMember({"exponential", "linear", "table", "slope"}).description(""));
        command
            .add_option("--hops", hop_law.hops, "hops in succession that count as one (default 1)")
            ->type_name("N")
            ->check(CLI::Range(1, 10000).description(""));
        command
            .add_option("--into", hop_law.into,
                        "a sand scene of your own that gets the law (default: the ripples of "
                        "Terada 2025, section 5)")
            ->type_name("SAND.toml");
        command.add_option("--flights", hop_law.flights, "write every flight into a table")
            ->type_name("FILE.csv");
        add_work_options(command, hop_law.work);
        command.footer(
            "  fumon hop-law scenes/terada-hop-law.toml -o out/law.toml\n"
            "  fumon run out/law.toml -o out/ripples\n"
            "\n"
            "The air runs to the scene's last step; then a grain leaves every column at each of "
            "model.launch_angles.");
    }

    void add_again() {
        CLI::App& command =
            add("again", "make a picture, movie or figure again from what it says of itself",
                [this] { return again_command(again); });
        command.add_option("PICTURE", again.picture, "a PNG, MP4, PDF or SVG that fumon made")
            ->required();
        command
            .add_option("-o,--output", again.output,
                        "what is made (default: NAME-again.png, .mp4, .pdf or .svg here)")
            ->type_name("FILE");
        command
            .add_option("--runs", again.runs,
                        "of a figure: where finished runs are kept (default: runs beside it)")
            ->type_name("FOLDER");
        add_work_options(command, again.work);
        add_drawing_options(command, again.work);
    }

    void add_measure() {
        CLI::App& command =
            add("measure", "measure a bed: wavelength, crests, dunes, slopes, a pile's cone, water",
                [this] { return measure_command(measure); });
        command
            .add_option(
                "BED", measure.bed,
                "an ESRI ASCII grid, a NetCDF file (a run's fields.nc: its last record, water "
                "too), a grey PNG; or a run's avalanches.csv")
            ->required();
        command.add_flag("--json", measure.as_json, "as JSON");
        command
            .add_option("--as", measure.as,
                        "bed, profile or pile (default: a profile is one row; what a fields.nc "
                        "holds besides tells water and piles)")
            ->type_name("KIND")
            ->check(CLI::IsMember({"bed", "profile", "pile"}).description(""));
        command.add_flag("--open", measure.open_edges,
                         "the bed ends at its edges (default: it goes on periodically, as the sand "
                         "models' do)");
        command.add_option("--drop", measure.drop, "the cell on which a pile's grains fell")
            ->type_name("X Y")
            ->expected(2)
            ->check(CLI::NonNegativeNumber.description(""));
        auto* earlier = command
                            .add_option("--earlier", measure.earlier,
                                        "a bed of the same run before this one: for celerity")
                            ->type_name("BED");
        command.add_option("--steps", measure.steps_between, "steps between the two beds")
            ->type_name("N")
            ->check(CLI::Range(1.0, 9e18).description(""))
            ->needs(earlier);
        command
            .add_option("--window", measure.window,
                        "sizes over which avalanches.csv is fitted (default 10:100)")
            ->type_name("LOW:HIGH");
        command
            .add_option("--heights", measure.heights, "metres of black and white of a PNG terrain")
            ->type_name("LOW:HIGH");
        command
            .add_option("--set", measure.settings,
                        "override a scene key, as grid.cell_size or bed.nodata (repeatable)")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        command.footer(
            "Lengths are in metres where the file has them, else in sites; \"undefined\" is what "
            "has no "
            "meaning\nfor this bed. `fumon run` writes the same measures over time into "
            "measurements.csv.");
    }

    void add_fingerprint() {
        CLI::App& command =
            add("fingerprint", "what pictures are known by: pixel hash, thumbnail as text, dHash",
                [this] { return fingerprint_command(fingerprint); });
        command.add_option("IMAGE", fingerprint.images, "PNG files")->required();
        command.add_flag("--json", fingerprint.as_json, "as JSON");
        command.footer(
            "size     width and height, pixels\n"
            "pixels   SHA-256 of the pixels (8 bits a channel, without alpha), as run.json has it\n"
            "dhash    64-bit difference hash: a label, blind to light and shading\n"
            "red, green, blue   32 x 18 mean levels of boxes of the picture, to a tenth");
    }

    void add_compare() {
        const std::map<std::string, Likeness> levels{{"identical", Likeness::identical},
                                                     {"same", Likeness::same_to_the_eye},
                                                     {"close", Likeness::close}};
        CLI::App& command = add("compare", "how far two pictures are apart, and a verdict",
                                [this] { return compare_command(compare); });
        command.add_option("A", compare.first, "a PNG file")->required();
        command.add_option("B", compare.second, "another")->required();
        command.add_option("--diff", compare.difference, "draw where they differ")
            ->type_name("FILE.png");
        command
            .add_option("--level", compare.level,
                        "the least alike that passes: identical, same (default) or close")
            ->type_name("NAME")
            ->transform(CLI::Transformer(levels).description(""))
            ->check([](const std::string& text) -> std::string {
                return text.size() == 1
                           ? ""
                           : fmt::format("it takes identical, same or close, not \"{}\"", text);
            });
        command.footer(
            likeness_help() +
            "\nExit status: 0 at least --level, 1 less (other sizes too), 2 wrong input.");
    }

    void add_verify() {
        CLI::App& command =
            add("verify", "are pictures still what their baselines say? with a page of what is not",
                [this] { return verify_command(verify); });
        command.add_option("BASELINE", verify.baselines, "baseline files (TOML)")->required();
        command
            .add_option("-o,--output", verify.folder,
                        "folder for pictures and index.html of what does not pass (default "
                        "verify-out; not made when all does)")
            ->type_name("DIR");
        command.add_option("--junit", verify.junit, "write JUnit XML")->type_name("FILE.xml");
        command.add_flag("--update", verify.update,
                         "record what is drawn now, and say what changed");
        add_thread_options(command, verify.work);
        add_drawing_options(command, verify.work);
        command.footer(
            "  [cases]                                  # baseline.toml: a line a picture\n"
            "  map = {scene = \"dunes.toml\", step = 500, settings = "
            "[\"camera.projection=map\"]}\n"
            "\n"
            "  fumon verify --update --pinned baseline.toml   records; commit the file\n"
            "  fumon verify baseline.toml                     compares, pinned as it was recorded\n"
            "\n"
            "The state's hash must be the recorded one. Where what draws is pinned and the same, "
            "so must the\npixels (strict); elsewhere (portable) the thumbnail must be within "
            "thumbnail_difference (0.5 grey\nlevels) and, with picture = true, every 8 x 8 "
            "tile's SSIM at least tile_ssim (0.95).\n"
            "Exit status: 0 all as recorded, 1 something is not, 2 wrong input.");
    }

    void add_check() {
        CLI::App& command = add("check", "say whether scenes are right, and where not",
                                [this] { return check_command(checked, check_settings); });
        command.add_option("SCENE", checked, "scene files")->required();
        command.add_option("--set", check_settings, "override a scene key")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
    }

    void add_listings() {
        add("models", "list the models", [] {
            std::fputs(models_text().c_str(), stdout);
            return 0;
        });
        CLI::App& command =
            add("describe", "list scene keys with type, unit, default and range", [this] {
                std::fputs((as_json ? describe_json(described) : describe_text(described)).c_str(),
                           stdout);
                return 0;
            });
        command.add_option("WHAT", described,
                           "\"scene\" (the keys of every scene) or a model; nothing: all");
        command.add_flag("--json", as_json, "as JSON");
    }
};

[[noreturn]] void refuse_usage(const CommandLine& line, const std::vector<std::string>& arguments,
                               const std::string& what) {
    std::vector<std::string> commands;
    for (const CLI::App* command : line.app.get_subcommands({}))
        commands.push_back(command->get_name());
    if (arguments.empty()) throw InputError("fumon: a command is missing; try `fumon --help`");
    const std::string& first = arguments.front();
    if (!first.starts_with("-") &&
        std::find(commands.begin(), commands.end(), first) == commands.end()) {
        throw InputError(
            fmt::format("fumon: unknown command \"{}\"; {}", first, suggestion(first, commands)));
    }
    const std::string of = first.starts_with("-") ? "" : " " + first;
    throw InputError(fmt::format("fumon{}: {}; try `fumon{} --help`", of, what, of));
}

void check_standard_output() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
    throw Error(
        fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
}

}  // namespace

int run_command_line(const std::vector<std::string>& arguments) {
    CommandLine line;
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    int status = 0;
    try {
        line.app.parse(std::move(reversed));
        status = line.chosen();
    } catch (const CLI::Success& help) {
        line.app.exit(help);
    } catch (const CLI::ParseError& fault) {
        refuse_usage(line, arguments, fault.what());
    }
    check_standard_output();
    return status;
}

}  // namespace fumon
