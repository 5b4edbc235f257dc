#include "bmi/component.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "run/inputs/scene_argument.h"

namespace fumon {

namespace {

constexpr int raster = 0;
constexpr int scalar = 1;

std::vector<std::string> names_of(const std::vector<Variable>& variables, bool Variable::*kind) {
    std::vector<std::string> names;
    for (const Variable& one : variables) {
        if (one.*kind) names.push_back(one.name);
    }
    return names;
}

}  // namespace

CoupledModel& BmiComponent::model() {
    if (!model_)
        throw InputError("the component is not initialised; call initialize with a scene file");
    return *model_;
}

const Variable& BmiComponent::variable(const std::string& name) {
    const std::vector<Variable>& all = model().variables();
    const auto found = std::ranges::find(all, name, &Variable::name);
    if (found != all.end()) return *found;
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const Variable& one : all) names.push_back(one.name);
    throw InputError(fmt::format("{} has no variable {}; {}", model().scene().model.name, name,
                                 suggestion(name, names)));
}

void BmiComponent::Initialize(std::string config_file) {
    auto next = std::make_unique<CoupledModel>(scene_argument(config_file));
    Finalize();
    model_ = std::move(next);
}

void BmiComponent::Update() {
    model().step();
    refresh();
}

void BmiComponent::UpdateUntil(double time) {
    const double now = model().model().time();
    if (time < now) {
        throw InputError(fmt::format(
            "update_until {}: the model is already at {} and cannot go back", time, now));
    }
    double step = model().time_step();
    if (!(step > 0.0)) throw InputError("the model has no time; use update");
    while (model().model().time() + 0.5 * step <= time) {
        const double before = model().model().time();
        Update();
        step = model().model().time() - before;
    }
}

void BmiComponent::Finalize() {
    model_.reset();
    for (auto& [name, values] : shown_) previous_.push_back(std::move(values));
    shown_.clear();
}

std::string BmiComponent::GetComponentName() {
    return "fumon " + std::string(model().model().name());
}

int BmiComponent::GetInputItemCount() {
    return static_cast<int>(GetInputVarNames().size());
}

int BmiComponent::GetOutputItemCount() {
    return static_cast<int>(GetOutputVarNames().size());
}

std::vector<std::string> BmiComponent::GetInputVarNames() {
    return names_of(model().variables(), &Variable::input);
}

std::vector<std::string> BmiComponent::GetOutputVarNames() {
    return names_of(model().variables(), &Variable::output);
}

int BmiComponent::GetVarGrid(std::string name) {
    return variable(name).on_grid() ? raster : scalar;
}

std::string BmiComponent::GetVarType(std::string name) {
    static_cast<void>(variable(name));
    return "double";
}

std::string BmiComponent::GetVarUnits(std::string name) {
    return variable(name).unit;
}

int BmiComponent::GetVarItemsize(std::string name) {
    static_cast<void>(variable(name));
    return sizeof(double);
}

int BmiComponent::items(const std::string& name) {
    return variable(name).on_grid() ? static_cast<int>(model().now().bed.size()) : 1;
}

int BmiComponent::GetVarNbytes(std::string name) {
    return items(name) * GetVarItemsize(name);
}

std::string BmiComponent::GetVarLocation(std::string name) {
    static_cast<void>(variable(name));
    return "node";
}

double BmiComponent::GetCurrentTime() {
    return model().model().time();
}

double BmiComponent::GetStartTime() {
    static_cast<void>(model());
    return 0.0;
}

double BmiComponent::GetEndTime() {
    return model().end_time();
}

std::string BmiComponent::GetTimeUnits() {
    const std::string unit(model().model().time_unit());
    return is_counted(unit) ? "1" : unit;
}

double BmiComponent::GetTimeStep() {
    return model().time_step();
}

void BmiComponent::GetValue(std::string name, void* dest) {
    std::ranges::copy(model().values(variable(name)), static_cast<double*>(dest));
}

void* BmiComponent::GetValuePtr(std::string name) {
    std::vector<double>& shown = shown_[variable(name).name];
    if (shown.empty()) shown = model().values(variable(name));
    return shown.data();
}

void BmiComponent::GetValueAtIndices(std::string name, void* dest, int* inds, int count) {
    const std::vector<double> values = model().values(variable(name));
    for (int i = 0; i < count; ++i) {
        if (inds[i] < 0 || inds[i] >= static_cast<int>(values.size()))
            throw InputError(fmt::format("{} has {} values; index {} is out of range", name,
                                         values.size(), inds[i]));
        static_cast<double*>(dest)[i] = values[static_cast<std::size_t>(inds[i])];
    }
}

void BmiComponent::SetValue(std::string name, void* src) {
    const auto* first = static_cast<const double*>(src);
    model().set(variable(name), {first, first + items(name)});
    refresh();
}

void BmiComponent::SetValueAtIndices(std::string name, int* inds, int count, void* src) {
    std::vector<double> values = model().values(variable(name));
    for (int i = 0; i < count; ++i) {
        if (inds[i] < 0 || inds[i] >= static_cast<int>(values.size()))
            throw InputError(fmt::format("{} has {} values; index {} is out of range", name,
                                         values.size(), inds[i]));
        values[static_cast<std::size_t>(inds[i])] = static_cast<const double*>(src)[i];
    }
    model().set(variable(name), values);
    refresh();
}

void BmiComponent::refresh() {
    for (auto& [name, values] : shown_)
        std::ranges::copy(model().values(variable(name)), values.begin());
}

}  // namespace fumon
