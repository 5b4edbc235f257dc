#include "paper/figure_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/find_named.h"
#include "base/nearest_name.h"
#include "drape/lay_drape.h"
#include "drape/lay_layers.h"
#include "figure/words/chosen_words.h"
#include "files/hash.h"
#include "files/input_file.h"
#include "foreign/foreign_run.h"
#include "keys/keys.h"
#include "paper/curve_rows.h"
#include "paper/figure_tables.h"
#include "paper/panel_look.h"
#include "paper/panel_makers.h"
#include "paper/panel_title.h"
#include "paper/store/results.h"
#include "picture/stills/cmyk.h"
#include "run/prepared_run.h"
#include "scene/input_maps.h"
#include "scene/overlay_keys.h"
#include "scene/placeholders.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

std::string without_colon(std::string place) {
    while (place.ends_with(' ') || place.ends_with(':')) place.pop_back();
    return place;
}

/// Reads one figure.
class Planner {
  public:
    Planner(FigurePlan& plan, FigureSources& sources, FigureRuns& runs, const RunStore* store)
        : plan_(plan),
          sources_(sources),
          runs_(runs),
          store_(store),
          text_(sources.scene(plan.file)) {
        plan_.scene = parse_scene(text_, read_settings(plan_.settings));
        if (plan_.scene.figure.panels.empty()) {
            throw InputError(
                fmt::format("{}: describes no figure; write [[figure.panel]] sections (`fumon "
                            "describe figure`)",
                            plan_.file));
        }
    }

    /// False when interrupted.
    bool read() {
        read_profile();
        const std::vector<PanelSettings>& panels = plan_.scene.figure.panels;
        for (std::size_t p = 0; p < panels.size(); ++p) {
            PanelPlan panel{panels[p], fmt::format("figure.panel.{}", p), {}, {}, {}};
            if (shown_by(panel.settings.kind) == PanelShows::curves) {
                for (std::size_t c = 0; c < panel.settings.curves.size(); ++c) {
                    CurveSettings& settings = panel.settings.curves[c];
                    if (panel.settings.kind == PanelKind::histogram) settings.x = settings.y;
                    auto curve = read_curve(settings, fmt::format("{}.curve.{}", panel.path, c));
                    if (!curve) return false;
                    panel.curves.push_back(std::move(*curve));
                }
                check_title(panel, plan_.scene, nullptr);
            } else {
                read_pictures(panel);
            }
            plan_.panels.push_back(std::move(panel));
        }
        return true;
    }

  private:
    [[noreturn]] void refuse(const std::string& key, const std::string& what) const {
        throw InputError(plan_.scene.at(key) + what);
    }

    /// Runs work() and gives the InputErrors that it throws a place.
    template <class Work>
    auto at(const std::string& key, const Work& work) const {
        try {
            return work();
        } catch (const InputError& refusal) {
            throw placed(plan_.scene.at(key), refusal);
        }
    }

    /// The text of another scene, or this one's.
    [[nodiscard]] SceneText scene_text(const std::string& other, const std::string& key) {
        if (other.empty()) return text_;
        const fs::path file = plan_.scene.directory / other;
        if (names_results(file)) {
            SceneText text = text_;
            text.text = scene_of_results(other);
            text.source = file.lexically_normal().string();
            return text;
        }
        return at(key, [&] { return sources_.scene(file); });
    }

    /// The changes to a panel's or curve's scene; --set changes the figure's own alone.
    [[nodiscard]] std::vector<Override> changes(const std::string& other,
                                                const std::vector<std::string>& set,
                                                const std::string& key) const {
        std::vector<Override> all;
        if (other.empty()) all = read_settings(plan_.settings);
        for (Override& change : read_settings(set, without_colon(plan_.scene.at(key))))
            all.push_back(std::move(change));
        return all;
    }

    /// The printer's inks of the figure's TIFF.
    void read_profile() {
        const std::string key = "figure.icc_profile";
        if (plan_.scene.figure.icc_profile.empty()) return;
        const std::string file = sources_.profile(plan_.scene);
        plan_.cmyk_profile = at(key, [&] { return read_input_file(file); });
        try {
            check_cmyk_profile(plan_.cmyk_profile);
        } catch (const InputError& fault) {
            refuse(key, fmt::format("{} {}", file, fault.what()));
        }
        plan_.inputs.push_back(sources_.as_first_named({file, hex(text_hash(plan_.cmyk_profile))}));
    }

    void note(const InitialBed& initial) {
        for (const InputFile& input : initial.inputs) {
            const InputFile named = sources_.as_first_named(input);
            if (find_by(plan_.inputs, &InputFile::path, named.path) == nullptr)
                plan_.inputs.push_back(named);
        }
        if (!initial.note.empty() &&
            std::find(plan_.notes.begin(), plan_.notes.end(), initial.note) == plan_.notes.end())
            plan_.notes.push_back(initial.note);
    }

    std::optional<CurvePlan> read_curve(const CurveSettings& settings, const std::string& path) {
        if (!settings.scene.empty() && names_results(plan_.scene.directory / settings.scene))
            return results_curve(settings, path);
        CurvePlan curve{settings, path, {}, {}, plan_.scene, 0, {}};
        if (settings.table == CurveTable::expression) return curve;
        if (settings.table == CurveTable::file) {
            curve.table = at(path + ".file", [&] {
                const SourceText& source = sources_.text(plan_.scene.directory / settings.file);
                Table table = parse_csv_table({source.path, source.text});
                refuse_infinities(table, settings, source.path);
                return table;
            });
        } else {
            curve.sweep = make_plan(request(settings, path));
            if (!curve.sweep) return std::nullopt;
            add_runs(curve);
        }
        check_columns(curve);
        return curve;
    }

    /// A curve of another model's results, which have one run.
    CurvePlan results_curve(const CurveSettings& settings, const std::string& path) {
        if (!settings.over.empty() || settings.seeds > 0)
            refuse(path + (settings.over.empty() ? ".seeds" : ".over"),
                   "results of other models are one run; leave it out");
        Scene scene = parse_scene(scene_text(settings.scene, path + ".scene"),
                                  changes(settings.scene, settings.set, path + ".set"));
        sources_.find_inputs(scene);
        const auto results = at(path + ".scene", [&] { return open_results(scene, "bed"); });
        PreparedScene prepared = prepare_results(std::move(scene), *results);
        note(prepared.initial);
        CurvePlan curve{settings, path, {}, {}, std::move(prepared.scene), 0, {}};
        curve.settings.file = settings.scene;  // as captions name what is drawn
        curve.step = settings.step < 0 ? results->times.steps.back() : settings.step;
        const char* asked = settings.table == CurveTable::profile ? ".step" : ".table";
        curve.table = at(path + asked, [&] {
            return results_table(settings.table, curve.scene, *results, curve.step);
        });
        check_columns(curve);
        return curve;
    }

    SweepRequest request(const CurveSettings& settings, const std::string& path) {
        const bool of_one_step = needs_fields(settings.table);
        const std::int64_t seeds = settings.seeds == 0 && of_one_step ? 1 : settings.seeds;
        SweepRequest request;
        request.scene = scene_text(settings.scene, path + ".scene");
        request.settings = changes(settings.scene, settings.set, path + ".set");
        if (seeds > 0) request.seeds = fmt::format("{}", seeds);
        const std::string place = without_colon(plan_.scene.at(path));
        const auto set = [&](const std::string& key, const std::string& value) {
            request.settings.push_back({key, value, place, 0});
        };
        set("output.measurements", "true");
        set("output.bed_every", "0");
        set("output.bed_at", "[]");
        Scene found = parse_scene(request.scene, request.settings);
        const std::string written = found.bed.file;
        sources_.find_inputs(found);
        if (found.bed.file != written) set("bed.file", found.bed.file);
        const bool varies_nothing = settings.over == std::vector<std::string>{"none"};
        if (varies_nothing || (of_one_step && settings.over.empty())) {
            set("sweep.over", "[]");
        } else if (!settings.over.empty()) {
            request.over = settings.over;
            request.over_place = without_colon(plan_.scene.at(path + ".over"));
        }
        request.finished = [this](const PreparedScene& prepared) {
            return outline_of(stored_run(prepared.scene, prepared.initial));
        };
        return request;
    }

    [[nodiscard]] std::optional<Snapshot> outline_of(const StoredRun& run) const {
        return store_ == nullptr ? std::nullopt : store_->outline(run);
    }

    /// A scene as its run takes it: with its bed file as it lies now, and its bed's size.
    InitialBed settle(Scene& scene) {
        sources_.find_inputs(scene);
        InitialBed initial = make_initial_bed(scene);
        add_maps(scene, initial);
        lay_drape(scene, initial);
        lay_layers(scene, initial);
        scene.grid.nx = initial.bed.nx();
        scene.grid.ny = initial.bed.ny();
        note(initial);
        return initial;
    }

    void add_runs(CurvePlan& curve) {
        const SweepPlan& plan = *curve.sweep;
        std::optional<InitialBed> initial;
        for (std::size_t k = 0; k < plan.runs.size(); ++k) {
            Scene scene = scene_of(plan, plan.runs[k]);
            if (k == 0 || plan.runs[k].combination != plan.runs[k - 1].combination)
                initial = settle(scene);
            sources_.find_inputs(scene);
            scene.grid.nx = initial->bed.nx();
            scene.grid.ny = initial->bed.ny();
            StoredRun run = stored_run(scene, *initial);
            run.label = fmt::format("{}: {}", plan.scene.source, run_label(plan, plan.runs[k]));
            if (k == 0) describe(curve, scene, *plan.first);
            if (needs_fields(curve.settings.table)) run.steps.insert(step_of(curve, scene));
            curve.runs.push_back(runs_.add(std::move(run)));
        }
        curve.step = step_of(curve, curve.scene);
        curve.sweep->first.reset();
    }

    static bool needs_fields(CurveTable table) {
        return table == CurveTable::profile || table == CurveTable::section ||
               table == CurveTable::flights;
    }

    [[nodiscard]] std::int64_t step_of(const CurvePlan& curve, const Scene& scene) const {
        const std::int64_t step = curve.settings.step;
        if (step > scene.run.steps) {
            refuse(curve.path + ".step",
                   fmt::format("step {} is after the run's end at {}", step, scene.run.steps));
        }
        return step < 0 ? scene.run.steps : step;
    }

    /// What is known of a curve's table before there is a run.
    void describe(CurvePlan& curve, const Scene& scene, const Snapshot& first) {
        curve.scene = scene;
        name_parameter_keys(curve.scene);
        const KeyTable keys = scene_keys(curve.scene);
        for (const std::string& key : varied_keys(*curve.sweep)) {
            const Key* known = keys.find(key);  // none of a list's item
            curve.table.columns.push_back({key, known != nullptr ? known->notes.unit : ""});
        }
        curve.table.columns.push_back({"seed"});
        const Table own = at(curve.path + ".table", [&] {
            try {
                return curve_columns(curve.settings.table, scene, first);
            } catch (const InputError& refusal) {
                throw InputError(
                    fmt::format("this table {}, not {}", refusal.what(), curve.scene.model.name));
            }
        });
        curve.table.columns.insert(curve.table.columns.end(), own.columns.begin(),
                                   own.columns.end());
    }

    void check_columns(const CurvePlan& curve) const {
        check_column(curve, curve.settings.x, curve.path + ".x");
        check_column(curve, curve.settings.y, curve.path + ".y");
        if (!curve.settings.z.empty()) check_column(curve, curve.settings.z, curve.path + ".z");
        if (!curve.settings.group_by.empty())
            check_column(curve, curve.settings.group_by, curve.path + ".group_by");
        for (const std::string& condition : curve.settings.where) {
            const std::size_t end = condition.find_first_of("=<>!");
            check_column(curve, condition.substr(0, end), curve.path + ".where");
        }
        at(curve.path + ".name", [&] {
            return fill_placeholders(curve.settings.name, [&](const std::string& name) {
                return curve.table.find(name) != nullptr ? std::optional<std::string>("")
                                                         : key_text(curve.scene, name);
            });
        });
    }

    void check_column(const CurvePlan& curve, const std::string& name,
                      const std::string& key) const {
        if (curve.table.find(name) != nullptr) return;
        refuse(key, fmt::format("there is no column \"{}\"; {}", name,
                                suggestion(name, curve.table.names())));
    }

    void read_pictures(PanelPlan& panel) {
        const PanelSettings& settings = panel.settings;
        Snapshot first;
        panel.picture = read_picture(panel, {settings.scene, settings.set, settings.steps}, first);
        if (settings.kind != PanelKind::difference) return;
        const ChartSettings& chart = settings.chart;
        RequestedRun minus{chart.minus_scene, chart.minus_set, settings.steps, "minus_"};
        if (minus.scene.empty()) {
            minus.scene = settings.scene;
            minus.set.insert(minus.set.begin(), settings.set.begin(), settings.set.end());
        }
        if (chart.minus_step >= 0) minus.steps = {chart.minus_step};
        Snapshot other;
        panel.minus = read_picture(panel, minus, other);
        if (same_ground(first, other)) return;
        refuse(panel.path + ".kind",
               fmt::format("the two beds differ in size: {} × {} and {} × {} cells", first.bed.nx(),
                           first.bed.ny(), other.bed.nx(), other.bed.ny()));
    }

    /// A run whose pictures a panel shows; `prefix` of its keys in the panel.
    struct RequestedRun {
        std::string scene;
        std::vector<std::string> set;
        std::vector<std::int64_t> steps;
        std::string prefix{};
    };

    PicturePlan read_picture(const PanelPlan& panel, const RequestedRun& asked, Snapshot& first) {
        const PanelSettings& settings = panel.settings;
        const std::string path = panel.path + "." + asked.prefix;
        Scene scene = parse_scene(scene_text(asked.scene, path + "scene"),
                                  changes(asked.scene, asked.set, path + "set"));
        sources_.find_inputs(scene);
        std::shared_ptr<const ForeignRun> results;
        if (!asked.scene.empty() && names_results(plan_.scene.directory / asked.scene))
            results = at(path + "scene", [&] { return open_results(scene, settings.field); });
        PreparedScene prepared =
            results ? prepare_results(std::move(scene), *results) : prepare_scene(std::move(scene));
        note(prepared.initial);
        PicturePlan picture{prepared.scene, 0, asked.steps};
        StoredRun run = results ? stored_results(prepared, results)
                                : stored_run(prepared.scene, prepared.initial);
        run.label = fmt::format("{}: seed {}", picture.scene.source, picture.scene.seed);
        run.steps.insert(0);  // what holds still over a run is taken from its start
        first = first_of(std::move(prepared), run);
        const std::int64_t last = picture.scene.run.steps;
        if (shown_by(settings.kind) == PanelShows::whole_run) {
            const std::int64_t every =
                settings.every > 0 ? settings.every : std::max<std::int64_t>(1, last / 200);
            picture.steps.clear();
            if (results) picture.steps = steps_of_results(*results, settings.every);
            for (std::int64_t step = 0; step <= last && !results; step += every)
                picture.steps.push_back(step);
        }
        if (picture.steps.empty()) picture.steps = {last};
        for (const std::int64_t step : picture.steps) {
            if (step > last) {
                refuse(path + (asked.prefix.empty() ? "steps" : "step"),
                       fmt::format("step {} is after the run's end at {}", step, last));
            }
            if (results)
                at(path + (asked.prefix.empty() ? "steps" : "step"),
                   [&] { return snapshot_of_results(*results, step); });
        }
        check_picture(panel, picture.scene, first);
        run.steps.insert(picture.steps.begin(), picture.steps.end());
        picture.run = runs_.add(std::move(run));
        return picture;
    }

    /// The first snapshot of a run, checked to have what its scene shows.
    [[nodiscard]] Snapshot first_of(PreparedScene prepared, const StoredRun& run) const {
        if (!run.results && (store_ == nullptr || !store_->holds(run)))
            return prepare_run(std::move(prepared), 1).model->snapshot();
        Snapshot first =
            run.results ? snapshot_of_results(*run.results, 0) : store_->snapshot(run, 0);
        check_shown(prepared.scene, first);
        return first;
    }

    void check_picture(const PanelPlan& panel, const Scene& scene, const Snapshot& first) const {
        const PanelSettings& settings = panel.settings;
        try {
            const auto check = maker_of(settings.kind).check;
            if (check != nullptr) check(settings, scene, first);
        } catch (const KeyError& fault) {
            refuse(fmt::format("{}.{}", panel.path, fault.key()), fault.what());
        }
        std::vector<std::string> fields{"bed", "change"};
        for (const SnapshotField& field : first.fields) fields.push_back(field.name);
        if (std::find(fields.begin(), fields.end(), settings.field) == fields.end()) {
            refuse(panel.path + ".field",
                   fmt::format("the model {} has no field \"{}\"; {}", scene.model.name,
                               settings.field, suggestion(settings.field, fields)));
        }
        if (!settings.row_of_bed.is_word() && settings.row_of_bed.value >= first.bed.ny()) {
            refuse(panel.path + ".row_of_bed",
                   fmt::format("the bed has {} rows; count them from 0", first.bed.ny()));
        }
        check_title(panel, scene, &first);
    }

    void check_title(const PanelPlan& panel, const Scene& scene, const Snapshot* first) const {
        at(panel.path + ".title", [&] { return panel_title(panel.settings, scene, first); });
    }

    FigurePlan& plan_;
    FigureSources& sources_;
    FigureRuns& runs_;
    const RunStore* store_;
    SceneText text_;
};

/// The words in which a figure is written.
void choose_words(FigurePlan& plan, FigureSources& sources) {
    const std::string& own = plan.scene.figure.words;
    try {
        const std::string text =
            own.empty() ? std::string() : sources.text(plan.scene.directory / own).text;
        plan.words = figure_words(plan.scene, text);
    } catch (const KeyError& fault) {
        throw InputError(plan.scene.at(fault.key()) + fault.what());
    }
}

}  // namespace

std::optional<FigurePlan> plan_figure(const std::string& file,
                                      const std::vector<std::string>& settings,
                                      FigureSources& sources, FigureRuns& runs,
                                      const RunStore* store) {
    FigurePlan plan;
    plan.file = fs::path(file).lexically_normal().string();
    plan.name = fs::path(file).stem().string();
    plan.settings = settings;
    if (!Planner(plan, sources, runs, store).read()) return std::nullopt;
    choose_words(plan, sources);
    return plan;
}

std::vector<std::size_t> runs_of(const FigurePlan& plan) {
    std::set<std::size_t> all;
    for (const PanelPlan& panel : plan.panels) {
        if (panel.picture) all.insert(panel.picture->run);
        if (panel.minus) all.insert(panel.minus->run);
        for (const CurvePlan& curve : panel.curves)
            all.insert(curve.runs.begin(), curve.runs.end());
    }
    return {all.begin(), all.end()};
}

std::size_t panels_of(const PanelPlan& panel) {
    const bool one_each = shown_by(panel.settings.kind) == PanelShows::each_step &&
                          panel.settings.inset == InsetCorner::none;
    return one_each ? panel.picture->steps.size() : 1;
}

}  // namespace fumon
