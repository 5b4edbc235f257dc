#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sweep/sweep_plan.h"

namespace fumon {

/// sweep.json of a plan whose runs stand in this order.
std::string sweep_manifest(const SweepPlan& plan, const std::vector<std::size_t>& order);

/// The ids of a sweep.json's runs in the order of their numbers, hexadecimal. Throws
/// nlohmann::json::exception when it is damaged.
std::vector<std::string> run_ids(const nlohmann::ordered_json& manifest);

/// The first thing in which the sweep of a sweep.json is not part of a plan, as "its scene has
/// run.steps = 20, now 40".
std::string difference(const nlohmann::ordered_json& manifest, const SweepPlan& plan);

}  // namespace fumon
