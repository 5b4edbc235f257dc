#include "sweep/sweep_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "run/terminal/interrupt.h"
#include "scene/json.h"
#include "scene/schedule.h"

namespace fumon {

namespace {

std::vector<SweepAxis> read_axes(const std::vector<std::string>& texts, const std::string& place) {
    std::vector<SweepAxis> axes;
    for (const std::string& text : texts) {
        const bool in_scene = !place.empty();
        SweepAxis axis = read_axis(
            text, in_scene ? place : fmt::format("--over {}", axes.size() + 1), !in_scene);
        std::vector<std::string> before;
        for (const SweepAxis& other : axes)
            before.insert(before.end(), other.keys.begin(), other.keys.end());
        for (const std::string& key : axis.keys) {
            if (std::find(before.begin(), before.end(), key) != before.end()) {
                throw InputError(
                    fmt::format("{}{}: {} is varied twice; give all its values at once", axis.place,
                                in_scene ? "" : ":1", key));
            }
            before.push_back(key);
        }
        axes.push_back(std::move(axis));
    }
    return axes;
}

std::size_t combinations(const SweepPlan& plan) {
    std::size_t count = 1;
    for (const SweepAxis& axis : plan.axes) {
        count *= axis.values.size();
        if (count * static_cast<std::size_t>(plan.seeds.count()) > most_runs) {
            throw InputError(fmt::format(
                "the sweep has more than {} runs; vary fewer values or seeds at once", most_runs));
        }
    }
    return count;
}

/// Which value of each axis a combination has.
std::vector<std::size_t> choice_of(const SweepPlan& plan, std::size_t combination) {
    std::vector<std::size_t> choice(plan.axes.size());
    for (std::size_t axis = plan.axes.size(); axis-- > 0;) {
        choice[axis] = combination % plan.axes[axis].values.size();
        combination /= plan.axes[axis].values.size();
    }
    return choice;
}

Scene scene_of(const SweepPlan& plan, std::size_t combination) {
    std::vector<Override> overrides = plan.settings;
    const auto choice = choice_of(plan, combination);
    for (std::size_t axis = 0; axis < choice.size(); ++axis) {
        for (const std::string& key : plan.axes[axis].keys) {
            overrides.push_back(plan.axes[axis].values[choice[axis]]);
            overrides.back().path = key;
        }
    }
    return parse_scene(plan.scene, overrides);
}

/// Takes a key such as model.flux or wind.0.duration out.
void erase_key(nlohmann::ordered_json& of, const std::string& key) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos) {
        if (of.is_object()) of.erase(key);
        return;
    }
    const std::string first = key.substr(0, dot);
    if (of.is_array()) {
        const std::size_t item = std::stoul(first);
        if (item < of.size()) erase_key(of[item], key.substr(dot + 1));
    } else if (of.contains(first)) {
        erase_key(of[first], key.substr(dot + 1));
    }
}

nlohmann::ordered_json base_of(const SweepPlan& plan, const Scene& scene) {
    nlohmann::ordered_json base = scene_json(scene, recorded_roles);
    base.erase("seed");
    for (const std::string& key : varied_keys(plan)) erase_key(base, key);
    return base;
}

void note_once(SweepPlan& plan, const std::string& note) {
    if (note.empty() || std::find(plan.notes.begin(), plan.notes.end(), note) != plan.notes.end())
        return;
    plan.notes.push_back(note);
}

void note_inputs(SweepPlan& plan, const InitialBed& initial) {
    for (const InputFile& input : initial.inputs) {
        const auto same = [&](const InputFile& known) { return known.path == input.path; };
        if (std::none_of(plan.inputs.begin(), plan.inputs.end(), same))
            plan.inputs.push_back(input);
    }
    note_once(plan, initial.note);
}

void check_outputs(SweepPlan& plan, const Scene& scene) {
    if (!scene.output.measurements) {
        throw InputError(fmt::format(
            "{}output.measurements is false, but a sweep needs measurements; leave it true",
            scene.at("output.measurements")));
    }
    if (bed_schedule(scene).count() > 0) {
        note_once(plan,
                  "a sweep writes no bed files; output.fields_every and output.fields_at record "
                  "the bed too");
    }
}

[[noreturn]] void refuse_duplicates(const SweepPlan& plan, const SweepRun& first,
                                    const SweepRun& second) {
    const auto left = choice_of(plan, first.combination);
    const auto right = choice_of(plan, second.combination);
    const auto differing = static_cast<std::size_t>(
        std::mismatch(left.begin(), left.end(), right.begin()).first - left.begin());
    const Override& value = plan.axes[differing].values[right[differing]];
    throw InputError(fmt::format(
        "{}: {} is the same run as {}; a sweep makes no pictures and runs each scene once",
        value.column == 0 ? value.place : fmt::format("{}:{}", value.place, value.column),
        run_label(plan, second), run_label(plan, first)));
}

/// Makes a scene ready, and builds its model once, to see that it is right, unless its run is
/// finished.
PreparedScene try_scene(Scene scene, const SweepRequest& request, std::optional<Snapshot>* first) {
    PreparedScene prepared = prepare_scene(std::move(scene));
    if (request.finished) *first = request.finished(prepared);
    if (*first) return prepared;
    PreparedRun run = prepare_run(std::move(prepared), 1);
    if (request.finished) *first = run.model->snapshot();
    return {std::move(run.scene), std::move(run.initial)};
}

/// Tries a combination with the first seed. A refusal that is not placed at one of its values says
/// which combination it is about.
PreparedScene try_combination(SweepPlan& plan, const SweepRequest& request,
                              std::size_t combination) {
    try {
        Scene scene = scene_of(plan, combination);
        check_outputs(plan, scene);
        scene.seed = plan.seeds.first;
        std::optional<Snapshot> first;
        PreparedScene tried = try_scene(std::move(scene), request, &first);
        if (combination == 0) plan.first = std::move(first);
        return tried;
    } catch (const InputError& refusal) {
        std::vector<std::string> lines = refusal.lines();
        if (plan.axes.empty() || lines.front().starts_with("--over ")) throw;
        for (std::string& line : lines) {
            line += fmt::format(" (with {})",
                                run_label(plan, {combination, plan.seeds.first, {}, 0.0}));
        }
        throw InputError(std::move(lines));
    }
}

/// Lists the runs of a combination.
void add_combination(SweepPlan& plan, const SweepRequest& request, std::size_t combination,
                     std::map<Sha256, SweepRun>& known) {
    auto [scene, initial] = try_combination(plan, request, combination);
    note_inputs(plan, initial);
    if (combination == 0) plan.base = base_of(plan, scene);
    const double work =
        static_cast<double>(initial.bed.size()) * static_cast<double>(scene.run.steps + 1);
    for (std::int64_t seed = plan.seeds.first; plan.runs.size() < most_runs; ++seed) {
        scene.seed = seed;
        const SweepRun run{combination, seed, run_id(scene, initial), work};
        const auto [twin, is_new] = known.emplace(run.id, run);
        if (!is_new) refuse_duplicates(plan, twin->second, run);
        plan.runs.push_back(run);
        if (seed == plan.seeds.last) return;
    }
}

}  // namespace

std::optional<SweepPlan> make_plan(const SweepRequest& request) {
    SweepPlan plan;
    plan.scene = request.scene;
    plan.settings = request.settings;
    if (request.over.empty()) {
        const Scene scene = parse_scene(plan.scene, plan.settings);
        const std::string place = scene.at("sweep.over");
        plan.axes = read_axes(scene.sweep.over, place.substr(0, place.rfind(": ")));
    } else {
        plan.axes = read_axes(request.over, request.over_place);
    }
    const Scene first = scene_of(plan, 0);
    plan.seeds = read_seeds(
        request.seeds.empty() ? fmt::format("{}", first.sweep.seeds) : request.seeds, first.seed);
    std::map<Sha256, SweepRun> known;
    const std::size_t count = combinations(plan);
    for (std::size_t combination = 0; combination < count; ++combination) {
        if (interrupting_signal() != 0) return std::nullopt;
        add_combination(plan, request, combination, known);
    }
    return plan;
}

Scene scene_of(const SweepPlan& plan, const SweepRun& run) {
    Scene scene = scene_of(plan, run.combination);
    scene.seed = run.seed;
    return scene;
}

std::vector<std::string> varied_keys(const SweepPlan& plan) {
    std::vector<std::string> keys;
    for (const SweepAxis& axis : plan.axes)
        keys.insert(keys.end(), axis.keys.begin(), axis.keys.end());
    return keys;
}

std::vector<std::string> values_of(const SweepPlan& plan, const SweepRun& run) {
    std::vector<std::string> values;
    const auto choice = choice_of(plan, run.combination);
    for (std::size_t axis = 0; axis < choice.size(); ++axis) {
        values.insert(values.end(), plan.axes[axis].keys.size(),
                      plain_text(plan.axes[axis].values[choice[axis]]));
    }
    return values;
}

std::string run_label(const SweepPlan& plan, const SweepRun& run) {
    const auto keys = varied_keys(plan);
    const auto values = values_of(plan, run);
    std::string label;
    for (std::size_t k = 0; k < keys.size(); ++k)
        label += fmt::format("{}={}, ", keys[k], values[k]);
    return fmt::format("{}seed {}", label, run.seed);
}

}  // namespace fumon
