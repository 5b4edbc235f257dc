#include "paper/figure_caption.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "figure/page/page_grid.h"
#include "figure/words/words.h"
#include "outputs/own_file.h"
#include "paper/caption/caption_facts.h"

namespace fumon {

namespace {

std::string seeds_text(const SweepPlan& plan) {
    if (plan.seeds.count() == 1) return phrase("seed {}", plan.seeds.first);
    return phrase("seeds {} to {}", plan.seeds.first, plan.seeds.last);
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

/// "; own" where there is something of a run's own.
std::string after(const std::string& own) {
    return own.empty() ? "" : "; " + own;
}

/// A formula whose exponents that are numbers are raised whole: "x^{0.5}" of "x^0.5".
std::string formula_text(const std::string& formula) {
    std::string text;
    for (std::size_t i = 0; i < formula.size(); ++i) {
        text += formula[i];
        const std::size_t end =
            std::min(formula.find_first_not_of("0123456789.", i + 1), formula.size());
        if (formula[i] != '^' || end == i + 1) continue;
        text += '{' + formula.substr(i + 1, end - i - 1) + '}';
        i = end - 1;
    }
    return text;
}

std::string curve_sentence(const CurvePlan& curve, PanelKind kind, std::size_t number,
                           const std::string& own) {
    const CurveSettings& settings = curve.settings;
    if (settings.table == CurveTable::expression) {
        std::string text =
            phrase("Curve {}: {}", number, "y = " + formula_text(settings.expression));
        if (!settings.constants.empty())
            text += fmt::format(", {}", fmt::join(settings.constants, ", "));
        return text + ".";
    }
    std::string text = phrase("Curve {}: {} over {}", number, settings.y, settings.x);
    if (kind == PanelKind::histogram) text = phrase("Curve {}: values of {}", number, settings.y);
    if (!settings.z.empty())
        text = phrase("Curve {}: {} over {} and {}", number, settings.z, settings.x, settings.y);
    if (!settings.group_by.empty()) text += phrase(", one for each {}", settings.group_by);
    if (!settings.where.empty())
        text += phrase(", where {}", fmt::format("{}", fmt::join(settings.where, word(" and "))));
    if (settings.scale_x != 1.0) text += phrase(", x times {}", settings.scale_x);
    if (settings.offset_y != 0.0) text += phrase(", y plus {}", settings.offset_y);
    if (settings.scale_y != 1.0) text += phrase(", y times {}", settings.scale_y);
    if (settings.table == CurveTable::profile || settings.table == CurveTable::section ||
        settings.table == CurveTable::flights)
        text += phrase("; step {}", curve.step);
    if (!curve.sweep) return text + phrase("; from {}", settings.file) + ".";
    return fmt::format("{};{} {}{}.", text, varied_text(*curve.sweep), seeds_text(*curve.sweep),
                       after(own));
}

std::string picture_sentence(const PicturePlan& picture, PanelKind kind, const std::string& own) {
    std::string steps = shown_by(kind) == PanelShows::whole_run
                            ? phrase("{} to {}", picture.steps.front(), picture.steps.back())
                            : fmt::format("{}", fmt::join(picture.steps, ", "));
    steps = picture.steps.size() == 1 ? phrase("step {}", steps) : phrase("steps {}", steps);
    return fmt::format("{}; {}{}.", steps, phrase("seed {}", picture.scene.seed), after(own));
}

std::string capitalized(std::string text) {
    const bool word = text.size() > 1 && text[1] != ' ';  // no symbol
    if (word && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

/// The runs that the panels and curves of a figure show, in their order.
std::vector<CaptionRun> runs_in_order(const FigurePlan& plan) {
    std::vector<CaptionRun> runs;
    for (const PanelPlan& panel : plan.panels) {
        if (panel.picture) runs.push_back({&panel.picture->scene, {}});
        if (panel.minus) runs.push_back({&panel.minus->scene, {}});
        for (const CurvePlan& curve : panel.curves) {
            if (curve.sweep) runs.push_back({&curve.scene, varied_keys(*curve.sweep)});
        }
    }
    return runs;
}

/// "(a): ", "(b) to (d): "; nothing where the figure has one panel only, which has no letter.
std::string heading(const FigurePlan& plan, std::size_t letter, std::size_t panels, bool inset) {
    if (inset) return letter == 0 ? "" : phrase("{}, inset: ", panel_letter(letter - 1));
    if (plan.panels.size() == 1 && panels == 1) return {};
    if (panels == 1) return panel_letter(letter) + ": ";
    return phrase("{} to {}: ", panel_letter(letter), panel_letter(letter + panels - 1));
}

}  // namespace

std::string figure_caption(const FigurePlan& plan,
                           const std::vector<std::vector<std::string>>& remarks) {
    std::string text;
    if (!plan.scene.title.empty()) text += plan.scene.title + ".\n";
    if (!plan.scene.figure.caption.empty()) text += plan.scene.figure.caption + "\n";
    const std::vector<CaptionRun> runs = runs_in_order(plan);
    const CaptionFacts facts(runs);
    if (const std::string shared = facts.shared(); !shared.empty())
        text += fmt::format("\n{}{}.\n", runs.size() > 1 ? word("All: ") : "", shared);
    std::size_t letter = 0;
    std::size_t run = 0;
    for (std::size_t p = 0; p < plan.panels.size(); ++p) {
        const PanelPlan& panel = plan.panels[p];
        const bool inset = panel.settings.inset != InsetCorner::none;
        const std::size_t panels = panels_of(panel);
        text += '\n';
        text += heading(plan, letter, panels, inset);
        if (!inset) letter += panels;
        const PanelKind kind = panel.settings.kind;
        if (panel.picture) text += picture_sentence(*panel.picture, kind, facts.own(run++)) + "\n";
        if (panel.minus)
            text += word("Minus ") + picture_sentence(*panel.minus, kind, facts.own(run++)) + "\n";
        std::size_t number = 0;
        for (const CurvePlan& curve : panel.curves) {
            const std::string own = curve.sweep ? facts.own(run++) : std::string();
            text += curve_sentence(curve, panel.settings.kind, ++number, own) + "\n";
        }
        for (const std::string& remark : remarks[p]) text += capitalized(remark) + ".\n";
        for (const RangeBoxSettings& box : panel.settings.boxes)
            text += fmt::format("{}: {}.\n", box.label, box.source);
    }
    for (const InputFile& input : plan.inputs)
        text += fmt::format("\n{}: SHA-256 {}.", input.path, input.hash);
    return fmt::format("{}\n{}{}{}{}.\n", text, own_caption_mark, plan.file, own_caption_maker,
                       FUMON_VERSION);
}

}  // namespace fumon
