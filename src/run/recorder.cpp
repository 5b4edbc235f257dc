#include "run/recorder.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <utility>

#include "files/avalanche_table.h"
#include "scene/overlay_keys.h"

namespace fumon {

namespace {

/// What plots show, where there are frames to show them.
std::vector<std::string> kept_columns(const Scene& scene) {
    if (!scene.output.frames && !scene.output.movie) return {};
    return plotted_columns(scene);
}

bool measures(const Scene& scene) {
    return scene.output.measurements || !kept_columns(scene).empty();
}

MeasureSuite suite_for(const Snapshot& first) {
    return MeasureSuite(measured_landform(first), first);
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Snapshot& first, std::string resolved,
                   RecordPaths paths, const std::optional<RecordPositions>& former)
    : scene_(scene),
      resolved_(std::move(resolved)),
      paths_(std::move(paths)),
      measured_(measures(scene) ? measurement_schedule(scene) : Schedule{}),
      fielded_(fields_schedule(scene)),
      suite_(suite_for(first)),
      plotted_(kept_columns(scene), suite_.columns(), first) {
    if (former) {
        const RecordPositions& at = *former;
        if (at.avalanches >= 0) avalanches_.emplace(paths_.avalanches, at.avalanches);
        if (at.measurements >= 0) measurements_.emplace(paths_.measurements, at.measurements);
        if (at.fields >= 0) fields_.emplace(paths_.fields, first, fields_text(), at.fields);
        return;
    }
    if (!scene.output.measurements) return;
    measurements_.emplace(paths_.measurements);
    std::string header = "step,time";
    for (const MeasureColumn& column : suite_.columns()) header += "," + column.name;
    measurements_->write(header + "\n");
}

bool Recorder::due(std::int64_t step) const {
    return measured_.due(step) || fielded_.due(step);
}

void Recorder::record(const Snapshot& snapshot) {
    if (measured_.due(snapshot.step)) measure(snapshot);
    if (fielded_.due(snapshot.step)) record_fields(snapshot);
}

void Recorder::note(std::span<const Avalanche> avalanches) {
    if (avalanches.empty()) return;
    if (measures(scene_)) suite_.note(avalanches);
    if (!scene_.output.avalanches) return;
    if (!avalanches_) avalanches_.emplace(paths_.avalanches);
    avalanches_->add(avalanches);
}

void Recorder::measure(const Snapshot& snapshot) {
    const std::vector<double> row = suite_.row(snapshot);
    plotted_.take(snapshot, row);
    if (!measurements_) return;
    std::string line = fmt::format("{},{}", snapshot.step, snapshot.time);
    for (const double value : row) line += std::isnan(value) ? "," : fmt::format(",{}", value);
    measurements_->write(line + "\n");
}

void Recorder::record_fields(const Snapshot& snapshot) {
    if (!fields_) {
        fields_.emplace(paths_.fields, snapshot, fields_text());
    }
    fields_->add(snapshot);
}

RecordPositions Recorder::sync() {
    RecordPositions at;
    if (measurements_) {
        measurements_->sync();
        at.measurements = measurements_->length();
    }
    if (avalanches_) at.avalanches = avalanches_->sync();
    if (fields_) {
        fields_->sync();
        at.fields = fields_->records();
    }
    return at;
}

void Recorder::commit() {
    std::exception_ptr first;
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
