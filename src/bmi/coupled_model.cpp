#include "bmi/coupled_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "base/error.h"
#include "base/find_named.h"
#include "bmi/saved_state.h"
#include "models/shared/check_finite.h"
#include "scene/scene_keys.h"

namespace fumon {

namespace {

/// What models call the heights of their bed among what they carry.
constexpr std::array<std::string_view, 3> bed_states{"bed", "surface", "pile_cells"};

constexpr const char* interface_place = "SetValue";

}  // namespace

CoupledModel::CoupledModel(const std::string& scene_file)
    : text_(read_scene_text(scene_file)), run_(nullptr) {
    run_ = std::make_unique<PreparedRun>(prepare_run(parse_scene(text_, overrides_), 0));
    now_ = run_->model->snapshot();
    variables_ = variables_of(run_->scene, now_);
}

CoupledModel::~CoupledModel() = default;

void CoupledModel::step() {
    if (!uplift_.empty()) {
        std::vector<double> raised = values(variables_.front());
        const double time = time_step();
        for (std::size_t i = 0; i < raised.size(); ++i) raised[i] += time * uplift_[i];
        set_bed(raised);
    }
    run_->model->step();
    now_ = run_->model->snapshot();
    check_finite(now_);
}

double CoupledModel::time_step() {
    // Winds may make steps of their own length: what the next one takes, only the model knows.
    std::unique_ptr<PreparedRun> trial = built(run_->scene, run_->initial);
    SavedState(*run_->model).restore(*trial->model);
    trial->model->step();
    return trial->model->time() - run_->model->time();
}

double CoupledModel::end_time() {
    const auto left = static_cast<double>(run_->scene.run.steps - run_->model->steps_done());
    return run_->model->time() + left * time_step();
}

std::vector<double> CoupledModel::values(const Variable& variable) const {
    switch (variable.kind) {
        case VariableKind::bed: {
            std::vector<double> heights(now_.bed.values().begin(), now_.bed.values().end());
            for (double& height : heights) height *= now_.scale.height_unit;
            return heights;
        }
        case VariableKind::uplift:
            return uplift_.empty() ? std::vector<double>(now_.bed.size()) : uplift_;
        case VariableKind::field: {
            const SnapshotField* field = find_named(now_.fields, variable.source);
            if (field == nullptr) return std::vector<double>(now_.bed.size());
            return {field->values.values().begin(), field->values.values().end()};
        }
        case VariableKind::parameter:
            break;
    }
    Scene copy = run_->scene;
    const KeyTable table = scene_keys(copy);
    const Key* key = table.find(variable.source);
    return {*std::get<double*>(key->target)};
}

void CoupledModel::set(const Variable& variable, const std::vector<double>& values) {
    if (!variable.input)
        throw InputError(
            fmt::format("{} is an output of the model and cannot be set", variable.name));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
            throw InputError(fmt::format("{}: value {} is not finite", variable.name, i));
    }
    if (variable.kind == VariableKind::parameter) return set_parameter(variable, values.front());
    if (variable.kind == VariableKind::bed) return set_bed(values);
    const bool none = std::ranges::all_of(values, [](double rate) { return rate == 0.0; });
    uplift_ = none ? std::vector<double>{} : values;
}

void CoupledModel::set_bed(const std::vector<double>& metres) {
    Grid bed = now_.bed;
    for (std::size_t i = 0; i < metres.size(); ++i)
        bed.values()[i] = metres[i] / now_.scale.height_unit;
    rebuild(overrides_, &bed);
}

void CoupledModel::set_parameter(const Variable& variable, double value) {
    std::vector<Override> all = overrides_;
    std::erase_if(all, [&](const Override& one) { return one.path == variable.source; });
    all.push_back({variable.source, fmt::format("{}", value), interface_place});
    rebuild(all, nullptr);
}

std::unique_ptr<PreparedRun> CoupledModel::built(const Scene& scene, InitialBed initial) const {
    return std::make_unique<PreparedRun>(prepare_run(PreparedScene{scene, std::move(initial)}, 0));
}

void CoupledModel::rebuild(const std::vector<Override>& overrides, const Grid* bed) {
    InitialBed initial = run_->initial;
    if (bed != nullptr) initial.bed = *bed;
    std::unique_ptr<PreparedRun> next = built(parse_scene(text_, overrides), std::move(initial));
    SavedState state(*run_->model);
    if (bed != nullptr) {
        const SavedState fresh(*next->model);
        for (const std::string_view name : bed_states) state.take(name, fresh);
    }
    state.restore(*next->model);
    run_ = std::move(next);
    overrides_ = overrides;
    now_ = run_->model->snapshot();
}

}  // namespace fumon
