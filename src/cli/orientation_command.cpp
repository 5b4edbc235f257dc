#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "cli/command.h"
#include "cli/examples.h"
#include "cli/remark.h"
#include "cli/shared_options.h"
#include "files/input_file.h"
#include "measure/bed/crest_orientation.h"
#include "scene/initial_bed.h"
#include "scene/terrain_scene.h"
#include "wind/crest_directions.h"
#include "wind/direction.h"
#include "wind/sand_flux.h"
#include "wind/wind_rose.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

constexpr double metres_per_micrometre = 1e-6;

struct OrientationOptions {
    std::string wind;                    ///< the table of winds
    std::string law = "saturated";       ///< by which winds move sand
    double flux_ratio = 1.6;             ///< γ
    double threshold = 12.0;             ///< knots, of Fryberger's law
    double grain_diameter = 250.0;       ///< µm, of the saturated flux
    double roughness = 1e-3;             ///< m, of the saturated flux
    double height = usual_speed_height;  ///< m, of the speeds
    std::string bed;                     ///< whose crests are measured; empty: none
    std::string heights;                 ///< "low:high", metres of black and white of a PNG bed
    bool open_edges = false;             ///< the bed ends at its edges
    bool as_json = false;
    std::vector<std::string> settings;
};

void declare(CLI::App& command, OrientationOptions& options) {
    command
        .add_option(
            "--wind", options.wind,
            "a table of winds: direction,speed,frequency (where from, in degrees clockwise "
            "from north; m/s; share of the time), or direction,friction_velocity,frequency, "
            "or direction,flux")
        ->type_name("ROSE.csv")
        ->required();
    add_word(command, "--law", options.law, {"saturated", "fryberger"},
             "how much sand a wind moves: saturated (default; m2 a year) or fryberger (vector "
             "units)")
        ->type_name("NAME");
    add_number(command, "--flux-ratio", options.flux_ratio, 0.0, 100.0,
               "of the sand that moves over a crest beyond that over flat ground (default 1.6)")
        ->type_name("GAMMA");
    add_number(command, "--threshold", options.threshold, 0.0, 100.0,
               "wind below which no sand moves by Fryberger's law, knots (default 12)")
        ->type_name("KNOTS");
    add_number(command, "--grain-diameter", options.grain_diameter, 50.0, 2000.0,
               "of the saturated flux, micrometres (default 250)")
        ->type_name("UM");
    add_number(command, "--roughness", options.roughness, 1e-6, 1.0,
               "of the ground, for the saturated flux, metres (default 0.001)")
        ->type_name("M");
    add_number(command, "--height", options.height, 0.1, 1000.0,
               "of the anemometer above the ground, metres (default 10)")
        ->type_name("M");
    command
        .add_option("--bed", options.bed,
                    "a bed, north at its top, whose crests are measured beside")
        ->type_name("BED");
    command.add_flag("--open", options.open_edges,
                     "the bed ends at its edges (default: periodic, as in the models of sand)");
    command.add_flag("--json", options.as_json, "as JSON");
    add_heights(command, options.heights);
    add_settings(command, options.settings,
                 "override a key of the bed, as bed.nodata (repeatable)");
    add_examples(command,
                 {{"fumon orientation --wind rose.csv", ""},
                  {"fumon orientation --wind rose.csv --bed out/run/beds/bed_00001000.asc",
                   "beside a bed's"}},
                 "Crests run along the directions given, in degrees clockwise from north; several "
                 "where they "
                 "are\nequally favoured. Fingers grow toward theirs.");
}

/// One law's reading of the winds.
struct Prediction {
    WindTable winds;
    std::vector<SandFlux> fluxes;
    std::string unit;
    Drift drift;
    CrestDirections crests;
};

/// Fryberger's law is of speeds in knots 10 m above the ground.
void check_fits_fryberger(const OrientationOptions& options, const WindRose& rose) {
    if (options.height != usual_speed_height)
        throw InputError(fmt::format(
            "--law fryberger takes speeds 10 m above the ground, not {:g} m", options.height));
    if (std::ranges::any_of(rose, [](const WindClass& w) { return w.friction_velocity > 0.0; }))
        throw InputError(fmt::format(
            "{}: --law fryberger takes speeds 10 m above the ground, not friction velocities",
            options.wind));
}

Prediction predicted(const OrientationOptions& options) {
    Prediction of;
    const std::string text = read_input_file(options.wind);
    of.winds = read_wind_table({options.wind, text});
    if (!of.winds.fluxes.empty()) {
        of.fluxes = of.winds.fluxes;
        of.unit = "as given";
    } else if (options.law == "fryberger") {
        check_fits_fryberger(options, of.winds.rose);
        of.fluxes = fryberger_fluxes(of.winds.rose, options.threshold);
        of.unit = "vector units";
    } else {
        SandAndAir with;
        with.grain_diameter = options.grain_diameter * metres_per_micrometre;
        with.roughness = options.roughness;
        if (options.height <= options.roughness)
            throw InputError(
                fmt::format("--height {:g} lies within the ground's --roughness of {:g} m",
                            options.height, options.roughness));
        of.fluxes = saturated_fluxes(of.winds.rose, with, options.height);
        of.unit = "m2 a year";
    }
    of.drift = drift_of(of.fluxes);
    of.crests = crest_directions(of.fluxes, options.flux_ratio);
    return of;
}

/// The direction of the crests of a bed, from 0 up to 180 degrees clockwise from north, and how
/// much they agree.
struct Measured {
    double direction = 0.0;
    double coherence = 0.0;
};

std::optional<Measured> measured(const OrientationOptions& options) {
    if (options.bed.empty()) return std::nullopt;
    const InitialBed initial =
        make_initial_bed(terrain_scene(options.bed, options.heights, options.settings));
    if (!initial.note.empty()) remark(initial.note + "\n");
    if (!initial.nodata.empty())
        throw InputError(
            fmt::format("{}: has cells without data; crests are measured on beds without gaps "
                        "(--set bed.nodata=fill)",
                        options.bed));
    const CrestOrientation crests = crest_orientation(initial.bed, !options.open_edges);
    if (std::isnan(crests.degrees))
        throw InputError(fmt::format(
            "{}: has no crests: it has no relief, or fewer than 5 x 5 cells", options.bed));
    return Measured{std::fmod(half_turn - crests.degrees, half_turn), crests.coherence};
}

std::string list_text(const std::vector<double>& directions) {
    if (directions.empty()) return "none favoured";
    std::string text;
    for (const double direction : directions)
        text += fmt::format("{}{:.1f}", text.empty() ? "" : ", ", direction);
    return text + " degrees";
}

// The classes of Fryberger & Dean (1979).

std::string_view energy(double potential) {
    constexpr double low = 200.0;
    constexpr double high = 400.0;
    return potential < low    ? "low energy"
           : potential < high ? "intermediate energy"
                              : "high energy";
}

std::string_view of_one_side(double ratio) {
    constexpr double low = 0.3;
    constexpr double high = 0.8;
    return ratio < low ? "low" : ratio < high ? "intermediate" : "high";
}

/// The angle between two lines, 0 to 90 degrees.
double between(double one, double other) {
    const double angle = std::abs(std::fmod(one - other, half_turn));
    return std::fmin(angle, half_turn - angle);
}

std::string nearest_text(double direction, const std::vector<double>& predicted) {
    if (predicted.empty()) return "";
    double least = half_turn;
    for (const double one : predicted) least = std::fmin(least, between(direction, one));
    return fmt::format("{:.1f}", least);
}

std::string line(std::string_view name, std::string_view value, std::string_view remark = "") {
    std::string text = fmt::format("{:<34} {:<24} {}", name, value, remark);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
}

std::string as_text(const OrientationOptions& options, const Prediction& of,
                    const std::optional<Measured>& bed) {
    const bool vector_units = of.unit == "vector units";
    std::string text =
        line("sand moved (DP)", fmt::format("{:.4g} {}", of.drift.potential, of.unit),
             vector_units ? energy(of.drift.potential) : "");
    text += line("resultant (RDP)", fmt::format("{:.4g} {}", of.drift.resultant, of.unit));
    if (of.drift.potential > 0.0) {
        const double ratio = of.drift.resultant / of.drift.potential;
        text += line("RDP/DP", fmt::format("{:.3f}", ratio), of_one_side(ratio));
    }
    text += line("resultant toward (RDD)", std::isnan(of.drift.toward)
                                               ? "nowhere"
                                               : fmt::format("{:.1f} degrees", of.drift.toward));
    text += line("crests, gross normal transport", list_text(of.crests.gross_normal_transport),
                 "Rubin & Hunter 1987");
    text += line("crests, bed instability", list_text(of.crests.bed_instability),
                 fmt::format("Courrech du Pont et al. 2014, gamma {:g}", options.flux_ratio));
    text +=
        line("growth, fingering", list_text(of.crests.fingering), "the same, where sand is scarce");
    if (bed) {
        text += line("crests measured", fmt::format("{:.1f} degrees", bed->direction),
                     fmt::format("coherence {:.2f}", bed->coherence));
        const auto away = [&](std::string_view name, const std::vector<double>& predicted) {
            const std::string angle = nearest_text(bed->direction, predicted);
            if (!angle.empty()) text += line(name, angle + " degrees");
        };
        away("  away from gross normal transport", of.crests.gross_normal_transport);
        away("  away from bed instability", of.crests.bed_instability);
        away("  away from fingering", of.crests.fingering);
    }
    return text;
}

std::string as_json(const OrientationOptions& options, const Prediction& of,
                    const std::optional<Measured>& bed) {
    Json json;
    json["wind"] = options.wind;
    json["flux_unit"] = of.unit;
    json["drift_potential"] = of.drift.potential;
    json["resultant_drift_potential"] = of.drift.resultant;
    json["resultant_drift_direction"] = of.drift.toward;  // null where there is none
    json["flux_ratio"] = options.flux_ratio;
    json["crests_by_gross_normal_transport"] = of.crests.gross_normal_transport;
    json["crests_by_bed_instability"] = of.crests.bed_instability;
    json["growth_by_fingering"] = of.crests.fingering;
    if (bed) {
        json["bed"] = options.bed;
        json["measured_crests"] = bed->direction;
        json["measured_coherence"] = bed->coherence;
    }
    return json.dump(2) + "\n";
}

int perform(const OrientationOptions& options) {
    const Prediction prediction = predicted(options);
    const std::optional<Measured> bed = measured(options);
    const std::string text =
        options.as_json ? as_json(options, prediction, bed) : as_text(options, prediction, bed);
    std::fputs(text.c_str(), stdout);
    return 0;
}

}  // namespace

Command orientation_command() {
    return make_command<OrientationOptions>(
        "orientation", "predict which way crests run under given winds, beside those of a bed",
        declare, perform);
}

}  // namespace fumon
