#include "sweep/sweep_manifest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "files/json_text.h"
#include "scene/json.h"
#include "shards/shard.h"

namespace fumon {

namespace {

using Json = nlohmann::ordered_json;

Json axes_json(const SweepPlan& plan) {
    Json axes = Json::array();
    for (const SweepAxis& axis : plan.axes) {
        Json values = Json::array();
        for (const Override& value : axis.values) values.push_back(plain_text(value));
        axes.push_back({{"keys", axis.keys}, {"values", values}});
    }
    return axes;
}

std::string axis_keys(const Json& axes) {
    std::vector<std::string> names;
    for (const Json& axis : axes) {
        const auto keys = axis.at("keys").get<std::vector<std::string>>();
        names.push_back(fmt::format("{}", fmt::join(keys, "+")));
    }
    return names.empty() ? "no key" : fmt::format("{}", fmt::join(names, ", "));
}

std::string input_difference(const Json& previous, const SweepPlan& plan) {
    for (const Json& input : previous) {
        const auto path = input.at("path").get<std::string>();
        const auto hash = input.at("sha256").get<std::string>();
        const auto same = [&](const InputFile& known) { return known.hash == hash; };
        if (std::any_of(plan.inputs.begin(), plan.inputs.end(), same)) continue;
        const auto changed = [&](const InputFile& known) { return known.path == path; };
        if (std::any_of(plan.inputs.begin(), plan.inputs.end(), changed))
            return fmt::format("{} has changed since", path);
    }
    return {};
}

std::string value_difference(const Json& previous, const Json& now) {
    for (std::size_t axis = 0; axis < previous.size(); ++axis) {
        const Json& values = now.at(axis).at("values");
        for (const Json& value : previous.at(axis).at("values")) {
            if (std::find(values.begin(), values.end(), value) != values.end()) continue;
            return fmt::format("it has {}={}, which is no longer among the values",
                               axis_keys(Json::array({previous.at(axis)})),
                               value.get<std::string>());
        }
    }
    return {};
}

/// The ids of the runs in the order of their numbers, hexadecimal. Throws
/// nlohmann::json::exception when the manifest is damaged.
std::vector<std::string> run_ids(const Json& manifest) {
    return manifest.at("runs").get<std::vector<std::string>>();
}

/// The first thing in which the sweep of a manifest is not part of a plan, as "its scene has
/// run.steps = 20, now 40".
std::string difference(const Json& manifest, const SweepPlan& plan) {
    const auto version = manifest.at("fumon").get<std::string>();
    if (version != FUMON_VERSION)
        return fmt::format("it was made by fumon {}, this is {}", version, FUMON_VERSION);
    const Json axes = axes_json(plan);
    const Json& previous = manifest.at("over");
    if (axis_keys(previous) != axis_keys(axes))
        return fmt::format("it varies {}, now {}", axis_keys(previous), axis_keys(axes));
    std::string found = scene_difference(manifest.at("scene"), plan.base);
    if (found.empty()) found = input_difference(manifest.at("inputs"), plan);
    if (found.empty()) found = value_difference(previous, axes);
    const auto first = whole_number(manifest.at("seeds").at("first"));
    const auto last = whole_number(manifest.at("seeds").at("last"));
    if (found.empty() && (first < plan.seeds.first || last > plan.seeds.last)) {
        found = fmt::format("it has the seeds {} to {}, now {} to {}", first, last,
                            plan.seeds.first, plan.seeds.last);
    }
    return found.empty() ? "its runs are others" : found;
}

}  // namespace

std::string sweep_manifest(const SweepPlan& plan, const std::vector<std::size_t>& order,
                           int shards) {
    Json json;
    json["fumon"] = FUMON_VERSION;
    json["scene"] = plan.base;
    json["over"] = axes_json(plan);
    json["seeds"] = {{"first", plan.seeds.first}, {"last", plan.seeds.last}};
    json["inputs"] = Json::array();
    for (const InputFile& input : plan.inputs)
        json["inputs"].push_back({{"path", input.path}, {"sha256", input.hash}});
    if (shards > 0) json["shards"] = shards;
    json["runs"] = Json::array();
    for (const std::size_t run : order) json["runs"].push_back(hex(plan.runs[run].id));
    return json_text(json, 2) + "\n";
}

std::int64_t listed_runs(std::string_view manifest) {
    try {
        const Json json = parse_json(manifest);
        return json.contains("fumon") ? static_cast<std::int64_t>(run_ids(json).size()) : -1;
    } catch (const nlohmann::json::exception&) {
        return -1;
    }
}

int listed_shards(std::string_view manifest) {
    try {
        const Json json = parse_json(manifest);
        const std::int64_t shards = json.contains("shards") ? whole_number(json["shards"]) : 0;
        return shards > 0 && shards <= most_shards ? static_cast<int>(shards) : 0;
    } catch (const nlohmann::json::exception&) {
        return 0;
    }
}

PreviousSweep previous_sweep(std::string_view manifest, const SweepPlan& plan) {
    std::map<std::string, std::size_t> planned;
    for (std::size_t k = 0; k < plan.runs.size(); ++k) planned[hex(plan.runs[k].id)] = k;
    PreviousSweep previous;
    try {
        const Json json = parse_json(manifest);
        for (const std::string& id : run_ids(json)) {
            const auto found = planned.find(id);
            if (found == planned.end() || json.at("fumon") != FUMON_VERSION)
                return {{}, "holds another sweep: " + difference(json, plan)};
            previous.order.push_back(found->second);
            planned.erase(found);
        }
    } catch (const nlohmann::json::exception&) {
        return {{}, "holds a sweep whose sweep.json is damaged"};
    }
    return previous;
}

std::string run_record_text(const Sha256& id, const RunRecord& record) {
    Json json;
    json["id"] = hex(id);
    json["steps"] = record.steps;
    json["wall_seconds"] = record.wall_seconds;
    json["state_sha256"] = record.state;
    if (record.status == RunStatus::failed) json["failed"] = true;
    if (!record.message.empty()) json["message"] = record.message;
    return json.dump(2) + "\n";
}

RunRecord parse_run_record(std::string_view text, const Sha256& id) {
    try {
        const Json json = parse_json(text);
        if (json.at("id") != hex(id)) return {};
        const bool failed = json.value("failed", false);
        return {failed ? RunStatus::failed : RunStatus::done, whole_number(json.at("steps")),
                json.at("wall_seconds"), json.at("state_sha256"), json.value("message", "")};
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

}  // namespace fumon
