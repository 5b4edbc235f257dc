#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/shared_options.h"
#include "files/atomic_file.h"
#include "hop_law/flight_table.h"
#include "hop_law/hop_law_scene.h"
#include "hop_law/law_scene.h"
#include "models/air/airflow.h"
#include "outputs/output_claims.h"
#include "run/inputs/scene_argument.h"
#include "run/prepared_run.h"
#include "run/still.h"
#include "run/terminal/interrupt.h"
#include "scene/read.h"
#include "scene/scene_files.h"

namespace fumon {

namespace {

struct HopLawOptions {
    std::string scene;   ///< of the model airflow
    std::string output;  ///< the sand scene to write
    std::string form = "exponential";
    std::int64_t hops = 1;  ///< in succession
    std::string into;       ///< the sand scene that gets the law; empty: Terada's ripples
    std::string flights;    ///< a CSV file of all flights; empty: none
    bool force = false;
    WorkOptions work;
};

void declare(CLI::App& command, HopLawOptions& options) {
    command.add_option("SCENE", options.scene, "a scene of the model airflow")->required();
    command.add_option("-o,--output", options.output, "the sand scene to write")
        ->type_name("LAW.toml")
        ->required();
    add_word(command, "--form", options.form, {"exponential", "linear", "table", "slope"},
             "of the law: exponential (default), linear, table or slope")
        ->type_name("NAME");
    constexpr double most_hops = 10000;
    add_number(command, "--hops", options.hops, 1, most_hops,
               "hops in succession that count as one (default 1)")
        ->type_name("N");
    command
        .add_option("--into", options.into,
                    "a sand scene of your own that gets the law (default: the ripples of "
                    "Terada 2025, section 5)")
        ->type_name("SAND.toml");
    command.add_option("--flights", options.flights, "write every flight into a table")
        ->type_name("FILE.csv");
    add_force(command, options.force);
    add_work_options(command, options.work);
    add_examples(
        command,
        {{"fumon hop-law terada-hop-law -o out/law.toml", ""},
         {"fumon run out/law.toml -o out/ripples", "the ripples of that law"}},
        "The air runs to the scene's last step; then a grain leaves every column at each of "
        "model.launch_angles.");
}

HopForm form_of(const std::string& name) {
    constexpr std::array<std::pair<std::string_view, HopForm>, 4> forms{
        {{"exponential", HopForm::exponential},
         {"linear", HopForm::linear},
         {"table", HopForm::table},
         {"slope", HopForm::slope}}};
    for (const auto& [known, form] : forms) {
        if (name == known) return form;
    }
    throw InputError(fmt::format("--form {}: it takes exponential, linear, table or slope", name));
}

/// Claims the outputs; a table of flights is fumon's where the law that stands there names it.
void claim_outputs(const HopLawOptions& options, const SandSource& sand, const Scene& air) {
    OutputClaims claims(options.force);
    for (const std::string& scene : {options.scene, options.into}) claims.reads(scene);
    claims.reads(scene_files(air));
    claims.reads(scene_files(sand.scene));
    claims.writes(options.output);
    if (!options.flights.empty())
        claims.writes(options.flights, names_flights(options.output, options.flights));
}

int perform(const HopLawOptions& options) {
    const InterruptGuard guard;
    check_ending(options.output, "a scene", scene_ending);
    if (!options.flights.empty()) check_ending(options.flights, "a table", table_ending);
    const SandSource sand = sand_source(options.into);
    PreparedRun prepared = prepare_run(
        read_scene(scene_argument(options.scene), options.work.settings), options.work.threads);
    const Airflow& air = airflow_of(prepared);
    claim_outputs(options, sand, prepared.scene);

    Progress progress(options.work.verbosity,
                      static_cast<std::int64_t>(prepared.initial.bed.size()));
    if (!prepared.initial.note.empty()) progress.note(prepared.initial.note);
    const int signal = advance_to(prepared, prepared.scene.run.steps, progress);
    if (signal != 0) return exit_status_of_signal(signal);

    const std::vector<Flight> flights = air.fly_grains(static_cast<int>(options.hops));
    const MeasuredHops hops = measure_hops(flights, air.parameters().flight.launch_angles);
    const HopForm form = form_of(options.form);
    AtomicFile law_file(options.output);
    law_file.write(
        law_scene(prepared, air, hops, sand,
                  {options.output, form, options.hops, options.work.settings, options.flights}));
    if (!options.flights.empty()) write_file(options.flights, flight_table(flights));
    law_file.commit();
    progress.note(air_line(prepared, air));
    for (const std::string& line : fit_lines(hops)) progress.note(line);
    if (const std::string warning = reynolds_warning(air, hops); !warning.empty())
        progress.note(warning);
    progress.note(law_line(hops, form));
    progress.note(scale_line(hops));
    progress.note(
        fmt::format("{}: run it with fumon run {} -o DIR", options.output, options.output));
    return 0;
}

}  // namespace

Command hop_law_command() {
    return make_command<HopLawOptions>(
        "hop-law",
        "fly grains in computed air, fit how far they hop, and write a sand scene with that law",
        declare, perform);
}

}  // namespace fumon
