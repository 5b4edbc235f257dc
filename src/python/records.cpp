#include "python/records.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "foreign/field_choice.h"
#include "foreign/run_times.h"
#include "python/arrays.h"

namespace fumon::python {

namespace {

namespace py = pybind11;

Quantity quantity_of(const std::string& key) {
    if (const auto quantity = quantity_of_key(key)) return *quantity;
    throw InputError(fmt::format("unknown quantity \"{}\"; it takes {}", key, quantity_keys()));
}

/// A function of Python that any thread may drop.
std::shared_ptr<py::function> kept(const py::function& function) {
    return {new py::function(function), [](py::function* one) {
                const py::gil_scoped_acquire locked;
                delete one;
            }};
}

/// A variable of a dataset, as (name, dimensions, standard name, unit, positive, over time).
using Described = std::tuple<std::string, std::string, std::string, std::string, std::string, bool>;

/// (quantity, variable, factor, offset to fumon's unit, reason).
using Recognised = std::tuple<std::string, std::string, double, double, std::string>;

/// Which variable is which quantity, the model and the least depth of water.
std::tuple<std::vector<Recognised>, std::string, double> recognise(
    const std::string& name, const std::string& words, const std::vector<Described>& variables,
    const std::map<std::string, std::string>& named) {
    std::vector<ForeignMap> maps;
    for (const auto& [variable, dimensions, standard_name, unit, positive, over_time] : variables) {
        ForeignMap map;
        map.variable.name = map.known_as = variable;
        map.dimensions = dimensions;
        map.standard_name = standard_name;
        map.unit = unit;
        map.positive = positive;
        map.over_time = over_time;
        maps.push_back(std::move(map));
    }
    std::map<Quantity, std::string> wanted;
    for (const auto& [key, variable] : named) wanted[quantity_of(key)] = variable;
    const ForeignModel* model = model_of_maps(words, maps);
    std::vector<Recognised> found;
    for (const ChosenMap& one : choose_maps(name, maps, model, wanted, false)) {
        const UnitConversion conversion = conversion_of(name, one);
        found.emplace_back(std::string(facts_of(one.quantity).key), one.map.variable.name,
                           conversion.factor, conversion.offset, one.reason);
    }
    const bool known = model != nullptr && model->name != "others";
    return {std::move(found), known ? model->name : "", model == nullptr ? 0.0 : model->dry};
}

/// West, south, dx, dy, whether these are degrees, and the reference system.
using PlaceTuple = std::tuple<double, double, double, double, bool, std::string>;

/// By what a reader of a field goes, beside those of quantities: "field tau".
std::string scalar_key(const std::string& name) {
    return "field " + name;
}

RecordSource record_source(
    const std::string& name, const std::string& model, double dry, std::pair<int, int> shape,
    const std::optional<std::pair<double, double>>& cell_size,
    const std::optional<PlaceTuple>& place, std::vector<double> times, bool counted,
    std::optional<std::int64_t> origin, const std::map<std::string, py::function>& readers,
    const std::map<std::string, bool>& changes,
    const std::map<std::string, std::pair<std::string, std::string>>& scalars) {
    ForeignRun run;
    run.name = run.title = name;
    run.model = model;
    run.dry = dry;
    run.ny = shape.first;
    run.nx = shape.second;
    if (cell_size) run.scale = {cell_size->first, cell_size->second, 1.0, true, std::nullopt};
    if (place) {
        const auto& [west, south, dx, dy, degrees, crs] = *place;
        run.scale.place = GeoReference{west, south, dx, dy, degrees, crs};
    }
    RawTimes raw;
    raw.values = std::move(times);
    raw.counted = counted;
    raw.origin = origin;
    run.times = run_times(raw, name);
    for (const auto& [key, words] : scalars)
        run.scalars.push_back({key, words.first, words.second, changes.at(scalar_key(key)), {}});
    for (const auto& [key, reader] : readers) {
        if (key.starts_with(scalar_key(""))) continue;
        run.fields.push_back(
            {quantity_of(key), key, "", "", "an argument", changes.at(key), false, {}});
    }
    return {std::move(run), readers};
}

}  // namespace

RecordSource::RecordSource(ForeignRun outline, std::map<std::string, py::function> readers)
    : outline_(std::move(outline)), readers_(std::move(readers)) {}

ForeignRun RecordSource::run() const {
    ForeignRun run = outline_;
    const auto reading = [&](const std::string& name) {
        return [reader = kept(readers_.at(name))](std::size_t record) {
            const py::gil_scoped_acquire locked;
            return grid_of((*reader)(record).cast<GridArray>());
        };
    };
    for (ForeignField& field : run.fields) field.read = reading(field.name);
    for (ForeignScalar& scalar : run.scalars) scalar.read = reading(scalar_key(scalar.name));
    return run;
}

void define_records(py::module_& core) {
    core.def("recognise", &recognise, py::arg("name"), py::arg("words"), py::arg("variables"),
             py::arg("named"));
    py::class_<RecordSource>(core, "RecordSource")
        .def(py::init(&record_source), py::arg("name"), py::arg("model"), py::arg("dry"),
             py::arg("shape"), py::arg("cell_size"), py::arg("place"), py::arg("times"),
             py::arg("counted"), py::arg("origin"), py::arg("readers"), py::arg("changes"),
             py::arg("scalars"));
}

}  // namespace fumon::python
