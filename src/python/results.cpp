#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "files/unit_conversion.h"
#include "film/beds/film_runs.h"
#include "film/beds/results_text.h"
#include "film/film_output.h"
#include "film/film_read.h"
#include "film/make_film.h"
#include "film/rule/film_rule.h"
#include "foreign/open_run.h"
#include "foreign/run_times.h"
#include "measure/suite.h"
#include "outputs/output_claims.h"
#include "python/arrays.h"
#include "python/drawer.h"
#include "python/live_run.h"
#include "python/module.h"
#include "python/records.h"
#include "run/terminal/interrupt.h"
#include "scene/overlay_keys.h"
#include "scene/scene_keys.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

/// The stored records of a run, for Python to keep. Any thread may call; one reads at a time.
/// Callers do not hold the interpreter's lock.
class Results {
  public:
    explicit Results(StoredBeds beds) : runs_(one(std::move(beds))) {
        drawer_ = std::make_shared<Drawer>(beds_of().scene(), beds_of().inputs(),
                                           std::make_shared<const Snapshot>(beds_of().first()),
                                           results_text(beds_of()));
    }

    [[nodiscard]] const StoredBeds& beds_of() const { return runs_.first(); }

    [[nodiscard]] Step record(std::size_t number) {
        const std::lock_guard lock(mutex_);
        process_.check();
        return {beds_of().snapshot(number), {}, {}, rows().at(number), drawer_};
    }

    /// The same, measured alone: celerities have no record before.
    [[nodiscard]] Step measured(std::size_t number) {
        Step step = record(number);
        const Scene& scene = beds_of().scene();
        MeasureSuite suite(measured_landform(*step.snapshot), *step.snapshot,
                           {scene.output.channel_area, step.snapshot->scale.in_metres});
        step.values = suite.row(*step.snapshot);
        step.columns = suite.columns();
        return step;
    }

    /// What was recognised of another model's run, which takes its ranges from all records.
    [[nodiscard]] std::string description() {
        const std::lock_guard lock(mutex_);
        process_.check();
        const ForeignRun* run = beds_of().foreign();
        return run == nullptr ? std::string() : foreign_description(*run);
    }

    /// Writes a film: of a film file, of one that ships or, where `script` is empty, by rule.
    MadeFilm film(const std::string& file, const std::string& script, const std::string& style,
                  double seconds, const std::vector<std::string>& settings) {
        const std::lock_guard lock(mutex_);
        process_.check();
        const InterruptGuard guard;
        const std::string name = script.empty() ? "film by rule" : script;
        FilmText text{film_by_rule_of(script, style, seconds), "fumon film RUN"};
        if (!script.empty()) text = film_text(film_file(script));
        const Film film = parse_film(text.text, name, settings);
        const FilmOutput output = film_outputs(film, file, {}, 0).front();
        WorkOptions work;
        work.verbosity = Verbosity::quiet;
        OutputClaims claims(true);
        claims.reads(runs_.files());
        claim_film(claims, output);
        StatusLine status(work.verbosity);
        return make_film(output, runs_, text.remake, work, status);
    }

  private:
    /// What plots over the pictures show up to each record; measuring them reads all records, once.
    const std::vector<MeasuredRows>& rows() {
        if (rows_.empty()) rows_ = beds_of().measurements(plotted_columns(beds_of().scene()));
        return rows_;
    }
    static FilmRuns one(StoredBeds beds) {
        std::vector<StoredBeds> all;
        all.push_back(std::move(beds));
        return FilmRuns(std::move(all));
    }
    [[nodiscard]] std::string film_by_rule_of(const std::string& script, const std::string& style,
                                              double seconds) const {
        if (!script.empty()) return {};
        return film_by_rule(runs_, {film_style(style), seconds}, beds_of().name());
    }

    FilmRuns runs_;
    std::mutex mutex_;
    Process process_;
    std::shared_ptr<Drawer> drawer_;
    std::vector<MeasuredRows> rows_;
};

py::dict film_of(Results& results, const std::string& file, const std::string& script,
                 const std::string& style, double seconds,
                 const std::vector<std::string>& settings) {
    MadeFilm made;
    {
        const py::gil_scoped_release unlocked;
        made = results.film(file, script, style, seconds, settings);
    }
    if (made.signal != 0) {
        clear_interrupt();
        PyErr_SetNone(PyExc_KeyboardInterrupt);
        throw py::error_already_set();
    }
    py::dict filmed;
    filmed["frames"] = made.frames;
    filmed["width"] = made.width;
    filmed["height"] = made.height;
    filmed["seconds"] = made.seconds;
    return filmed;
}

template <class Work>
auto unlocked(const Work& work) {
    const py::gil_scoped_release released;
    return work();
}

std::vector<double> times_of(const Results& results) {
    std::vector<double> times;
    for (const StoredBed& bed : results.beds_of().beds()) times.push_back(bed.time);
    return times;
}

std::vector<std::int64_t> steps_of(const Results& results) {
    std::vector<std::int64_t> steps;
    for (const StoredBed& bed : results.beds_of().beds()) steps.push_back(bed.step);
    return steps;
}

/// The dates of all records; none where the run has none.
std::vector<std::string> dates_of(const Results& results) {
    std::vector<std::string> dates;
    const ForeignRun* run = results.beds_of().foreign();
    if (run == nullptr || !run->times.date) return dates;
    for (const double time : run->times.times) dates.push_back(run->times.date(time));
    return dates;
}

/// (quantity, variable, unit in the file, reason) of each field of another model's run.
std::vector<std::tuple<std::string, std::string, std::string, std::string>> fields_of_results(
    const Results& results) {
    std::vector<std::tuple<std::string, std::string, std::string, std::string>> fields;
    const ForeignRun* run = results.beds_of().foreign();
    if (run == nullptr) return fields;
    for (const ForeignField& field : run->fields)
        fields.emplace_back(std::string(facts_of(field.quantity).key), field.name, field.unit,
                            field.reason);
    return fields;
}

/// Draws the states of a running model as they come, framed by the first.
class RecordPainter {
  public:
    using Planes = std::map<std::string, GridArray>;

    RecordPainter(const std::vector<std::string>& settings,
                  const std::optional<std::pair<double, double>>& cell_size, std::string unit,
                  const Planes& planes) {
        outline_.name = "film";
        outline_.title = " ";
        outline_.times.unit = unit.empty() ? "steps" : std::move(unit);
        if (cell_size)
            outline_.scale = {cell_size->first, cell_size->second, 1.0, true, std::nullopt};
        ForeignRun first = run_of(planes, 0, 0.0);
        outline_.nx = first.nx;
        outline_.ny = first.ny;
        const py::gil_scoped_release released;
        const StoredBeds beds = StoredBeds::of_records(std::move(first), settings);
        drawer_ = std::make_unique<Drawer>(beds.scene(), beds.inputs(),
                                           std::make_shared<const Snapshot>(beds.first()));
    }

    Drawing draw(const Planes& planes, std::int64_t step, double time) {
        const ForeignRun run = run_of(planes, step, time);
        const py::gil_scoped_release released;
        return drawer_->draw(std::make_shared<const Snapshot>(foreign_snapshot(run, 0)), {});
    }

  private:
    [[nodiscard]] ForeignRun run_of(const Planes& planes, std::int64_t step, double time) const {
        ForeignRun run = outline_;
        run.times.times = {time};
        run.times.steps = {step};
        for (const auto& [key, values] : planes) {
            const auto quantity = quantity_of_key(key);
            if (!quantity) throw InputError(fmt::format("unknown quantity \"{}\"", key));
            const auto grid = std::make_shared<const Grid>(grid_of(values));
            if (run.nx == 0) {
                run.nx = grid->nx();
                run.ny = grid->ny();
            }
            run.fields.push_back({*quantity, key, "", "", "an argument", true, false,
                                  [grid](std::size_t) { return *grid; }});
        }
        return run;
    }

    ForeignRun outline_;
    std::unique_ptr<Drawer> drawer_;
};

}  // namespace

void define_results(py::module_& core) {
    define_records(core);
    py::class_<Results>(core, "Results")
        .def(py::init([](const std::string& path, const std::vector<std::string>& fields,
                         const std::string& time_pattern, const std::string& time_unit,
                         double cell_size, const std::vector<std::string>& settings) {
                 const py::gil_scoped_release released;
                 return std::make_unique<Results>(StoredBeds::of_argument(
                     path, 0, settings, {fields, time_pattern, time_unit, cell_size}));
             }),
             py::arg("path"), py::arg("fields"), py::arg("time_pattern"), py::arg("time_unit"),
             py::arg("cell_size"), py::arg("settings"))
        .def_static(
            "of_records",
            [](const RecordSource& source, const std::vector<std::string>& settings) {
                ForeignRun run = source.run();
                const py::gil_scoped_release released;
                return std::make_unique<Results>(StoredBeds::of_records(std::move(run), settings));
            },
            py::arg("source"), py::arg("settings"))
        .def_property_readonly("name", [](const Results& one) { return one.beds_of().name(); })
        .def_property_readonly("times", &times_of)
        .def_property_readonly("time_unit",
                               [](const Results& one) { return one.beds_of().first().time_unit; })
        .def_property_readonly("steps", &steps_of)
        .def_property_readonly("dates", &dates_of)
        .def_property_readonly("fields", &fields_of_results)
        .def_property_readonly(
            "description", [](Results& one) { return unlocked([&] { return one.description(); }); })
        .def(
            "record",
            [](Results& one, std::size_t number) {
                return unlocked([&] { return std::make_shared<Step>(one.record(number)); });
            },
            py::arg("number"))
        .def(
            "measured",
            [](Results& one, std::size_t number) {
                return unlocked([&] { return std::make_shared<Step>(one.measured(number)); });
            },
            py::arg("number"))
        .def("film", &film_of, py::arg("file"), py::arg("script"), py::arg("style"),
             py::arg("seconds"), py::arg("settings"));
    py::class_<RecordPainter>(core, "RecordPainter")
        .def(py::init<const std::vector<std::string>&,
                      const std::optional<std::pair<double, double>>&, std::string,
                      const RecordPainter::Planes&>(),
             py::arg("settings"), py::arg("cell_size"), py::arg("time_unit"), py::arg("planes"))
        .def(
            "draw",
            [](RecordPainter& painter, const RecordPainter::Planes& planes, std::int64_t step,
               double time) { return drawn_of(painter.draw(planes, step, time)); },
            py::arg("planes"), py::arg("step"), py::arg("time"));
    core.def("colour_settings", &colour_settings, py::arg("colour"));
    core.def(
        "seconds_per_unit",
        [](const std::string& unit) -> std::optional<double> {
            const auto seconds = unit_conversion(unit, "s");
            if (!seconds) return std::nullopt;
            return seconds->factor;
        },
        py::arg("unit"));
}

}  // namespace fumon::python
