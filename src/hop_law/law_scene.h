#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hop_law/hop_law_scene.h"
#include "models/air/airflow.h"
#include "run/prepared_run.h"
#include "scene/read.h"

namespace fumon {

/// The sand that is to hop by the law.
struct SandSource {
    SceneText text;
    Scene scene;
    bool own = false;  ///< the user's: --into
};

/// The scene named, or where `into` is empty the ripples of Terada (2025, section 5). Throws
/// InputError where it is no scene of the model sand.
SandSource sand_source(const std::string& into);

/// The air of a scene that was set up. Throws InputError where its model is another.
const Airflow& airflow_of(const PreparedRun& prepared);

/// How a measured law becomes a scene.
struct LawSettings {
    std::filesystem::path output;  ///< where the scene will lie: its files are named from there
    HopForm form = HopForm::exponential;
    std::int64_t hops = 1;              ///< in succession that count as one
    std::vector<std::string> settings;  ///< KEY=VALUE that the air was told
    std::filesystem::path flights{};    ///< the table of all flights; empty: none
};

/// A scene file: in comments how the law was measured, then the sand's keys with the law among
/// them, checked as `fumon check` does. Throws InputError.
std::string law_scene(const PreparedRun& prepared, const Airflow& air, const MeasuredHops& hops,
                      const SandSource& sand, const LawSettings& settings);

/// Whether a scene that law_scene() wrote names this file as the table of its flights.
bool names_flights(const std::filesystem::path& law, const std::filesystem::path& flights);

/// Which air was flown in, in a line.
std::string air_line(const PreparedRun& prepared, const Airflow& air);

/// What to hear of the drag law where grains outran it; else nothing.
std::string reynolds_warning(const Airflow& air, const MeasuredHops& hops);

/// How long a model height and a site are.
std::string scale_line(const MeasuredHops& hops);

}  // namespace fumon
