#include "run/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <span>
#include <thread>
#include <utility>

#include "files/avalanche_table.h"
#include "scene/overlay_keys.h"
#include "scene/uses_metres.h"

namespace fumon {

namespace {

std::vector<std::string> gathered_columns(const Scene& scene, const Recording& recording) {
    return recording.plots ? plotted_columns(scene) : std::vector<std::string>{};
}

int threads_of(int asked) {
    return asked > 0 ? asked : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Where no table is written, what plots show is all that is measured.
MeasureSuite suite_for(const Scene& scene, const Snapshot& first, const Recording& recording) {
    MeasureChoice choice = recorded_measures(scene);
    const bool tabulates = recording.files && scene.output.measurements;
    if (!tabulates && recording.plots) choice.columns = plotted_columns(scene);
    return MeasureSuite(measured_landform(first), first, choice);
}

}  // namespace

MeasureChoice recorded_measures(const Scene& scene) {
    return {scene.output.channel_area, uses_metres(scene), recorded_columns(scene)};
}

Recorder::Recorder(const Scene& scene, const Snapshot& first, Recording recording,
                   const std::optional<RecordPositions>& previous)
    : suite_(suite_for(scene, first, recording)),
      plotted_(gathered_columns(scene, recording), suite_.columns(), first) {
    const bool writes = recording.files.has_value();
    const bool tabulates = writes && scene.output.measurements;
    measures_ = tabulates || !plotted_.rows().columns.empty();
    lists_avalanches_ = writes && scene.output.avalanches;
    if (measures_) {
        measured_ = measurement_schedule(scene);
        pool_.emplace(std::min(threads_of(recording.threads), suite_.most_threads()),
                      "fumon-measure");
    }
    if (writes) {
        fielded_ = fields_schedule(scene);
        paths_ = std::move(*recording.files);
        text_ = {scene.title, std::move(recording.resolved), scene.seed};
    }
    if (previous) {
        const RecordPositions& at = *previous;
        if (at.avalanches.length >= 0) avalanches_.emplace(paths_.avalanches, at.avalanches);
        if (at.measurements.length >= 0)
            measurements_.emplace(paths_.measurements, at.measurements);
        if (at.fields.records >= 0)
            fields_.emplace(paths_.fields, first, text_, at.fields, recording.longer);
        return;
    }
    if (!tabulates) return;
    measurements_.emplace(paths_.measurements);
    std::string header = "step,time";
    for (const MeasureColumn& column : suite_.columns()) header += "," + column.name;
    measurements_->write(header + "\n");
}

bool Recorder::wants(std::int64_t step) const {
    return measured_.due(step) || fielded_.due(step);
}

void Recorder::take(const SharedSnapshot& snapshot) {
    hand_over(snapshot);
}

void Recorder::after_step(const Model& model) {
    constexpr std::size_t most_held = 4096;  // between two snapshots that are far apart
    if (!measures_ && !lists_avalanches_) return;
    const std::span<const Avalanche> avalanches = model.avalanches();
    avalanches_since_.insert(avalanches_since_.end(), avalanches.begin(), avalanches.end());
    if (avalanches_since_.size() >= most_held) hand_over(nullptr);
}

void Recorder::hand_over(SharedSnapshot snapshot) {
    if (!snapshot && avalanches_since_.empty()) return;
    thread_.hand_over(
        [this, avalanches = std::exchange(avalanches_since_, {}), snapshot = std::move(snapshot)] {
            record(avalanches);
            if (snapshot) record(*snapshot);
        });
}

void Recorder::settle() {
    hand_over(nullptr);
    thread_.wait();
}

const MeasuredRows& Recorder::rows() {
    if (!plotted_.rows().columns.empty()) settle();
    return plotted_.rows();
}

void Recorder::record(std::span<const Avalanche> avalanches) {
    if (avalanches.empty()) return;
    if (measures_) suite_.note(avalanches);
    if (!lists_avalanches_) return;
    if (!avalanches_) avalanches_.emplace(paths_.avalanches);
    avalanches_->add(avalanches);
}

void Recorder::record(const Snapshot& snapshot) {
    if (measured_.due(snapshot.step)) measure(snapshot);
    if (fielded_.due(snapshot.step)) record_fields(snapshot);
}

void Recorder::measure(const Snapshot& snapshot) {
    const std::vector<double> row = suite_.row(snapshot, pool_ ? &*pool_ : nullptr);
    plotted_.take(snapshot, row);
    if (!measurements_) return;
    std::string line = fmt::format("{},{}", snapshot.step, snapshot.time);
    for (const double value : row) line += std::isnan(value) ? "," : fmt::format(",{}", value);
    measurements_->write(line + "\n");
}

void Recorder::record_fields(const Snapshot& snapshot) {
    if (!fields_) fields_.emplace(paths_.fields, snapshot, text_);
    fields_->add(snapshot);
}

RecordPositions Recorder::sync() {
    settle();
    RecordPositions at;
    if (measurements_) at.measurements = measurements_->sync();
    if (avalanches_) at.avalanches = avalanches_->sync();
    if (fields_) at.fields = fields_->sync();
    return at;
}

void Recorder::serialise(StateArchive& archive) {
    settle();
    suite_.serialise(archive);
    plotted_.serialise(archive);
}

void Recorder::commit() {
    std::exception_ptr first;
    try {
        settle();
    } catch (...) {
        first = std::current_exception();
    }
    const auto commit_one = [&](auto& file, bool& written) {
        if (!file) return;
        try {
            file->commit();
            written = true;
        } catch (...) {
            if (!first) first = std::current_exception();
        }
        file.reset();
    };
    commit_one(avalanches_, recorded_.avalanches);
    commit_one(fields_, recorded_.fields);
    commit_one(measurements_, recorded_.measurements);
    if (first) std::rethrow_exception(first);
}

}  // namespace fumon
