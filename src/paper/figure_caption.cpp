#include "paper/figure_caption.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "figure/page/page_grid.h"
#include "keys/key_value.h"
#include "keys/keys.h"
#include "outputs/own_file.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

/// "creep_rate = 0.2, …": every parameter whose value is not the model's default, without those
/// that vary.
std::string parameters_of(const Scene& scene, const std::vector<std::string>& varied) {
    Scene written = scene;
    Scene usual = default_scene(scene.model.name);
    const KeyTable keys = scene_keys(written);
    KeyTable defaults = scene_keys(usual);
    for (const TableList& list : keys.lists()) {  // items have their defaults too
        const TableList* own =
            list.role == KeyRole::parameter ? defaults.find_list(list.path) : nullptr;
        if (own != nullptr) own->resize(list.size());
    }
    defaults = scene_keys(usual);
    std::vector<std::string> parts;
    for (const Key& key : keys.keys()) {
        const bool varies = std::find(varied.begin(), varied.end(), key.path) != varied.end();
        if (key.role != KeyRole::parameter || varies) continue;
        const std::string value = value_text(key);
        const bool always = key.path == "grid.nx" || key.path == "grid.ny";
        if (!always && value == value_text(*defaults.find(key.path))) continue;
        parts.push_back(
            fmt::format("{} = {}{}", key.path, value,
                        key.notes.unit.empty() ? "" : fmt::format(" {}", key.notes.unit)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string seeds_text(const SweepPlan& plan) {
    if (plan.seeds.count() == 1) return fmt::format("seed {}", plan.seeds.first);
    return fmt::format("seeds {} to {}", plan.seeds.first, plan.seeds.last);
}

std::string varied_text(const SweepPlan& plan) {
    std::string text;
    for (const SweepAxis& axis : plan.axes) {
        std::vector<std::string> values;
        for (const Override& value : axis.values) values.push_back(plain_text(value));
        text += fmt::format(" {} = {};", fmt::join(axis.keys, ", "), fmt::join(values, ", "));
    }
    return text;
}

std::string run_sentence(const Scene& scene, const std::vector<std::string>& varied) {
    const std::string parameters = parameters_of(scene, varied);
    std::string text = fmt::format("model {}, {} steps{}{}.", scene.model.name, scene.run.steps,
                                   parameters.empty() ? "" : ": ", parameters);
    if (!scene.bed.file.empty()) text += fmt::format(" Initial bed: {}.", scene.bed.file);
    return text;
}

std::string curve_sentence(const CurvePlan& curve, std::size_t number) {
    const CurveSettings& settings = curve.settings;
    std::string text = fmt::format("Curve {}: {} over {}", number, settings.y, settings.x);
    if (!settings.group_by.empty()) text += fmt::format(", one for each {}", settings.group_by);
    if (!settings.where.empty())
        text += fmt::format(", where {}", fmt::join(settings.where, " and "));
    if (settings.scale_x != 1.0) text += fmt::format(", x times {}", settings.scale_x);
    if (settings.offset_y != 0.0) text += fmt::format(", y plus {}", settings.offset_y);
    if (settings.scale_y != 1.0) text += fmt::format(", y times {}", settings.scale_y);
    if (settings.spread == CurveSpread::deviation) text += "; bars are standard deviations";
    if (settings.spread == CurveSpread::standard_error)
        text += "; bars are standard errors of the mean";
    if (!curve.sweep) return fmt::format("{}; from {}.", text, settings.file);
    if (settings.table == CurveTable::profile || settings.table == CurveTable::section ||
        settings.table == CurveTable::flights)
        text += fmt::format("; step {}", curve.step);
    return fmt::format("{};{} {}; {}", text, varied_text(*curve.sweep), seeds_text(*curve.sweep),
                       run_sentence(curve.scene, varied_keys(*curve.sweep)));
}

std::string picture_sentence(const PanelPlan& panel) {
    const PicturePlan& picture = *panel.picture;
    std::string steps = picture.steps.size() == 1 ? "step " : "steps ";
    steps += shown_by(panel.settings.kind) == PanelShows::whole_run
                 ? fmt::format("{} to {}", picture.steps.front(), picture.steps.back())
                 : fmt::format("{}", fmt::join(picture.steps, ", "));
    return fmt::format("{}; seed {}; {}", steps, picture.scene.seed,
                       run_sentence(picture.scene, {}));
}

/// "(a): ", "(b) to (d): "; nothing where the figure has one panel only, which has no letter.
std::string heading(const FigurePlan& plan, std::size_t letter, std::size_t panels, bool inset) {
    if (inset) return letter == 0 ? "" : panel_letter(letter - 1) + ", inset: ";
    if (plan.panels.size() == 1 && panels == 1) return {};
    if (panels == 1) return panel_letter(letter) + ": ";
    return fmt::format("{} to {}: ", panel_letter(letter), panel_letter(letter + panels - 1));
}

}  // namespace

std::string figure_caption(const FigurePlan& plan) {
    std::string text;
    if (!plan.scene.title.empty()) text += plan.scene.title + ".\n";
    if (!plan.scene.figure.caption.empty()) text += plan.scene.figure.caption + "\n";
    std::size_t letter = 0;
    for (const PanelPlan& panel : plan.panels) {
        const bool inset = panel.settings.inset != InsetPlace::none;
        const std::size_t panels = panels_of(panel);
        text += '\n';
        text += heading(plan, letter, panels, inset);
        if (!inset) letter += panels;
        if (panel.picture) text += picture_sentence(panel) + "\n";
        std::size_t number = 0;
        for (const CurvePlan& curve : panel.curves) text += curve_sentence(curve, ++number) + "\n";
        for (const RangeBoxSettings& box : panel.settings.boxes)
            text += fmt::format("{}: {}.\n", box.label, box.source);
    }
    for (const InputFile& input : plan.inputs)
        text += fmt::format("\n{}: SHA-256 {}.", input.path, input.hash);
    return fmt::format("{}\n{}{}{}{}.\n", text, own_caption_mark, plan.file, own_caption_maker,
                       FUMON_VERSION);
}

}  // namespace fumon
