#include "cli/shared_options.h"

namespace fumon {

void add_thread_options(CLI::App& command, WorkOptions& work) {
    command
        .add_option("--threads", work.threads,
                    "threads to compute with (default: one per processor)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    auto* quiet = command.add_flag_callback(
        "-q,--quiet", [&work] { work.verbosity = Verbosity::quiet; }, "print errors only");
    command
        .add_flag_callback(
            "-v,--verbose", [&work] { work.verbosity = Verbosity::verbose; }, "say more")
        ->excludes(quiet);
}

void add_work_options(CLI::App& command, WorkOptions& work) {
    add_settings(command, work.settings, "override a scene key: --set key.path=VALUE (repeatable)");
    add_thread_options(command, work);
}

void add_drawing_options(CLI::App& command, WorkOptions& work) {
    add_choice<gl::Backend>(command, "--gl", work.backend,
                            {{"auto", gl::Backend::automatic},
                             {"osmesa", gl::Backend::osmesa},
                             {"egl", gl::Backend::egl}},
                            "auto, osmesa or egl",
                            "how to draw: auto, osmesa or egl (auto: OSMesa, else EGL)");
    command.add_flag("--pinned", work.pinned,
                     "draw the same pixels on every x86-64 processor (about a fifth slower)");
}

void add_settings(CLI::App& command, std::vector<std::string>& settings, const char* help) {
    command.add_option("--set", settings, help)->type_name("KEY=VALUE")->allow_extra_args(false);
}

CLI::Option* add_force(CLI::App& command, bool& force, const char* help) {
    return command.add_flag("--force", force, help);
}

void add_heights(CLI::App& command, std::string& heights) {
    command.add_option("--heights", heights, "metres of black and white of a PNG terrain")
        ->type_name("LOW:HIGH");
}

}  // namespace fumon
