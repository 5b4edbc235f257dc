#include "wind/drift_json.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "wind/crest_directions.h"
#include "wind/run_drift.h"

namespace fumon {

nlohmann::ordered_json drift_json(std::span<const SnapshotWind> winds) {
    using Json = nlohmann::ordered_json;
    const std::vector<SandFlux> fluxes = fluxes_of(winds);
    const Drift drift = drift_of(fluxes);
    Json json{{"unit", "m2/yr"},
              {"drift_potential", drift.potential},
              {"resultant_drift_potential", drift.resultant},
              {"resultant_drift_direction", drift.toward},
              {"winds", Json::array()}};
    for (const SandFlux& flux : fluxes)
        json["winds"].push_back({{"toward", flux.toward}, {"flux", flux.amount}});
    return json;
}

}  // namespace fumon
