#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/grid.h"
#include "bmi/variables.h"
#include "keys/override.h"
#include "run/prepared_run.h"
#include "scene/read.h"

namespace fumon {

/// A scene's model between whose steps another program sets the bed and the scene's numbers. A
/// change builds the model anew from the changed scene and gives it the state that it had: it goes
/// on as if it had been built so, and nothing has changed where a value is refused.
class CoupledModel {
  public:
    /// Throws InputError as read_scene() and prepare_run().
    explicit CoupledModel(const std::string& scene_file);
    ~CoupledModel();
    CoupledModel(const CoupledModel&) = delete;
    CoupledModel& operator=(const CoupledModel&) = delete;

    /// One step, after what the uplift has raised meanwhile. Throws Error where the state is no
    /// longer finite.
    void step();

    [[nodiscard]] const Model& model() const { return *run_->model; }
    [[nodiscard]] const Scene& scene() const { return run_->scene; }
    [[nodiscard]] const Snapshot& now() const { return now_; }
    [[nodiscard]] const std::vector<Variable>& variables() const { return variables_; }
    /// In the model's unit of time: what a step from here on takes.
    double time_step();
    /// That of run.steps.
    double end_time();

    /// The values of a variable, in its unit, row 0 southernmost.
    [[nodiscard]] std::vector<double> values(const Variable& variable) const;
    /// Throws InputError where the model or the key's range does not allow them; of the uplift and
    /// the bed, where they are not finite or the model cannot take them.
    void set(const Variable& variable, const std::vector<double>& values);

  private:
    void rebuild(const std::vector<Override>& overrides, const Grid* bed);
    void set_bed(const std::vector<double>& metres);
    void set_parameter(const Variable& variable, double value);
    std::unique_ptr<PreparedRun> built(const Scene& scene, InitialBed initial) const;

    SceneText text_;
    std::vector<Override> overrides_;
    std::unique_ptr<PreparedRun> run_;
    std::vector<Variable> variables_;
    std::vector<double> uplift_;  ///< empty: none
    Snapshot now_;
};

}  // namespace fumon
