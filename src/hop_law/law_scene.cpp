#include "hop_law/law_scene.h"

#include <fmt/format.h>

#include "base/data_files.h"
#include "base/error.h"
#include "base/units.h"
#include "files/input_file.h"
#include "models/sand/sand.h"
#include "outputs/own_file.h"
#include "scene/initial_bed.h"
#include "scene/write.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

/// Section 5 of Terada (2025): the ripples that the law makes where no other sand is asked for.
constexpr const char* ripples_of_section_5 = "scenes/figures/terada-2025-21.toml";

/// Whether the law's scale in metres becomes that of the sand: not where its own is known.
bool takes_scale(const Scene& sand) {
    return bed_kind(sand) != BedKind::file && sand.grid.cell_size.empty() &&
           sand.grid.height_unit.is_word();
}

std::string grain_line(const Airflow& air, const MeasuredHops& hops, std::int64_t count) {
    const FlightParameters& flight = air.parameters().flight;
    return fmt::format("{} grains of {:g} mm and {:g} kg/m^3, {} drag, {}", hops.pooled.flights,
                       flight.grain_diameter, flight.grain_density,
                       flight.drag == GrainDrag::stokes ? "Stokes'" : "Schiller and Naumann's",
                       count == 1 ? std::string("one hop each")
                                  : fmt::format("{} hops in succession each", count));
}

/// A comment in the scene; what it quotes must not end it.
std::string comment(std::string line) {
    for (char& letter : line) {
        if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
    }
    return line.empty() ? "#\n" : "# " + line + "\n";
}

/// Names the table of flights as seen from the law.
std::string flights_line(const fs::path& law, const fs::path& flights) {
    const fs::path folder = fs::absolute(law).parent_path();
    return comment("Every flight: " + fs::proximate(fs::absolute(flights), folder).string());
}

std::string law_head(const PreparedRun& prepared, const Airflow& air, const MeasuredHops& hops,
                     const LawSettings& settings, bool scaled) {
    std::string text = comment(
        "Sand that hops by a law measured on grains flown in computed air "
        "(Terada 2025, sections 4 and 5).");
    text += comment(std::string(own_scene_mark.substr(2)) +
                    FUMON_VERSION " hop-law: " + air_line(prepared, air) + ";");
    text += comment(grain_line(air, hops, settings.hops) + ".");
    if (!settings.flights.empty()) text += flights_line(settings.output, settings.flights);
    for (const std::string& setting : settings.settings) text += comment("--set " + setting);
    text += comment("Fits, heights above the bed's lowest point: l = a^h - 1 and a straight line.");
    text += comment("");
    for (const std::string& line : fit_lines(hops)) text += comment(line);
    text += comment("");
    if (const std::string warning = reynolds_warning(air, hops); !warning.empty())
        text += comment("Note: " + warning + ".");
    text += comment("The law: " + law_line(hops, settings.form) + ".");
    text += comment("Scale (eq. 45): " + scale_line(hops) +
                    (scaled ? "." : "; the grid keeps a scale of its own."));
    return text;
}

/// The files that a scene names, from its own folder, as the written scene reaches them.
void move_files(const fs::path& output, PreparedRun& sand) {
    const fs::path folder = fs::absolute(output).parent_path();
    const auto from_folder = [&](const fs::path& file) {
        return fs::proximate(fs::absolute(file), folder).string();
    };
    const auto move = [&](std::string& file) {
        if (!file.empty() && fs::path(file).is_relative())
            file = from_folder(sand.scene.directory / file);
    };
    Scene& scene = sand.scene;
    move(scene.view.look.drape);
    for (LayerSettings& layer : scene.view.layers) move(layer.file);
    if (!scene.bed.file.empty() && !sand.initial.inputs.empty() &&
        fs::path(scene.bed.file).is_relative())
        scene.bed.file = from_folder(sand.initial.inputs.front().path);
    for (PanelSettings& panel : scene.figure.panels) {
        move(panel.scene);
        for (CurveSettings& curve : panel.curves) {
            move(curve.scene);
            move(curve.file);
        }
    }
}

/// The sand's keys with the law among them, checked as `fumon check` does.
std::string sand_text(const SandSource& source, const MeasuredHops& hops, const LawSettings& law) {
    std::vector<Override> settings = law_settings(hops, law.form);
    const auto set = [&](const char* key, const std::string& value) {
        settings.push_back({key, value, "the measured law", 0});
    };
    if (takes_scale(source.scene)) {
        set("grid.cell_size", fmt::format("[{}]", hops.site * metres_per_millimetre));
        set("grid.height_unit", fmt::format("{}", hops.height * metres_per_millimetre));
    }
    if (!source.own) set("title", "Ripples by a hop law measured on computed flights");
    PreparedRun sand = prepare_run(parse_scene(source.text, settings), 1);
    if (!source.own) sand.scene.figure = {};  // it tells of the paper's law
    move_files(law.output, sand);
    return to_toml(sand.scene);
}

}  // namespace

SandSource sand_source(const std::string& into) {
    SandSource sand;
    sand.own = !into.empty();
    sand.text = read_scene_text(sand.own ? fs::path(into) : data_file(ripples_of_section_5));
    sand.scene = prepare_run(parse_scene(sand.text, {}), 1).scene;
    if (sand.scene.model.name != Sand::model_name) {
        throw InputError(fmt::format("{}a hop law is for the model {}, not for {}",
                                     sand.scene.at("model.name"), Sand::model_name,
                                     sand.scene.model.name));
    }
    return sand;
}

const Airflow& airflow_of(const PreparedRun& prepared) {
    const auto* air = dynamic_cast<const Airflow*>(prepared.model.get());
    if (air == nullptr) {
        throw InputError(fmt::format(
            "{}a hop law is measured in the air of the model {}, but this scene has the model {}",
            prepared.scene.at("model.name"), Airflow::model_name, prepared.scene.model.name));
    }
    return *air;
}

std::string air_line(const PreparedRun& prepared, const Airflow& air) {
    const std::string steady =
        air.steady_since()
            ? fmt::format("steady since {:.4g} s", *air.steady_since())
            : std::string("not steady yet (model.until_steady = true and more steps go on)");
    return fmt::format("air of {} (seed {}) after {} steps, {:.4g} s, {}", prepared.scene.source,
                       prepared.scene.seed, air.steps_done(), air.time(), steady);
}

std::string reynolds_warning(const Airflow& air, const MeasuredHops& hops) {
    constexpr double beyond_stokes = 2.0;  // Terada (2025), section 2.2
    constexpr double beyond_schiller_naumann = 800.0;
    const double reached = hops.pooled.reynolds;
    if (air.parameters().flight.drag == GrainDrag::stokes) {
        if (reached <= beyond_stokes) return {};
        return fmt::format(
            "particle Reynolds numbers reach {:.3g}, beyond Stokes' drag (2); see "
            "also --set model.drag=\"schiller-naumann\"",
            reached);
    }
    if (reached <= beyond_schiller_naumann) return {};
    return fmt::format(
        "particle Reynolds numbers reach {:.3g}, beyond Schiller and Naumann's drag (800)",
        reached);
}

std::string scale_line(const MeasuredHops& hops) {
    return fmt::format(
        "one model height is the bed's range, {:.4g} mm; one site is a tenth of the "
        "hop from the crest, {:.4g} mm",
        hops.height, hops.site);
}

bool names_flights(const fs::path& law, const fs::path& flights) {
    std::error_code fault;
    if (!fs::is_regular_file(law, fault) || !is_made_by_fumon(law)) return false;
    return read_input_file(law).find("\n" + flights_line(law, flights)) != std::string::npos;
}

std::string law_scene(const PreparedRun& prepared, const Airflow& air, const MeasuredHops& hops,
                      const SandSource& sand, const LawSettings& settings) {
    return law_head(prepared, air, hops, settings, takes_scale(sand.scene)) +
           sand_text(sand, hops, settings);
}

}  // namespace fumon
